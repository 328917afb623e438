#pragma once

#include <cstddef>
#include <set>
#include <utility>

#include "ar3d/verify/exact.h"
#include "ar3d/verify/findings.h"
#include "ar3d/verify/segments.h"

namespace ar3d::verify {

/// Judges the meetings that a crossing test finds, and reports the forbidden ones in an order that
/// does not depend on the test. A test only has to name every pair that meets, at least once.
///
/// Two segments may share exactly one point if that is the bend between them or a vertex at which
/// both edges end. A vertex of one edge inside another edge is reported once, as vertex_on_edge,
/// and coinciding vertices by the check of the vertices; everything else in common is a crossing.
class Contacts {
 public:
  /// Looks for the narrowest integers that decide every meeting of the drawing. O(S).
  Contacts(const Segments& segments, Findings& findings);

  /// Two different segments that may meet.
  void examine(SegmentId a, SegmentId b);
  /// A vertex that may lie on a segment.
  void examine_vertex(Vertex v, SegmentId s);

  /// True once enough is found: the test may stop.
  bool done() const { return crossings_.size() + on_edges_.size() > limit_; }
  /// Hands everything to the findings: vertices on edges, then crossings, in order of their
  /// numbers.
  void report();

 private:
  bool is_forbidden(SegmentId a, SegmentId b, const Meeting& meeting) const;
  Violation crossing(SegmentId a, SegmentId b) const;

  const Segments& segments_;
  Findings& findings_;
  std::size_t limit_;
  IntegerWidth width_;
  std::set<std::pair<SegmentId, SegmentId>> crossings_;
  std::set<std::pair<Vertex, EdgeId>> on_edges_;
};

}  // namespace ar3d::verify
