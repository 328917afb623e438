#include <fmt/format.h>

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

/// A segment that leaves a vertex: which one, and whether the vertex is its last point instead of
/// its first.
struct Leaving {
  SegmentId segment;
  bool reversed;
};

Vector direction(const Segments& segments, Leaving leaving) {
  const Vector d = segments.direction(leaving.segment);
  return leaving.reversed ? -d : d;
}

/// The segments that leave every vertex, as compressed rows.
struct Stars {
  std::vector<std::size_t> offsets;
  std::vector<Leaving> leaving;
};

template <class Visit>
void for_each_end(const Segments& segments, Visit&& visit) {
  for (SegmentId s = 0; s < segments.size(); ++s) {
    const Edge ends = segments.drawing().edge(segments.edge(s));
    if (segments.is_first(s)) visit(ends.u, Leaving{s, false});
    if (segments.is_last(s)) visit(ends.v, Leaving{s, true});
  }
}

Stars stars_of(const Segments& segments) {
  Stars stars{std::vector<std::size_t>(segments.drawing().num_vertices() + 1), {}};
  for_each_end(segments, [&](Vertex v, Leaving) { ++stars.offsets[v]; });
  std::size_t total = 0;
  for (auto& offset : stars.offsets) offset = total += offset;
  stars.leaving.resize(total);
  for_each_end(segments, [&](Vertex v, Leaving l) { stars.leaving[--stars.offsets[v]] = l; });
  return stars;
}

void check_star(const Segments& segments, const Guarantee& guarantee, const Stars& stars, Vertex v,
                Findings& findings) {
  for (std::size_t i = stars.offsets[v]; i < stars.offsets[v + 1] && !findings.done(); ++i) {
    for (std::size_t j = stars.offsets[v]; j < i && !findings.done(); ++j) {
      const Vector a = direction(segments, stars.leaving[i]);
      const Vector b = direction(segments, stars.leaving[j]);
      if (keeps_angle(guarantee, a, b)) continue;
      const EdgeId e = segments.edge(stars.leaving[j].segment);
      const EdgeId f = segments.edge(stars.leaving[i].segment);
      const Point p = segments.drawing().vertex(v);
      findings.add({ViolationKind::vertex_angle,
                    {v},
                    {e, f},
                    {p},
                    fmt::format("vertex {} at {}: edges {} and {} leave along {} and {}, {}", v,
                                to_string(p), e, f, to_string(primitive(b)),
                                to_string(primitive(a)), describe_rule(guarantee))});
    }
  }
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
    findings.add({ViolationKind::bend_angle,
                  {},
                  {segments.edge(s)},
                  {p},
                  fmt::format("{}, bend {}: the segments leave it along {} and {}, {}",
                              describe_edge(segments.drawing(), segments.edge(s)), to_string(p),
                              to_string(primitive(back)), to_string(primitive(ahead)),
                              describe_rule(guarantee))});
  }
}

void check_vertex_angles(const Segments& segments, const Guarantee& guarantee, Findings& findings) {
  if (!promises_angles(guarantee)) return;
  const Stars stars = stars_of(segments);
  for (std::size_t v = 0; v < segments.drawing().num_vertices() && !findings.done(); ++v) {
    check_star(segments, guarantee, stars, static_cast<Vertex>(v), findings);
  }
}

}  // namespace ar3d::verify
