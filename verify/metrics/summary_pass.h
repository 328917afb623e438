#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "ar3d/model/drawing.h"
#include "ar3d/verify/metrics/metrics.h"

namespace ar3d::verify {

/// Grows a DrawingSummary polyline by polyline.
class SummaryPass {
 public:
  /// Takes the vertices of the drawing. @param lengths  are lengths and distances wanted?
  SummaryPass(const Drawing& drawing, bool lengths);
  /// Makes the pass over a part of the drawing, for another pass to absorb: nothing is taken yet.
  explicit SummaryPass(const Drawing& drawing) : drawing_(drawing), lengths_(false) {}
  /// Takes the vertices begin, ..., end - 1.
  void add_vertices(Vertex begin, Vertex end);
  /// Takes the polyline of the next edge, in order of edge numbers: sums of doubles depend on it.
  void add(const std::vector<Point>& points);
  /// Takes what another pass over the same drawing has of other edges and vertices.
  /// @pre lengths are not wanted.
  void absorb(const SummaryPass& other);
  /// After the last edge. Finds the closest vertices, if lengths are wanted.
  /// @throws InputError if they are and the drawing's Gram matrix is not positive definite.
  DrawingSummary finish();

 private:
  void add_lengths(const std::vector<Point>& points);
  void set_relative_volume();
  bool in_range() const { return ar3d::in_range(box_.low()) && ar3d::in_range(box_.high()); }

  const Drawing& drawing_;
  const bool lengths_;
  GrowingBox box_;
  DrawingSummary summary_;
};

/// measure() of a drawing in a real type: the metrics of its exact points, the box rounded outwards
/// to integers.
DrawingSummary measure_real(const Drawing& drawing);

using VertexPair = std::pair<Vertex, Vertex>;

/// Two vertices at the smallest distance in the drawing's metric; nothing if there are fewer than
/// two. Distances are compared exactly. By strips where these apply, else by the tree: the same
/// distance, not always the same of several closest pairs.
/// @throws InputError if the drawing's Gram matrix is not positive definite.
std::optional<VertexPair> closest_pair(const Drawing& drawing);

/// The plain version, for vertices in range: an R-tree gives those near each vertex, in a fixed
/// random order, so that few are. O(n log^2 n) expected time where vertices are spread evenly.
std::optional<VertexPair> closest_pair_by_tree(const Drawing& drawing);

/// A radix sort along the widest axis, strips as wide as a distance that was seen, each sorted
/// along the second widest. O(n log n) time besides the pairs that are looked at, 16 bytes per
/// vertex (32 if an extent passes 2^32); nothing if the pairs are more than 60 per vertex, if the
/// smallest squared distance passes 2^40, in units of the Gram matrix, or if the coordinates are
/// not in_range().
/// @pre two vertices at least, and a positive definite Gram matrix.
std::optional<VertexPair> closest_pair_by_strips(const Drawing& drawing);

}  // namespace ar3d::verify
