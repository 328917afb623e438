// The smallest distance of two vertices: by strips, else by an R-tree, asked in random order. It is
// compared in integers of proved width. A randomised grid was dropped: 27 random look-ups a vertex.
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <numeric>

#include "ar3d/base/random.h"
#include "ar3d/verify/metrics/summary_pass.h"
#include "ar3d/verify/predicates/functional.h"

namespace ar3d::verify {
namespace {

namespace geometry = boost::geometry;

// Differences are at most 2^62, Gram entries below 2^31: nine terms are below 2^(124 + 31 + 4) =
// 2^159.
using Wide = boost::multiprecision::checked_int256_t;
using Item = std::pair<geometry::model::point<std::int64_t, 3, geometry::cs::cartesian>, Vertex>;

/// The places that may be as near to p as `squared`; beyond 2^61, where reach() ends, all. Sums are
/// below 2^63.
geometry::model::box<Item::first_type> box_around(Point p, double squared,
                                                  const std::array<double, 3>& inverse) {
  const auto far = [&](std::size_t axis) {
    const std::int64_t near = reach(squared, inverse[axis]);
    return near > kMaxCoordinate ? 2 * kMaxCoordinate : near;
  };
  const std::int64_t x = far(0), y = far(1), z = far(2);
  return {{p.x - x, p.y - y, p.z - z}, {p.x + x, p.y + y, p.z + z}};
}

}  // namespace

std::optional<VertexPair> closest_pair_by_tree(const Drawing& drawing) {
  if (drawing.num_vertices() < 2) return std::nullopt;
  drawing.lattice().validate();
  std::vector<Vertex> order(drawing.num_vertices());
  std::iota(order.begin(), order.end(), Vertex{0});
  std::vector<Item> items;
  items.reserve(order.size());
  for (const Vertex v : order) {
    const Point p = drawing.vertex(v);
    items.push_back({{p.x, p.y, p.z}, v});
  }
  const geometry::index::rtree<Item, geometry::index::linear<16>> tree(items);
  constexpr std::uint64_t kStream = 0x636c6f73;
  RandomStream(0, kStream).shuffle(std::span<Vertex>(order));
  const auto distance = [&](Vertex u, Vertex v) {
    return squared_length<Wide>(drawing.lattice(), drawing.vertex(u) - drawing.vertex(v));
  };
  const std::array<double, 3> inverse = inverse_diagonal(drawing.lattice());
  VertexPair best{order[0], order[1]};
  Wide smallest = distance(best.first, best.second);
  for (std::size_t i = 0; i < order.size() && smallest != 0; ++i) {
    const Vertex v = order[i];
    const auto look = [&](const Item& item) {
      const Vertex u = item.second;
      if (u == v) return;
      const Wide d = distance(u, v);
      if (d >= smallest) return;
      smallest = d;
      best = std::minmax(u, v);
    };
    const auto near = box_around(drawing.vertex(v), static_cast<double>(smallest), inverse);
    tree.query(geometry::index::intersects(near), boost::make_function_output_iterator(look));
  }
  return best;
}

std::optional<VertexPair> closest_pair(const Drawing& drawing) {
  if (drawing.num_vertices() < 2) return std::nullopt;
  drawing.lattice().validate();
  if (const auto pair = closest_pair_by_strips(drawing)) return pair;
  return closest_pair_by_tree(drawing);
}

}  // namespace ar3d::verify
