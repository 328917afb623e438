// The table of metrics. Each is a function of one summary, so a new metric is one row here.
#include "ar3d/verify/metrics/metrics.h"

#include <cmath>

#include "ar3d/base/error.h"
#include "ar3d/base/open_table.h"
#include "ar3d/verify/metrics/summary_pass.h"

namespace ar3d {
namespace {

using Summary = const DrawingSummary&;

template <std::size_t axis>
MetricValue extent(Summary summary) {
  return summary.in_range ? summary.box.extents()[axis] : std::int64_t{-1};
}

MetricValue log2_volume(Summary summary) {
  if (!summary.in_range) return DrawingSummary::kNone;
  double sum = 0;
  for (const std::int64_t extent : summary.box.extents()) {
    sum += std::log2(static_cast<double>(extent) + 1);
  }
  return sum;
}

MetricValue times_the_optimum(Summary summary) {
  if (!summary.in_range || summary.optimum < 0) return DrawingSummary::kNone;
  double points = 1;
  for (const std::int64_t extent : summary.box.extents()) points *= static_cast<double>(extent + 1);
  return points / static_cast<double>(summary.optimum);
}

template <std::size_t bends>
MetricValue edges_with(Summary summary) {
  const auto& histogram = summary.bend_histogram;
  return bends < histogram.size() ? static_cast<std::int64_t>(histogram[bends]) : std::int64_t{0};
}

template <std::size_t bends>
MetricValue edges_with_at_least(Summary summary) {
  std::int64_t edges = 0;
  for (std::size_t b = bends; b < summary.bend_histogram.size(); ++b) {
    edges += static_cast<std::int64_t>(summary.bend_histogram[b]);
  }
  return edges;
}

template <auto member>
MetricValue value_of(Summary summary) {
  return summary.*member;
}

/// Reads what only drawings in real types have.
template <double RealAssessment::*member>
MetricValue real_number(Summary summary) {
  return summary.real ? MetricValue((*summary.real).*member) : DrawingSummary::kNone;
}

template <std::uint64_t RealAssessment::*member>
MetricValue real_count(Summary summary) {
  return summary.real ? static_cast<std::int64_t>((*summary.real).*member) : std::int64_t{-1};
}

MetricValue root_mean_square_miss(Summary summary) {
  if (!summary.real) return DrawingSummary::kNone;
  return std::sqrt(summary.real->mean_square_miss);
}

template <std::size_t limit>
MetricValue share_within(Summary summary) {
  if (!summary.real || summary.real->angles == 0) return DrawingSummary::kNone;
  return static_cast<double>(summary.real->within[limit]) /
         static_cast<double>(summary.real->angles);
}

// In a real type pairs of segments, else what the certificate lists.
MetricValue crossings(Summary summary) {
  if (summary.real) return static_cast<std::int64_t>(summary.real->crossings);
  return summary.crossings;
}

constexpr const char* kLengthUnit = "length in the lattice's metric";

std::vector<Metric> make_metrics() {
  constexpr auto int64 = MetricType::int64;
  constexpr auto float64 = MetricType::float64;
  return {
      {"extent_x", "lattice units", "largest minus smallest x of all vertices and bends", int64,
       extent<0>},
      {"extent_y", "lattice units", "largest minus smallest y of all vertices and bends", int64,
       extent<1>},
      {"extent_z", "lattice units", "largest minus smallest z of all vertices and bends", int64,
       extent<2>},
      {"log2_volume", "log2 of cubic lattice units", "sum of log2(extent + 1) over the three axes",
       float64, log2_volume},
      {"bends_0", "edges", "edges without bends", int64, edges_with<0>},
      {"bends_1", "edges", "edges with one bend", int64, edges_with<1>},
      {"bends_2", "edges", "edges with two bends", int64, edges_with<2>},
      {"bends_3", "edges", "edges with three bends", int64, edges_with<3>},
      {"bends_4", "edges", "edges with four bends", int64, edges_with<4>},
      {"bends_5", "edges", "edges with five bends", int64, edges_with<5>},
      {"bends_6", "edges", "edges with six bends", int64, edges_with<6>},
      {"bends_7", "edges", "edges with seven or more bends", int64, edges_with_at_least<7>},
      {"total_edge_length", kLengthUnit, "sum of the lengths of all edges", float64,
       value_of<&DrawingSummary::total_edge_length>},
      {"longest_edge_length", kLengthUnit, "length of the longest edge", float64,
       value_of<&DrawingSummary::longest_edge_length>},
      {"smallest_vertex_distance", kLengthUnit,
       "distance of the closest pair of vertices; missing if n < 2", float64,
       value_of<&DrawingSummary::smallest_vertex_distance>},
      {"angle_miss", "degrees",
       "in a real type: largest miss of an angle (120 degrees at vertices of degree 3, at least "
       "that elsewhere), exact inner products rounded once",
       float64, real_number<&RealAssessment::largest_miss>},
      {"angle_miss_rms", "degrees", "in a real type: root of the mean square of these misses",
       float64, root_mean_square_miss},
      {"within_1e_12", "1", "in a real type: share of angles that miss by at most 1e-12 degrees",
       float64, share_within<0>},
      {"within_1e_9", "1", "in a real type: share of angles that miss by at most 1e-9 degrees",
       float64, share_within<1>},
      {"within_1e_6", "1", "in a real type: share of angles that miss by at most 1e-6 degrees",
       float64, share_within<2>},
      {"within_1e_3", "1", "in a real type: share of angles that miss by at most 1e-3 degrees",
       float64, share_within<3>},
      {"collapsed_segments", "segments", "in a real type: segments of length zero", int64,
       real_count<&RealAssessment::collapsed>},
      {"condition", "1",
       "in a real type: largest sum over the two sides of an angle of largest coordinate / "
       "length; its log2 is the number of bits that angles lose",
       float64, real_number<&RealAssessment::condition>},
      {"log2_relative_volume", "log2",
       "sum of log2(side / smallest vertex distance + 1) over the three sides of the box; missing "
       "if n < 2 or vertices coincide",
       float64, value_of<&DrawingSummary::log2_relative_volume>},
      {"crossings", "1",
       "pairs of segments with a common point that is no common end of theirs, vertices on edges "
       "and coinciding vertices, counted exactly",
       int64, crossings},
      {"smallest_vertex_angle", "degrees", "smallest angle between two segments at a vertex",
       float64, value_of<&DrawingSummary::smallest_vertex_angle>},
      {"smallest_bend_angle", "degrees", "smallest angle between two segments at a bend", float64,
       value_of<&DrawingSummary::smallest_bend_angle>},
      {"optimal_edges", "edges",
       "edges all of whose angles are at least the optimum (120 degrees up to maximum degree 3, "
       "arccos(-1/3) for 4), decided exactly; missing beyond",
       int64, value_of<&DrawingSummary::optimal_edges>},
      {"volume_at_least", "cubic lattice units",
       "no drawing of this graph that keeps the algorithm's guarantee has a box of fewer lattice "
       "points (docs/lower-bounds.md); missing without a guarantee",
       int64, value_of<&DrawingSummary::volume_at_least>},
      {"times_the_optimum", "1",
       "lattice points of the box over those of the smallest one for the guarantee's angles, "
       "directions and bends, vertices anywhere (docs/optimum.md); missing if it is not known",
       float64, times_the_optimum}};
}

OpenTable<Metric>& table() {
  static OpenTable<Metric> rows("metric", make_metrics(),
                                [](const Metric& row) { return row.value != nullptr; });
  return rows;
}

}  // namespace

const std::vector<Metric>& metrics() { return table().rows(); }

void register_metric(Metric row) { table().add(std::move(row)); }

std::vector<MetricValue> metric_values(const DrawingSummary& summary) {
  std::vector<MetricValue> values;
  values.reserve(metrics().size());
  for (const Metric& metric : metrics()) values.push_back(metric.value(summary));
  return values;
}

DrawingSummary measure(const Drawing& drawing) {
  if (drawing.real) return verify::measure_real(drawing);
  verify::SummaryPass pass(drawing, true);
  for_each_polyline(drawing, [&](EdgeId, const std::vector<Point>& points) { pass.add(points); });
  return pass.finish();
}

}  // namespace ar3d
