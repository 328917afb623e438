#pragma once

#include "ar3d/bench/plan.h"
#include "ar3d/results/run.h"

namespace ar3d {

/// The plan of one recorded row: its instance with this single run.
/// @throws InputError naming an unknown family, algorithm, parameter or option.
PlannedInstance plan_of_row(const Run& row);

/// Makes a recorded row again: generates, draws, certifies. differing_columns(row, replayed(row))
/// is empty if nothing but measurements changed. @throws InputError as plan_of_row.
Run replayed(const Run& row);

}  // namespace ar3d
