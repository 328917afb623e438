#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "ar3d/bench/spec/study_spec.h"
#include "ar3d/formats/text/output.h"
#include "ar3d/store/run_storage.h"

namespace ar3d {

/// Holds how it went.
struct KeptOutcome {
  std::size_t kept = 0;
  std::vector<std::string> problems;  ///< a line for each drawing that could not be kept
};

/// Draws the rows again whose drawings are kept (of the metrics phase, one per drawing: graph,
/// algorithm, options), one at a time, and writes each drawing as a line of JSON, in the order of
/// the rows. A drawing is kept only if its hash is its row's.
/// worst: of each algorithm with options on a family with parameters the row with the largest share
/// of the theorem's bound on an axis; where there is no bound, with the largest miss of an angle,
/// and where there is none, with the largest volume. Of equal rows the first one.
/// Memory: 64 bytes per row kept, and the curves.
/// @throws InputError if the file cannot be written; as corpora_of, before anything is drawn, if a
/// file of graphs is no longer what the study began with.
KeptOutcome write_kept_drawings(const RowView& rows, KeptDrawings kept, OutputFile& file);

}  // namespace ar3d
