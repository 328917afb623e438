#include "ar3d/verify/metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ar3d/verify/closest_pair.h"

namespace ar3d {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

void measure_edges(const Drawing& drawing, Metrics& metrics) {
  std::vector<Point> points;
  for (EdgeId e = 0; e < drawing.num_edges(); ++e) {
    drawing.polyline(e, points);
    const std::size_t bends = points.size() - 2;
    if (bends >= metrics.bend_histogram.size()) metrics.bend_histogram.resize(bends + 1);
    ++metrics.bend_histogram[bends];
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      length += approximate_length(drawing.lattice(), points[i] - points[i - 1]);
    }
    metrics.total_edge_length += length;
    metrics.longest_edge_length = std::max(metrics.longest_edge_length, length);
  }
}

void measure_box(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee,
                 Metrics& metrics) {
  metrics.extents = bounding_box(drawing).extents();
  const std::uint64_t n = graph.num_vertices();
  double volume = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto extent = static_cast<double>(metrics.extents[axis]);
    volume *= extent;
    metrics.log2_volume += std::log2(extent + 1);
    const double bound = n == 0 ? 0 : guarantee.bound.axes[axis].value(n);
    metrics.theorem_bound[axis] = bound > 0 ? bound : kNone;
    metrics.slack[axis] = bound > 0 ? 1 - extent / bound : kNone;
  }
  const auto size = static_cast<double>(n);
  metrics.volume_per_n3 = n == 0 ? kNone : volume / (size * size * size);
}

double measure_distance(const Drawing& drawing) {
  const auto pair = verify::closest_pair(drawing);
  if (!pair) return kNone;
  return approximate_length(drawing.lattice(), drawing.vertex(pair->u) - drawing.vertex(pair->v));
}

double bends_of(const Metrics& metrics, std::size_t bends) {
  const auto& histogram = metrics.bend_histogram;
  return bends < histogram.size() ? static_cast<double>(histogram[bends]) : 0.0;
}

double seven_or_more_bends(const Metrics& metrics) {
  double edges = 0;
  for (std::size_t b = 7; b < metrics.bend_histogram.size(); ++b) edges += bends_of(metrics, b);
  return edges;
}

double extent(const Metrics& metrics, std::size_t axis) {
  return static_cast<double>(metrics.extents[axis]);
}

}  // namespace

Metrics measure(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee) {
  Metrics metrics;
  measure_box(graph, drawing, guarantee, metrics);
  measure_edges(drawing, metrics);
  metrics.smallest_vertex_distance = measure_distance(drawing);
  return metrics;
}

const std::vector<Metric>& metrics() {
  using M = const Metrics&;
  static const std::vector<Metric> table = {
      {"extent_x", "lattice units", "largest minus smallest x of all vertices and bends",
       [](M m) { return extent(m, 0); }},
      {"extent_y", "lattice units", "largest minus smallest y of all vertices and bends",
       [](M m) { return extent(m, 1); }},
      {"extent_z", "lattice units", "largest minus smallest z of all vertices and bends",
       [](M m) { return extent(m, 2); }},
      {"log2_volume", "bits", "sum of log2(extent + 1) over the three axes",
       [](M m) { return m.log2_volume; }},
      {"volume_per_n3", "cubic lattice units", "product of the three extents, divided by n^3",
       [](M m) { return m.volume_per_n3; }},
      {"bends_0", "edges", "edges without bends", [](M m) { return bends_of(m, 0); }},
      {"bends_1", "edges", "edges with one bend", [](M m) { return bends_of(m, 1); }},
      {"bends_2", "edges", "edges with two bends", [](M m) { return bends_of(m, 2); }},
      {"bends_3", "edges", "edges with three bends", [](M m) { return bends_of(m, 3); }},
      {"bends_4", "edges", "edges with four bends", [](M m) { return bends_of(m, 4); }},
      {"bends_5", "edges", "edges with five bends", [](M m) { return bends_of(m, 5); }},
      {"bends_6", "edges", "edges with six bends", [](M m) { return bends_of(m, 6); }},
      {"bends_7", "edges", "edges with seven or more bends", seven_or_more_bends},
      {"total_edge_length", "length in the lattice's metric", "sum of the lengths of all edges",
       [](M m) { return m.total_edge_length; }},
      {"longest_edge_length", "length in the lattice's metric", "length of the longest edge",
       [](M m) { return m.longest_edge_length; }},
      {"smallest_vertex_distance", "length in the lattice's metric",
       "distance of the closest pair of vertices; none if n < 2",
       [](M m) { return m.smallest_vertex_distance; }},
      {"slack_x", "fraction", "1 - extent_x / (the theorem's bound for this n)",
       [](M m) { return m.slack[0]; }},
      {"slack_y", "fraction", "1 - extent_y / (the theorem's bound for this n)",
       [](M m) { return m.slack[1]; }},
      {"slack_z", "fraction", "1 - extent_z / (the theorem's bound for this n)",
       [](M m) { return m.slack[2]; }}};
  return table;
}

}  // namespace ar3d
