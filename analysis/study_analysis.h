#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ar3d/analysis/check.h"
#include "ar3d/analysis/scaling.h"
#include "ar3d/analysis/tally.h"

namespace ar3d {

/// Describes the bounds table of one curve: what the theorem promises beside what was measured.
struct BoundsEntry : CurveCounts {
  std::int64_t volume_n = -1;     ///< the largest n that was drawn: volumes are of its graphs
  double log2_volume = kMissing;  ///< lattice points of the box, median
  /// Volume over that of the theorem's own box, the product of bound + 1, median: what the volume
  /// is set against has the order that the very theorem promises. Missing without a theorem's
  /// bound.
  double volume_share = kMissing;
  /// Volume over volume_at_least, median of the same graphs; missing if the rows lack that column.
  double volume_over_least = kMissing;
  std::string theorem_formula;    ///< "16/3 n, 16/3 n, 8 n (proved here, docs/theorem1.md)"
  std::string published_formula;  ///< empty if nobody published a bound
};

/// One entry a curve, in the order of the file. @param study  whose table of algorithms is used.
std::vector<BoundsEntry> bounds_table(const StudyTally& tally, const StudyIdentity& study);
std::vector<BoundsEntry> bounds_table(const Results& results);

/// Returns the entry's axis of smallest slack, or nullopt if nothing was measured.
std::optional<std::size_t> worst_axis(const BoundsEntry& entry);

/// Describes everything that report and exports show of a study, computed once. `rows` outlives it.
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
