// Judges the pairs that a crossing test names, and reports forbidden ones sorted by number. So all
// tests give the same list, whatever the order in which they find pairs.
#include "ar3d/verify/crossings/contacts.h"

#include "ar3d/verify/predicates/widths.h"

namespace ar3d::verify {

namespace {

/// Returns what decides every meeting of the drawing: by the extents of its box.
IntegerWidth width_of(const Segments& segments) {
  if (segments.size() == 0) return IntegerWidth::int64;
  GrowingBox box;
  for (SegmentId s = 0; s < segments.size(); ++s) {
    box.add(segments.from(s));
    box.add(segments.to(s));
  }
  Reach extents;
  extents.add(box.high() - box.low());
  return width_of_bits(predicate_bits(extents, extents, kCubeLattice, {}).meeting);
}

}  // namespace

Contacts::Contacts(const Segments& segments, Findings& findings, std::uint64_t most_comparisons)
    : segments_(segments),
      findings_(findings),
      limit_(findings.room()),
      left_(most_comparisons == 0 ? std::numeric_limits<std::uint64_t>::max() : most_comparisons),
      width_(width_of(segments)) {}

void Contacts::examine(SegmentId a, SegmentId b) {
  spend(1);
  if (done()) return;
  if (a > b) std::swap(a, b);
  const Meeting meeting =
      meet(segments_.from(a), segments_.to(a), segments_.from(b), segments_.to(b), width_);
  if (meeting.kind == MeetingKind::nothing) return;
  if (is_forbidden(a, b, meeting)) crossings_.emplace(a, b);
}

bool Contacts::is_forbidden(SegmentId a, SegmentId b, const Meeting& meeting) const {
  if (meeting.kind == MeetingKind::overlap || !meeting.at) return true;
  if (segments_.edge(a) == segments_.edge(b) && b == a + 1)
    return false;  // only their bend is common
  const auto end_of_a = segments_.vertex_at(a, *meeting.at);
  const auto end_of_b = segments_.vertex_at(b, *meeting.at);
  // One vertex: allowed. Two vertices at one point: reported as such.
  if (end_of_a && end_of_b) return false;
  const auto is_foreign = [&](Vertex v, SegmentId s) {
    const Edge ends = segments_.drawing().edge(segments_.edge(s));
    return v != ends.u && v != ends.v;
  };
  // Reported as vertex_on_edge, unless an edge passes through one of its own ends.
  if (end_of_a) return !is_foreign(*end_of_a, b);
  if (end_of_b) return !is_foreign(*end_of_b, a);
  return true;
}

void Contacts::examine_vertex(Vertex v, SegmentId s) {
  spend(1);
  const Edge ends = segments_.drawing().edge(segments_.edge(s));
  if (v == ends.u || v == ends.v) return;
  const Point p = segments_.drawing().vertex(v);
  if (done() || !on_segment(p, segments_.from(s), segments_.to(s))) return;
  if (segments_.vertex_at(s, p)) return;  // coinciding vertices, reported as such
  on_edges_.emplace(v, segments_.edge(s));
}

Violation Contacts::crossing(SegmentId a, SegmentId b) const {
  const Meeting meeting =
      meet(segments_.from(a), segments_.to(a), segments_.from(b), segments_.to(b), width_);
  Violation violation{ViolationKind::crossing, {}, {segments_.edge(a), segments_.edge(b)}, {}, {}};
  std::string what;
  if (meeting.kind == MeetingKind::overlap) {
    violation.points = {meeting.overlap[0], meeting.overlap[1]};
    what = fmt::format("overlap from {} to {}", to_string(meeting.overlap[0]),
                       to_string(meeting.overlap[1]));
  } else if (meeting.at) {
    violation.points = {*meeting.at};
    what = fmt::format("share {}", to_string(*meeting.at));
  } else {
    violation.points = {segments_.from(a), segments_.to(a), segments_.from(b), segments_.to(b)};
    what = "share a point off the lattice";
  }
  violation.message =
      fmt::format("{}; {}: they {}", segments_.describe(a), segments_.describe(b), what);
  return violation;
}

void Contacts::report() {
  for (const auto& [v, e] : on_edges_) {
    const Point p = segments_.drawing().vertex(v);
    findings_.add(ViolationKind::vertex_on_edge, {v}, {e}, {p}, "vertex {} at {} lies on {}", v,
                  to_string(p), describe_edge(segments_.drawing(), e));
  }
  for (const auto& [a, b] : crossings_) findings_.add(crossing(a, b));
}

}  // namespace ar3d::verify
