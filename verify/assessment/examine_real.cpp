#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <tuple>
#include <vector>

#include "ar3d/verify/assessment/real_segments.h"
#include "ar3d/verify/checks/checks.h"
#include "ar3d/verify/checks/examination.h"

namespace ar3d::verify {
namespace {

/// The graph that is drawn, and its points in the order of that graph's edges.
struct Drawn {
  Graph graph;
  RealPoints points;
};

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

class BoxInUnits {
 public:
  void add(const BigPoint& p) {
    if (is_empty_) low_ = high_ = p;
    is_empty_ = false;
    widen(p.x, low_.x, high_.x);
    widen(p.y, low_.y, high_.y);
    widen(p.z, low_.z, high_.z);
  }

  /// Rounded outwards to integers. @return false if a coordinate does not fit.
  bool round(int unit_exponent, Box& box) const {
    return is_empty_ ||
           (floor(low_.x, unit_exponent, box.low.x) && floor(low_.y, unit_exponent, box.low.y) &&
            floor(low_.z, unit_exponent, box.low.z) &&
            ceiling(high_.x, unit_exponent, box.high.x) &&
            ceiling(high_.y, unit_exponent, box.high.y) &&
            ceiling(high_.z, unit_exponent, box.high.z));
  }

 private:
  static void widen(const BigInteger& value, BigInteger& low, BigInteger& high) {
    if (value < low) low = value;
    if (value > high) high = value;
  }
  static bool floor(const BigInteger& value, int unit_exponent, std::int64_t& out) {
    const double estimate = rounded(value, unit_exponent);
    if (!(std::abs(estimate) < static_cast<double>(kMaxCoordinate))) return false;
    const BigInteger whole = unit_exponent >= 0 ? BigInteger(value << unit_exponent)
                             : value >= 0
                                 ? BigInteger(value >> -unit_exponent)
                                 : BigInteger(-((-value + mask(unit_exponent)) >> -unit_exponent));
    out = static_cast<std::int64_t>(whole);
    return true;
  }
  static BigInteger mask(int unit_exponent) { return (BigInteger(1) << -unit_exponent) - 1; }
  static bool ceiling(const BigInteger& value, int unit_exponent, std::int64_t& out) {
    if (!floor(-value, unit_exponent, out)) return false;
    out = -out;
    return true;
  }

  BigPoint low_, high_;
  bool is_empty_ = true;
};

double length_of(const BigPoint& a, const BigPoint& b, int unit_exponent) {
  const RoundedPoint d = rounded(difference(b, a), unit_exponent);
  return std::hypot(d.x, d.y, d.z);
}

DrawingSummary summary_of(const Drawn& drawn) {
  DrawingSummary summary;
  BoxInUnits box;
  for (const BigPoint& p : drawn.points.vertices) box.add(p);
  for (const BigPoint& p : drawn.points.bends) box.add(p);
  summary.in_range = box.round(drawn.points.unit_exponent, summary.box);
  auto found = std::make_shared<RealAssessment>(assess(drawn.graph, drawn.points));
  summary.bend_histogram = found->bend_histogram;
  summary.segments = found->segments;
  summary.repeated_points = found->collapsed;
  summary.total_edge_length = summary.longest_edge_length = 0;
  for (EdgeId e = 0; e < drawn.graph.num_edges(); ++e) {
    const Edge ends = drawn.graph.edge(e);
    double length = 0;
    const BigPoint* from = &drawn.points.vertices[ends.u];
    for (const BigPoint& bend : drawn.points.bends_of(e)) {
      length += length_of(*from, bend, drawn.points.unit_exponent);
      from = &bend;
    }
    length += length_of(*from, drawn.points.vertices[ends.v], drawn.points.unit_exponent);
    summary.total_edge_length += length;
    summary.longest_edge_length = std::max(summary.longest_edge_length, length);
  }
  summary.real = std::move(found);
  return summary;
}

void check_claim(const Drawing& drawing, const Guarantee& guarantee, Findings& findings) {
  if (guarantee.claim == Claim::measured) return;
  findings.add({ViolationKind::lattice,
                {},
                {},
                {},
                fmt::format("the points are in the real type {}, the guarantee speaks of a lattice",
                            drawing.real->type)});
}

void check_bends(const RealPoints& points, const Guarantee& guarantee, Findings& findings) {
  for (EdgeId e = 0; e + 1 < points.offsets.size() && !findings.done(); ++e) {
    const std::size_t bends = points.bends_of(e).size();
    if (bends <= guarantee.max_bends) continue;
    findings.add({ViolationKind::bends,
                  {},
                  {e},
                  {},
                  fmt::format("edge {} has {} bends, at most {} are promised", e, bends,
                              guarantee.max_bends)});
  }
}

}  // namespace

DrawingSummary measure_real(const Drawing& drawing) { return summary_of(drawn_by(drawing)); }

Examination examine_real(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee,
                         const ExaminationParts& parts, const CertifyOptions& options) {
  Examination result;
  if (parts.hash) result.drawing_hash = drawing_hash(drawing);
  if (!parts.certificate && !parts.metrics) return result;
  result.summary = measure_real(drawing);
  if (!parts.certificate) return result;
  Findings findings(options.max_violations);
  check_graph(graph, drawing, findings);
  check_claim(drawing, guarantee, findings);
  check_bends(*drawing.real, guarantee, findings);
  Certificate& certificate = result.certificate;
  certificate.measured = true;
  certificate.complete = !findings.done();
  certificate.violations = findings.take();
  certificate.box = result.summary.box;
  certificate.bend_histogram = result.summary.bend_histogram;
  certificate.segments = result.summary.segments;
  return result;
}

}  // namespace ar3d::verify
