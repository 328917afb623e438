#pragma once

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

}  // namespace ar3d::verify
