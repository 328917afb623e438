// The end of Step 2.11: points and bends of the finished drawing, 32 bytes per edge; components are
// stacked in z. Bends are kept from the lower end of an edge to the upper, so the order of the
// input's ends does not matter. Cost: O(1) per vertex and edge.
#include "ar3d/algorithms/two_bend/output.h"

#include "ar3d/base/error.h"

namespace ar3d::two_bend {
namespace {

std::int32_t narrow(std::int64_t value) {
  expect(value >= std::numeric_limits<std::int32_t>::min() &&
             value <= std::numeric_limits<std::int32_t>::max(),
         "rows and columns fit 32 bits");
  return static_cast<std::int32_t>(value);
}

}  // namespace

void PackedBends::set(EdgeId e, std::span<const Point> bends) {
  expect(bends.size() <= 2, "an edge has at most two bends");
  Places places{{}, {kNoBend, kNoBend}};
  for (std::size_t i = 0; i < bends.size(); ++i) {
    places.xy[2 * i] = narrow(bends[i].x);
    places.xy[2 * i + 1] = narrow(bends[i].y);
    places.z[i] = bends[i].z;
  }
  places_[e] = places;
}

void PackedBends::append_bends(EdgeId e, Edge, Point at_u, Point at_v,
                               std::vector<Point>& out) const {
  const Places& places = places_[e];
  const auto append = [&](std::size_t i) {
    out.push_back({places.xy[2 * i], places.xy[2 * i + 1], places.z[i]});
  };
  const std::size_t count = std::size_t{places.z[0] != kNoBend} + (places.z[1] != kNoBend);
  if (count == 2 && is_below(at_v, at_u)) {
    append(1);
    append(0);
  } else {
    for (std::size_t i = 0; i < count; ++i) append(i);
  }
}

void Output::make_room(std::size_t vertices, std::int64_t top) {
  if (bends_ != nullptr) return;
  bends_ = std::make_shared<PackedBends>(graph_.num_edges());
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
  make_room(0, 0);  // for a graph without vertices
  if (!vertices_) {
    vertices_.emplace(points_.size(), largest_);
    for (std::size_t v = 0; v < points_.size(); ++v) vertices_->set(v, points_[v]);
  }
  return Drawing("two-bend", kScaledZLattice, *std::move(vertices_), graph_.shared_edges(),
                 std::move(bends_));
}

}  // namespace ar3d::two_bend
