#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "ar3d/analysis/cells.h"

namespace ar3d {

/// The quantities whose growth with n is fitted.
enum class Quantity { longest_side, extent_x, extent_y, extent_z, volume, wall_s };
const std::vector<Quantity>& quantities();
/// "longest side", "x extent", …, "volume", "drawing time"
const char* name_of(Quantity quantity);
/// "lattice units", "unit cells", "s"
const char* unit_of(Quantity quantity);

/// Natural logarithm of the row's quantity; missing if the row has none or it is not positive.
/// Volume is the product of (extent + 1) over the axes.
double log_value(const RunRecord& run, Quantity quantity);
/// Natural logarithm of the theorem's bound on the quantity; missing for times and where the row
/// has no bound.
double log_bound(const RunRecord& run, Quantity quantity);

/// One instance: its value (the median over the repetitions, of logarithms) and a row that shows
/// it.
struct InstanceValue {
  double log_value = 0;
  std::size_t row = 0;
};

/// All instances of one n; never empty.
struct SizeSample {
  std::int64_t n = 0;
  std::vector<InstanceValue> instances;
  double log_bound = kMissing;  ///< of the first instance
  /// Some instance of this size ended in timeout, out of memory or a crash: what is here are the
  /// fast ones only.
  bool censored = false;
  std::vector<double> log_values() const;
};

/// A row that ended in timeout, out of memory or a crash: its value is not known, for times only
/// that it is larger than what the others needed.
struct CensoredRow {
  std::int64_t n = 0;
  std::size_t row = 0;
};
/// All of a cell with n >= 1, in increasing order of n.
std::vector<CensoredRow> censored_rows(const Results& results, const Cell& cell);

/// Whether some ok row of the cell is of the timing phase.
bool has_timing_rows(const Results& results, const Cell& cell);

/// The measured sizes of one cell in increasing order of n >= 1; only ok rows count. Times are
/// those of the timing phase if the cell has such rows, else of the metrics phase (for plots).
std::vector<SizeSample> samples(const Results& results, const Cell& cell, Quantity quantity);

/// Which sizes a fit uses, and what is left out and why (one clause each, for the report).
struct FitSizes {
  std::vector<SizeSample> used;
  std::vector<std::string> left_out;
};

/// The stated rule: sizes with censored instances are left out; then sizes below the square root of
/// the largest one, as long as `minimum_sizes` stay.
FitSizes choose_sizes(const std::vector<SizeSample>& all, std::size_t minimum_sizes);

}  // namespace ar3d
