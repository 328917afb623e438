#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "ar3d/bench/spec/study_spec.h"
#include "ar3d/formats/text/output.h"
#include "ar3d/store/columns/run_record.h"
#include "ar3d/store/study_identity.h"

namespace ar3d {

/// Rows of a results file, read one at a time.
struct ReadableRows {
  std::size_t count = 0;
  std::function<RunRecord(std::size_t)> read;
};

/// The rows whose drawings are kept, ascending: of the metrics phase, one per drawing (graph,
/// algorithm, options).
/// worst: of each algorithm with options on a family with parameters the row with the largest share
/// of the theorem's bound on an axis; where there is no bound, with the largest miss of an angle,
/// and where there is none, with the largest volume. Of equal rows the first one.
/// Memory: 64 bytes per row kept, and the curves.
std::vector<std::size_t> rows_to_keep(const ReadableRows& rows, KeptDrawings kept);

/// How it went.
struct KeptOutcome {
  std::size_t kept = 0;
  std::vector<std::string> problems;  ///< a line for each drawing that could not be kept
};

/// Draws those rows again, one at a time, and writes each drawing as a line of JSON, in the order
/// of the rows. A drawing is kept only if its hash is its row's.
/// @throws InputError if the file cannot be written; as corpora_of, before anything is drawn, if a
/// file of graphs is no longer what the study began with.
KeptOutcome write_kept_drawings(const ReadableRows& rows, const StudyIdentity& study,
                                KeptDrawings kept, OutputFile& file);

}  // namespace ar3d
