// The end of Step 2.11: points and bends of the finished drawing, 32 bytes per edge; components are
// stacked in z. Bends are kept from the lower end of an edge to the upper, so the order of the
// input's ends does not matter. Cost: O(1) per vertex and edge.
#include "ar3d/algorithms/two_bend/output.h"

namespace ar3d::two_bend {

void PackedBends::append_bends(EdgeId e, Edge, Point at_u, Point at_v,
                               std::vector<Point>& out) const {
  const LongBends& bends = of_edge[e];
  const bool downwards = bends.count() == 2 && is_below(at_v, at_u);
  for (std::size_t i = 0; i < bends.count(); ++i) out.push_back(bends[downwards ? 1 - i : i]);
}

void Output::set_bends(EdgeId e, std::span<const Point> bends) {
  LongBends packed;
  for (const Point& bend : bends) packed.add_upper(bend);
  this->bends(e) = packed;
}

void Output::make_room(std::size_t vertices, std::int64_t top) {
  if (vertices_ || !points_.empty()) return;
  if (vertices == graph_.num_vertices() && top > std::numeric_limits<std::int32_t>::max()) {
    vertices_.emplace(vertices, kMaxCoordinate);
  } else {
    points_.resize(graph_.num_vertices());
  }
}

void Output::end_component(std::int64_t top) {
  expect(top >= base_z_ && top < kMaxCoordinate, "heights fit the largest coordinate");
  base_z_ = top + 1;
}

Drawing Output::finish() {
  if (!vertices_) {
    vertices_.emplace(points_.size(), largest_);
    vertices_->fill(0, points_.size(), [&](std::size_t v) { return points_[v]; });
  }
  return Drawing("two-bend", kScaledZLattice, *std::move(vertices_), graph_.shared_edges(),
                 std::move(bends_));
}

}  // namespace ar3d::two_bend
