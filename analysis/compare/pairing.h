#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "ar3d/store/columns/curves.h"
#include "ar3d/store/rows.h"

namespace ar3d {

/// Describes one measurement that both sides made: the same graph, algorithm, options, phase and
/// repetition.
struct PairedRow {
  const RunRecord* base = nullptr;
  const RunRecord* now = nullptr;
};

/// Describes the measurements of one algorithm on one family at one size.
struct PairedCell {
  CurveKey key;
  std::int64_t n = -1;  ///< vertices; -1: all sizes
  std::vector<PairedRow> rows;
};

struct Pairing {
  std::vector<PairedCell> cells;  ///< in base's order
  std::size_t missing = 0;        ///< rows of base that the other side lacks
  std::size_t fewer = 0;          ///< further repetitions in base's timing phase, not missing: how
                                  ///< many there are depends on the noise
  std::size_t extra = 0;          ///< rows that base lacks
  std::string first_missing;      ///< which one, for people; empty if none
};

/// Matches rows by what they measure, not by their index. The pointers are into the arguments.
/// @throws InputError if one side holds the same measurement twice. Cost: O(r log r) for r rows.
Pairing pair_rows(const Results& base, const Results& now);

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

/// Sorts by what outweighs what. unjudged: nothing got worse among what has no noise, and the
/// times were not judged; inconclusive: they were, and their noise, or too few pairs, leaves it
/// open.
enum class Verdict { pass, improved, unjudged, inconclusive, regressed, violated };
/// Returns "PASS", "IMPROVED", "UNJUDGED", "INCONCLUSIVE", "REGRESSED", "VIOLATED"
const char* to_string(Verdict verdict);

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

/// Returns log(new / base) of a whole cell's counts of instructions and of estimated cycles, by
/// their sums over its drawings; NaN unless both sides have counted all that both have drawn.
std::pair<double, double> count_change(const PairedCell& cell);

/// Returns a change for the worse or the better if one of the two is more than log(1 + its
/// threshold) away from 0.
std::vector<FixedChange> count_changes(double instructions, double cycles,
                                       double instruction_threshold, double cycle_threshold);

}  // namespace ar3d
