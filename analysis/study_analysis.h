#pragma once

#include <vector>

#include "ar3d/analysis/bounds_table.h"
#include "ar3d/analysis/check.h"
#include "ar3d/analysis/scaling.h"
#include "ar3d/analysis/tally.h"

namespace ar3d {

/// Everything that report and exports show of a study, computed once. `rows` outlives it.
struct StudyAnalysis {
  RowView rows;
  CheckVerdict verdict;
  StudyTally tally;
  std::vector<BoundsEntry> bounds;
  std::vector<ScalingEntry> scaling;
};

/// Reads every row again. @param examination  of these rows. Cost: that of tally_of, bounds_table
/// and scaling.
StudyAnalysis analyse(const RowView& rows, CheckedRows examination);
/// With examine(rows).
StudyAnalysis analyse(const RowView& rows);

}  // namespace ar3d
