// Metrics of a drawing in a real type: its points are dyadic rationals, so box and misses are found
// without tolerance; lengths are rounded. The points are first put in the order of the graph's
// edges, since a file may list edges in any order and direction.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <tuple>
#include <vector>

#include "ar3d/verify/assessment/real_segments.h"
#include "ar3d/verify/metrics/summary_pass.h"

namespace ar3d::verify {
namespace {

/// The graph that is drawn, and its points in the order of that graph's edges.
using Drawn = std::pair<Graph, RealPoints>;

/// A file may list edges in any order and direction; a Graph has its own.
Drawn drawn_by(const Drawing& drawing) {
  std::vector<std::tuple<Vertex, Vertex, EdgeId>> listed;
  std::vector<Edge> edges;
  for (EdgeId e = 0; e < drawing.num_edges(); ++e) {
    const Edge ends = drawing.edge(e);
    listed.emplace_back(std::min(ends.u, ends.v), std::max(ends.u, ends.v), e);
    edges.push_back(ends);
  }
  std::sort(listed.begin(), listed.end());
  RealPoints points;
  points.unit_exponent = drawing.real->unit_exponent;
  points.vertices = drawing.real->vertices;
  for (const auto& [u, v, e] : listed) {
    const auto bends = drawing.real->bends_of(e);
    const std::size_t begin = points.bends.size();
    points.bends.insert(points.bends.end(), bends.begin(), bends.end());
    if (drawing.edge(e).u != u) {
      std::reverse(points.bends.begin() + static_cast<std::ptrdiff_t>(begin), points.bends.end());
    }
    points.offsets.push_back(points.bends.size());
  }
  return {Graph(drawing.num_vertices(), std::move(edges)), std::move(points)};
}

/// A coordinate rounded down to an integer. @return false if it does not fit.
bool floor(const BigInteger& value, int unit_exponent, std::int64_t& out) {
  const double estimate = rounded(value, unit_exponent);
  if (!(std::abs(estimate) < static_cast<double>(kMaxCoordinate))) return false;
  const BigInteger mask = (BigInteger(1) << std::max(-unit_exponent, 0)) - 1;
  const BigInteger whole = unit_exponent >= 0 ? BigInteger(value << unit_exponent)
                           : value >= 0       ? BigInteger(value >> -unit_exponent)
                                              : BigInteger(-((-value + mask) >> -unit_exponent));
  out = static_cast<std::int64_t>(whole);
  return true;
}

/// One axis of the box of all points, rounded outwards to integers. @return false if a coordinate
/// does not fit.
bool round_box(const RealPoints& points, BigInteger BigPoint::*axis, std::int64_t Point::*out,
               Box& box) {
  const BigInteger* low = nullptr;
  const BigInteger* high = nullptr;
  for (const auto* list : {&points.vertices, &points.bends}) {
    for (const BigPoint& p : *list) {
      if (low == nullptr || p.*axis < *low) low = &(p.*axis);
      if (high == nullptr || p.*axis > *high) high = &(p.*axis);
    }
  }
  if (low == nullptr) return true;
  if (!floor(*low, points.unit_exponent, box.low.*out) ||
      !floor(-*high, points.unit_exponent, box.high.*out)) {
    return false;
  }
  box.high.*out = -(box.high.*out);
  return true;
}

double length_of(const BigPoint& a, const BigPoint& b, int unit_exponent) {
  const RoundedPoint d = rounded(b - a, unit_exponent);
  return std::hypot(d[0], d[1], d[2]);
}

DrawingSummary summary_of(const Drawn& drawn) {
  const auto& [graph, points] = drawn;
  DrawingSummary summary;
  summary.in_range = round_box(points, &BigPoint::x, &Point::x, summary.box) &&
                     round_box(points, &BigPoint::y, &Point::y, summary.box) &&
                     round_box(points, &BigPoint::z, &Point::z, summary.box);
  auto found = std::make_shared<RealAssessment>(assess(graph, points));
  summary.bend_histogram = found->bend_histogram;
  summary.segments = found->segments;
  summary.repeated_points = found->collapsed;
  summary.total_edge_length = summary.longest_edge_length = 0;
  for (EdgeId e = 0; e < graph.num_edges(); ++e) {
    const Edge ends = graph.edge(e);
    double length = 0;
    const BigPoint* from = &points.vertices[ends.u];
    for (const BigPoint& bend : points.bends_of(e)) {
      length += length_of(*from, bend, points.unit_exponent);
      from = &bend;
    }
    length += length_of(*from, points.vertices[ends.v], points.unit_exponent);
    summary.total_edge_length += length;
    summary.longest_edge_length = std::max(summary.longest_edge_length, length);
  }
  summary.real = std::move(found);
  return summary;
}

}  // namespace

DrawingSummary measure_real(const Drawing& drawing) { return summary_of(drawn_by(drawing)); }

}  // namespace ar3d::verify
