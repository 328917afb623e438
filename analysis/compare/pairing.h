#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "ar3d/analysis/compare/time_change.h"
#include "ar3d/store/columns/curves.h"
#include "ar3d/store/rows.h"

namespace ar3d {

/// Is one measurement that both sides, base and new, made: the same graph, algorithm, options, phase
/// and repetition.
using PairedRow = std::array<const RunRecord*, 2>;

/// Describes the measurements of one algorithm on one family at one size.
struct PairedCell {
  CurveKey key;
  std::int64_t n = -1;  ///< vertices; -1: all sizes
  std::vector<PairedRow> rows;
};

/// Matches rows by what they measure, not by their index. The pointers are into the arguments.
/// @param incomplete  gets a line on rows of base that the other side lacks. @param remarks  get one
/// on further repetitions in base's timing phase, which are not missing since how many there are
/// depends on the noise, and one on rows that base lacks; none that is there already.
/// @return cells in base's order.
/// @throws InputError if one side holds the same measurement twice. Cost: O(r log r) for r rows.
std::vector<PairedCell> pair_rows(const Results& base, const Results& now,
                                  std::vector<std::string>& incomplete,
                                  std::vector<std::string>& remarks);
/// Adds a line unless it is there already.
void add_once(std::vector<std::string>& lines, const std::string& line);

/// Returns true if both sides drew it, judged right (ok) or without a guarantee to be judged by
/// (measured).
bool both_drawn(const PairedRow& row);

/// Returns "diamond (effort=1) on random-cubic n=100, instance 0, repetition 2": which measurement
/// a row is.
std::string row_label(const RunRecord& run);

/// Returns the drawn pairs whose times count: of the timing phase if the cell has any, else of
/// metrics. A pair without two finite positive drawing times is left out.
std::vector<PairedRow> timed_rows(const PairedCell& cell);

/// Returns log(new / base) of a whole round as one number: the median over graphs of the ratio of
/// the smallest drawing times among the repetitions of each; NaN if there is none.
double round_log_time_ratio(const PairedCell& cell);

/// Counts rows drawn on both sides whose time is not a finite positive number although it should be
/// one.
std::size_t rows_without_time(const PairedCell& cell);

/// Is what a change of a value without noise means, and in one line what it is, before and after.
using FixedChange = std::pair<Verdict, std::string>;

/// Compares status, certificate, graph, volume (exact, lattice points of the box) and bends of one
/// pair of rows. Rows without a guarantee are compared by volume in smallest distances of vertices,
/// crossings and smallest angles, where 1 % of volume or angle is no change. Values that one of the
/// two misses are not compared; a drawing that differs in something else passes.
std::vector<FixedChange> fixed_changes(const PairedRow& row);

/// Returns log2(new / base) of the volume that fixed_changes compares; 0 where one of the two has
/// none.
double log2_volume_change(const PairedRow& row);

/// Compares a whole cell's counts by their sums over its drawings. A change is for the worse or the
/// better if it is more than log(1 + its threshold) away from 0.
/// @param logs  becomes log(new / base) of instructions and of estimated cycles; NaN unless both
/// sides have counted all that both have drawn.
std::vector<FixedChange> count_changes(const PairedCell& cell, const CompareOptions& options,
                                       std::array<double, 2>& logs);

}  // namespace ar3d
