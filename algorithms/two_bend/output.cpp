#include "ar3d/algorithms/two_bend/output.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "ar3d/model/error.h"

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
  counts_[e] = static_cast<std::uint8_t>(bends.size());
  Places& places = places_[e];
  for (std::size_t i = 0; i < bends.size(); ++i) {
    places.xy[2 * i] = narrow(bends[i].x);
    places.xy[2 * i + 1] = narrow(bends[i].y);
    places.z[i] = bends[i].z;
  }
}

void PackedBends::append_bends(EdgeId e, Edge, Point, Point, std::vector<Point>& out) const {
  const Places& places = places_[e];
  for (std::size_t i = 0; i < counts_[e]; ++i) {
    out.push_back({places.xy[2 * i], places.xy[2 * i + 1], places.z[i]});
  }
}

Output::Output(const Graph& graph)
    : graph_(graph),
      points_(graph.num_vertices()),
      bends_(std::make_shared<PackedBends>(graph.num_edges())) {}

void Output::end_component(std::int64_t top) {
  expect(top >= base_z_ && top < kMaxCoordinate, "heights fit the largest coordinate");
  base_z_ = top + 1;
}

void Output::set_vertex(Vertex v, Point p) {
  points_[v] = p;
  largest_ = std::max({largest_, p.x, p.y, p.z});
}

void Output::set_bends(EdgeId e, Vertex from, std::span<const Point> bends) {
  if (graph_.edge(e).u == from || bends.size() < 2) {
    bends_->set(e, bends);
  } else {
    bends_->set(e, std::array<Point, 2>{bends[1], bends[0]});
  }
}

Drawing Output::finish() {
  Coordinates vertices(points_.size(), largest_);
  for (std::size_t v = 0; v < points_.size(); ++v) vertices.set(v, points_[v]);
  return Drawing("two-bend", kTallLattice, std::move(vertices), graph_.shared_edges(),
                 std::move(bends_));
}

}  // namespace ar3d::two_bend
