// Isomorphisms of small graphs by trying: images are chosen vertex by vertex, and each has to agree
// with those before it.
#include "ar3d/model/isomorphism.h"

#include <algorithm>

namespace ar3d {
namespace {

bool are_adjacent(const Graph& graph, Vertex u, Vertex v) {
  return std::ranges::find(graph.incident(u), v, &HalfEdge::to) != graph.incident(u).end();
}

}  // namespace

std::optional<std::vector<Vertex>> find_isomorphism(
    const Graph& from, const Graph& to, std::span<const Vertex> order,
    const std::function<bool(Vertex, Vertex)>& may_be) {
  const Vertex n = from.num_vertices();
  if (to.num_vertices() != n || to.num_edges() != from.num_edges()) return std::nullopt;
  std::vector<Vertex> image(n);
  std::vector<bool> used(n);
  const auto fits = [&](std::size_t at, Vertex x) {
    const Vertex v = order[at];
    return !used[x] && from.degree(v) == to.degree(x) && may_be(v, x) &&
           std::ranges::all_of(order.first(at), [&](Vertex u) {
             return are_adjacent(from, u, v) == are_adjacent(to, image[u], x);
           });
  };
  const std::function<bool(std::size_t)> extend = [&](std::size_t at) {
    if (at == order.size()) return true;
    for (Vertex x = 0; x < n; ++x) {
      if (!fits(at, x)) continue;
      image[order[at]] = x;
      used[x] = true;
      if (extend(at + 1)) return true;
      used[x] = false;
    }
    return false;
  };
  return extend(0) ? std::optional(image) : std::nullopt;
}

}  // namespace ar3d
