#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "ar3d/model/drawing.h"
#include "ar3d/verify/assessment/real_assessment.h"

namespace ar3d {

/// Holds what one pass over a drawing gathers; every metric is a function of it. Integers are
/// exact; doubles are rounded, and equal for equal drawings.
struct DrawingSummary {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  bool in_range = true;  ///< no coordinate passes kMaxCoordinate in absolute value
  Box box;               ///< of all vertices and bends; the origin if not in_range
  std::vector<std::uint64_t> bend_histogram;  ///< entry b: number of edges with b bends
  std::uint64_t segments = 0;                 ///< of positive length
  std::uint64_t repeated_points = 0;          ///< segments of length zero
  double total_edge_length = kNone;           ///< in the lattice's metric, as all lengths here
  double longest_edge_length = kNone;
  double smallest_vertex_distance = kNone;
  /// Holds the assessment of a drawing in a real type, found without tolerance; nothing for other
  /// drawings.
  std::shared_ptr<const RealAssessment> real;
  /// Sum of log2(side / smallest_vertex_distance + 1) over the box's sides in the lattice's metric.
  double log2_relative_volume = kNone;
  /// volume_at_least() of the graph and the guarantee (verify/metrics/volume_bound.h), for those
  /// who have them; -1 if not set.
  std::int64_t volume_at_least = -1;
  std::int64_t optimum = -1;  ///< likewise known_optimum()

  // What set_angles_and_crossings() fills in (verify/examination.h).
  std::int64_t crossings = -1;
  double smallest_vertex_angle = kNone;  ///< degrees
  double smallest_bend_angle = kNone;    ///< degrees
  std::int64_t optimal_edges = -1;
};

/// A metric's value. What does not exist (the distance of fewer than two vertices, the size of a
/// drawing with a coordinate out of range) is -1 among integers and NaN among doubles.
using MetricValue = std::variant<std::int64_t, double>;

enum class MetricType { int64, float64 };

/// One row of the table of metrics.
struct Metric {
  std::string name;  ///< of its column wherever metrics are listed or stored
  std::string unit;
  std::string definition;
  MetricType type;
  MetricValue (*value)(const DrawingSummary&) = nullptr;
};

/// All metrics, in the order of their columns. What lists or stores metrics reads this table: a
/// new metric is one row here, and nothing elsewhere.
const std::vector<Metric>& metrics();
/// Adds a row to the table, for programs that bring metrics of their own: before anything else uses
/// it, by one thread. @throws InputError if the name is taken or empty, or there is no function.
void register_metric(Metric row);

/// The values of metrics(), in that order.
std::vector<MetricValue> metric_values(const DrawingSummary& summary);

/// The summary of a drawing with all that metrics need. Nothing is judged: certify() does that, and
/// examine() does both in one pass.
/// @throws InputError if the drawing's Gram matrix is not positive definite.
/// Cost: O(n + m + S) expected time for S segments, O(n) memory.
DrawingSummary measure(const Drawing& drawing);

}  // namespace ar3d
