#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ar3d/model/drawing.h"

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

}  // namespace ar3d::verify
