#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "ar3d/model/drawing.h"
#include "ar3d/verify/predicates/exact.h"
#include "ar3d/verify/violation.h"

namespace ar3d::verify {

using SegmentId = std::uint32_t;

/// All segments of a drawing, edge after edge in the order of the polylines, without those of
/// length zero. 24 bytes per point and 4 per segment.
class Segments {
 public:
  /// @pre every coordinate is in range.
  /// @throws InputError if the drawing has 2^32 - 1 points or more.
  explicit Segments(const Drawing& drawing);

  std::size_t size() const { return edge_.size(); }
  EdgeId edge(SegmentId s) const { return edge_[s]; }
  // Every edge has one point more than it has segments, hence the shift by the edge's number.
  Point from(SegmentId s) const { return points_[std::size_t{s} + edge_[s]]; }
  Point to(SegmentId s) const { return points_[std::size_t{s} + edge_[s] + 1]; }
  Vector direction(SegmentId s) const { return to(s) - from(s); }
  bool is_first(SegmentId s) const { return s == 0 || edge_[s - 1] != edge_[s]; }
  bool is_last(SegmentId s) const { return s + 1 == edge_.size() || edge_[s + 1] != edge_[s]; }

  const Drawing& drawing() const { return *drawing_; }
  /// The vertex at which segment s begins or ends at point p, if any: p must be an end of s.
  std::optional<Vertex> vertex_at(SegmentId s, Point p) const;
  /// "edge 7 (2-5), segment (0, 0, 0) to (1, 1, 1)"
  std::string describe(SegmentId s) const;

 private:
  const Drawing* drawing_;
  std::vector<Point> points_;
  std::vector<EdgeId> edge_;
};

/// "edge 7 (2-5)"
std::string describe_edge(const Drawing& drawing, EdgeId e);

/// Judges the meetings that a crossing test finds, and reports the forbidden ones in an order that
/// does not depend on the test. A test only has to name every pair that meets, at least once.
///
/// Two segments may share exactly one point if that is the bend between them or a vertex at which
/// both edges end. A vertex of one edge inside another edge is reported once, as vertex_on_edge,
/// and coinciding vertices by the check of the vertices; everything else in common is a crossing.
class Contacts {
 public:
  /// Looks for the narrowest integers that decide every meeting of the drawing. O(S).
  /// @param most_comparisons  to be made; 0: no limit.
  Contacts(const Segments& segments, Findings& findings, std::uint64_t most_comparisons = 0);

  std::function<void(std::uint64_t pairs)> compares;  ///< CertifyOptions::compares

  /// Two different segments that may meet.
  void examine(SegmentId a, SegmentId b);
  /// A vertex that may lie on a segment.
  void examine_vertex(Vertex v, SegmentId s);

  /// Comparisons that the test has made itself, beside those above, which count as one each.
  void spend(std::uint64_t comparisons) { left_ -= std::min(left_, comparisons); }
  std::uint64_t comparisons_left() const { return left_; }
  /// True once there were too many comparisons: not everything was looked for.
  bool gave_up() const { return left_ == 0; }
  /// True once enough is found, or too much was compared: the test may stop.
  bool done() const { return left_ == 0 || crossings_.size() + on_edges_.size() > limit_; }
  /// Hands everything to the findings: vertices on edges, then crossings, in order of their
  /// numbers.
  void report();

 private:
  bool is_forbidden(SegmentId a, SegmentId b, const Meeting& meeting) const;
  Violation crossing(SegmentId a, SegmentId b) const;

  const Segments& segments_;
  Findings& findings_;
  std::size_t limit_;
  std::uint64_t left_;  ///< comparisons
  IntegerWidth width_;
  std::set<std::pair<SegmentId, SegmentId>> crossings_;
  std::set<std::pair<Vertex, EdgeId>> on_edges_;
};

// Each test names every pair of segments that meets, and every vertex on a segment, to `contacts`.

/// The oracle: every pair. O(S (S + n)) time, a box per segment.
void test_all_pairs(const Segments& segments, Contacts& contacts);

/// Searches for near pairs, by halving space. O((S + n) log S) time
/// where segments are short, at most quadratic (Lemma V.8); O(S + n) memory.
void test_by_halving(const Segments& segments, Contacts& contacts);

}  // namespace ar3d::verify
