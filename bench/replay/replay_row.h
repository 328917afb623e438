#pragma once

#include <cstdint>
#include <optional>

#include "ar3d/bench/plan/plan.h"
#include "ar3d/records/run_record.h"

namespace ar3d {

/// The plan of one recorded row: its instance with this single run.
/// @throws InputError naming an unknown family, algorithm, parameter or option.
PlannedInstance plan_of_row(const RunRecord& row);

/// The seed of the study that the rows are of, from its specification; nothing if that cannot be
/// read any more.
std::optional<std::uint64_t> study_seed(const StudyIdentity& identity);

/// Makes a recorded row again: generates, draws, certifies. differing_columns(row, replayed(row))
/// is empty if nothing but measurements changed.
/// @param study_seed  given: the row's key and its graph's seed are made from it again; else they
/// are taken from the row. @throws InputError as plan_of_row.
RunRecord replayed(const RunRecord& row, const std::optional<std::uint64_t>& study_seed = {});

}  // namespace ar3d
