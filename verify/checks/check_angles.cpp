// Checks the promised angles at bends and vertices, each by the exact sign of a cosine's
// difference.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "ar3d/verify/checks/checks.h"

namespace ar3d::verify {
namespace {

bool keeps_angle(const Guarantee& guarantee, Vector u, Vector v) {
  return verify::keeps_angle(guarantee, compare_cosine(guarantee.lattice, u, v, guarantee.cosine));
}

/// At least arccos(1): any angle will do.
bool promises_angles(const Guarantee& guarantee) {
  return guarantee.angle_rule == AngleRule::exactly ||
         guarantee.cosine.numerator < guarantee.cosine.denominator;
}

std::string describe_rule(const Guarantee& guarantee) {
  const Cosine c = guarantee.cosine;
  return fmt::format("{} arccos({}/{}) is promised",
                     guarantee.angle_rule == AngleRule::exactly ? "exactly" : "at least",
                     c.numerator, c.denominator);
}

/// A segment that leaves a vertex, which is its last point instead of its first if it is reversed.
struct Leaving {
  Vertex vertex;
  SegmentId segment;
  bool reversed;
};

Vector direction(const Segments& segments, const Leaving& leaving) {
  const Vector d = segments.direction(leaving.segment);
  return leaving.reversed ? -d : d;
}

/// By vertex, those of one vertex from the last edge to the first. O(S log S).
std::vector<Leaving> leaving_segments(const Segments& segments) {
  std::vector<Leaving> leaving;
  for (SegmentId s = 0; s < segments.size(); ++s) {
    const Edge ends = segments.drawing().edge(segments.edge(s));
    if (segments.is_first(s)) leaving.push_back({ends.u, s, false});
    if (segments.is_last(s)) leaving.push_back({ends.v, s, true});
  }
  std::reverse(leaving.begin(), leaving.end());
  std::stable_sort(leaving.begin(), leaving.end(),
                   [](const Leaving& a, const Leaving& b) { return a.vertex < b.vertex; });
  return leaving;
}

Violation wrong_angle(const Segments& segments, const Guarantee& guarantee, const Leaving& a,
                      const Leaving& b) {
  const EdgeId e = segments.edge(a.segment);
  const EdgeId f = segments.edge(b.segment);
  const Point p = segments.drawing().vertex(a.vertex);
  return {ViolationKind::vertex_angle,
          {a.vertex},
          {e, f},
          {p},
          fmt::format("vertex {} at {}: edges {} and {} leave along {} and {}, {}", a.vertex,
                      to_string(p), e, f, to_string(primitive(direction(segments, a))),
                      to_string(primitive(direction(segments, b))), describe_rule(guarantee))};
}

}  // namespace

void check_bend_angles(const Segments& segments, const Guarantee& guarantee, Findings& findings) {
  if (!promises_angles(guarantee)) return;
  for (SegmentId s = 1; s < segments.size() && !findings.done(); ++s) {
    if (segments.is_first(s)) continue;
    const Vector back = -segments.direction(s - 1);
    const Vector ahead = segments.direction(s);
    if (keeps_angle(guarantee, back, ahead)) continue;
    const Point p = segments.from(s);
    findings.add(ViolationKind::bend_angle, {}, {segments.edge(s)}, {p},
                 "{}, bend {}: the segments leave it along {} and {}, {}",
                 describe_edge(segments.drawing(), segments.edge(s)), to_string(p),
                 to_string(primitive(back)), to_string(primitive(ahead)), describe_rule(guarantee));
  }
}

void check_vertex_angles(const Segments& segments, const Guarantee& guarantee, Findings& findings) {
  if (!promises_angles(guarantee)) return;
  const std::vector<Leaving> leaving = leaving_segments(segments);
  std::size_t begin = 0;  // of the vertex's
  for (std::size_t i = 0; i < leaving.size() && !findings.done(); ++i) {
    if (leaving[begin].vertex != leaving[i].vertex) begin = i;
    for (std::size_t j = begin; j < i && !findings.done(); ++j) {
      const Vector a = direction(segments, leaving[i]);
      if (keeps_angle(guarantee, a, direction(segments, leaving[j]))) continue;
      findings.add(wrong_angle(segments, guarantee, leaving[j], leaving[i]));
    }
  }
}

}  // namespace ar3d::verify
