#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "ar3d/bench/plan/plan.h"
#include "ar3d/store/columns/run_record.h"

namespace ar3d {

/// What rows were made of besides what they say themselves.
struct StudyOrigin {
  /// Of the study. Given: a row's key and its graph's seed are made from it again; else they are
  /// taken from the row.
  std::optional<std::uint64_t> seed = {};
  std::optional<StudySpec> spec = {};  ///< with the files that it began with
  std::string moved_graphs = {};  ///< where the file of a row's graph is now; empty: where it was
};

/// The origin of a study's rows, from its specification; nothing if that cannot be read any more.
StudyOrigin study_origin(const StudyIdentity& identity);

/// The plan of one recorded row: its instance with this single run.
/// @throws InputError naming an unknown family, algorithm, parameter or option; as corpora_of if
/// the graph is of a file.
PlannedInstance plan_of_row(const RunRecord& row, const StudyOrigin& origin = {});

/// The drawing of a recorded row, drawn again. @throws InputError as plan_of_row.
Drawing redrawn(const RunRecord& row, const StudyOrigin& origin = {});

/// Makes a recorded row again: generates, draws, certifies. differing_columns(row, replayed(row))
/// is empty if nothing but measurements changed.
/// @throws InputError as plan_of_row.
RunRecord replayed(const RunRecord& row, const StudyOrigin& origin = {});

}  // namespace ar3d
