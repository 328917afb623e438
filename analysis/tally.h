#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "ar3d/base/printable.h"  // shell_word
#include "ar3d/store/columns/curves.h"
#include "ar3d/store/rows.h"

namespace ar3d {

/// Describes one graph drawn by one curve: its first ok row, and the medians of its drawing times.
struct DrawnGraph {
  std::size_t row = 0;
  RunStatus status = RunStatus::ok;
  std::int64_t n = -1;
  std::int64_t m = -1;
  std::uint64_t seed = 0;
  std::int64_t instance = -1;  ///< RunRecord::instance_index
  std::string name, group;     ///< of a graph of files
  std::array<std::int64_t, 3> extents{-1, -1, -1};
  std::array<std::int64_t, 3> skewed{-1, -1, -1};  ///< counters skew_x, skew_y, skew_z
  std::array<std::int64_t, 3> instance_bound{-1, -1, -1};
  std::array<double, 3> theorem_bound{kMissing, kMissing, kMissing};
  std::array<double, 3> published_bound{kMissing, kMissing, kMissing};
  double log2_volume = kMissing;           ///< in the unit of CurveTally::has_own_unit
  double log2_relative_volume = kMissing;  ///< over the smallest distance of vertices
  double log_wall_s = kMissing;   ///< natural logarithm, median over ok rows of the metrics phase
  double log_timed_s = kMissing;  ///< the same of the timing phase
  std::vector<double> metrics;    ///< values of verify/metrics/metrics.h in its order; NaN: missing

  /// Returns the largest extent / theorem's bound over the axes; missing if no axis has both.
  double share() const;
};

/// Names the quantities whose growth with n is fitted; skewed extents of an algorithm that states
/// them.
enum class Quantity {
  longest_side,
  extent_x,
  extent_y,
  extent_z,
  volume,
  skewed_x,
  skewed_y,
  skewed_z,
  wall_s
};
inline constexpr std::array kQuantities = {
    Quantity::longest_side, Quantity::extent_x, Quantity::extent_y,
    Quantity::extent_z,     Quantity::volume,   Quantity::skewed_x,
    Quantity::skewed_y,     Quantity::skewed_z, Quantity::wall_s};
/// Returns the natural logarithm of the graph's quantity; missing if there is none or it is not
/// positive. Volume is log2_volume. @param timed  whether drawing times are those of the timing
/// phase.
double log_value(const DrawnGraph& graph, Quantity quantity, bool timed);

/// Returns one metric of the table; NaN: missing.
double metric_of(const DrawnGraph& graph, std::string_view name);
/// Returns the natural logarithm of volume_at_least; missing in rows of programs that did not have
/// it.
double log_volume_at_least(const DrawnGraph& graph);

/// Holds what all graphs of one n gave.
struct SizeTally {
  std::int64_t n = 0;
  std::int64_t requested_n = 0;    ///< what the study asked for when this n came out
  bool censored = false;           ///< some graph ended in timeout, out of memory or a crash
  std::size_t drawn = 0;           ///< graphs with an ok row
  std::vector<DrawnGraph> graphs;  ///< these, or StudyTally::kept_graphs of them, a uniform sample
  DrawnGraph closest;              ///< of all drawn: the largest share(); row of none: no bound
  /// Holds sum and number of log_value of all drawn graphs by quantity; the last is the timing
  /// phase.
  std::array<double, 10> log_sum{};
  std::array<std::size_t, 10> log_count{};

  /// Returns the mean of log_value over all drawn graphs; missing without any.
  double mean_log(Quantity quantity, bool timed) const;
};

/// Is one axis of one curve. Slack is 1 - extent / bound, computed from the extents: 0 touches the
/// bound, a negative one breaks it; missing without a bound. Statistics are over graphs (the first
/// ok repetition of each); medians, which analyse() fills in, over those that the tally keeps.
struct AxisBounds {
  std::size_t measured = 0;  ///< kept graphs with an extent and a positive finite theorem's bound
  double worst_slack = kMissing;  ///< the smallest against the theorem's bound
  double median_slack = kMissing;
  double worst_instance_slack = kMissing;  ///< against the proof's bound for the very instance
  double median_instance_slack = kMissing;
  double worst_published_slack = kMissing;  ///< against the published bound
  double median_published_slack = kMissing;
  DrawnGraph worst;  ///< the graph of worst_slack
};

/// Returns the largest number of bends of which there are edges; 0 without any.
template <class Integer>
std::size_t most_bends(const std::array<Integer, 8>& bends) {
  std::size_t most = bends.size() - 1;
  while (most > 0 && bends[most] <= 0) --most;
  return most;
}
/// Returns 1 - extent / bound; missing if one of the two is, or the bound is 0.
double slack_of(std::int64_t extent, double bound);
/// Returns the natural logarithm of a positive finite value; missing for others.
double log_positive(double value);

/// Counts the values of RunStatus.
inline constexpr std::size_t kNumRunStatuses = static_cast<std::size_t>(RunStatus::measured) + 1;

/// Holds what all rows of one curve gave.
struct CurveTally {
  CurveKey key;
  std::size_t rows = 0;
  std::size_t instances = 0;   ///< graphs, drawn or not
  std::size_t violations = 0;  ///< rows that break a bound or a certificate, as `check` counts them
  std::size_t unproved = 0;    ///< ok rows that no exact certificate judged
  std::array<std::size_t, kNumRunStatuses> rows_of_status{};  ///< indexed by RunStatus
  std::int64_t smallest_n = -1;
  std::int64_t largest_n = -1;
  std::array<AxisBounds, 3> axes;
  std::array<std::uint64_t, 8> bends{};  ///< edges with b bends over all drawn graphs; 7 or more
  bool has_timing_rows = false;          ///< some ok row is of the timing phase
  /// Is true if no theorem promises a box, so that the unit of coordinates is the drawings' own:
  /// extents and bounds are missing, and volumes are over the smallest distance of vertices.
  bool has_own_unit = false;
  std::map<std::int64_t, SizeTally> sizes;
  /// Holds rows that ended in timeout, out of memory or a crash, the first 1000 with n >= 1, by n:
  /// their values are not known, of times only that they are larger than what the others needed.
  std::vector<DrawnGraph> censored;
  // What analyse() fills in, beside the medians of the axes.
  double log2_volume = kMissing;  ///< lattice points of the box, median
  /// Is the volume over that of the theorem's own box, the product of bound + 1, median. It has the
  /// order that the very theorem promises; missing without a theorem's bound.
  double volume_share = kMissing;
  /// Is the volume over volume_at_least, median of the same graphs; missing if the rows lack that
  /// column.
  double volume_over_least = kMissing;
  double times_the_optimum = kMissing;  ///< of all graphs that have it, median
  std::string theorem_formula;          ///< "16/3 n, 16/3 n, 8 n (proved here, docs/theorem1.md)"
  std::string published_formula;        ///< empty if no bound is published

  std::size_t count(RunStatus status) const {
    return rows_of_status[static_cast<std::size_t>(status)];
  }
};

/// Names batches of one size that so many threads or ranks shared: phase, algorithm_label,
/// family_label, n, how many shared them.
using BatchKey = std::tuple<RunPhase, std::string, std::string, std::int64_t, std::int64_t>;

/// Holds what one pass over a study's rows keeps. Memory does not grow with the rows of a size: at
/// most 200,000 graphs with all their numbers, or eight for each of at most 200,000 sizes.
struct StudyTally {
  std::vector<CurveTally> curves;  ///< in the order of their first rows
  /// Holds batch_s and ideal_batch_s of the first 10,000 rows of each.
  std::map<BatchKey, std::array<std::vector<double>, 2>> batches;
  std::size_t kept_graphs = 0;    ///< of each size at most so many; 0: all were kept
  std::size_t left_out_rows = 0;  ///< of curves and sizes beyond the first 200,000 sizes
};

/// Tallies all rows.
/// @param is_last_repetition  of check(rows). Cost: O(r) expected for r rows in any order; the
/// memory of graphs whose repetitions are not all read yet comes on top.
StudyTally tally_of(const Rows& rows, const std::vector<bool>& is_last_repetition);

/// Returns the shell line that generates the row's graph again and draws it with the same algorithm
/// and options. Words that a shell would read in another way are quoted, whatever the results file
/// holds.
std::string draw_command(const RunRecord& run);
std::string draw_command(const CurveKey& key, std::int64_t n, std::uint64_t seed);

/// Returns the parts of that line: it is the first one, n, " --seed ", the seed, the second one.
std::pair<std::string, std::string> draw_command_parts(const CurveKey& key);

/// Represents the line that shows a row of this study again: draw_command, or "ar3d replay FILE ROW"
/// with the row's key or number where that needs the results. It does where the graph is one of a
/// file (/graph_files), or where a program of the study's own ("program_NAME") draws it.
class ShowCommand {
 public:
  explicit ShowCommand(const Rows& rows);
  bool is_of_file(const std::string& family) const { return families_.contains(family); }
  bool needs_results(const CurveKey& key) const {
    return is_of_file(key.family) || programs_.contains(key.algorithm);
  }
  std::string operator()(const CurveKey& key, const DrawnGraph& graph) const;
  std::string operator()(const RunRecord& run, std::size_t row) const;

 private:
  std::string file_;
  std::set<std::string> families_;  // of files
  std::set<std::string> programs_;
};

}  // namespace ar3d
