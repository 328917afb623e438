// Parts of a graph, their vertices numbered anew.
#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "ar3d/bench/corpus/corpus.h"

namespace ar3d {
namespace {

constexpr Vertex kAbsent = std::numeric_limits<Vertex>::max();

// new_name[v] is kAbsent for vertices that are left out.
Graph renamed(const Graph& graph, const std::vector<Vertex>& new_name, Vertex n) {
  std::vector<Edge> edges;
  for (const Edge edge : graph.edges()) {
    const Edge renamed{new_name[edge.u], new_name[edge.v]};
    if (renamed.u != kAbsent && renamed.v != kAbsent) edges.push_back(renamed);
  }
  return Graph(n, std::move(edges));
}

}  // namespace

Graph induced(const Graph& graph, const std::vector<bool>& keep) {
  std::vector<Vertex> new_name(graph.num_vertices(), kAbsent);
  Vertex n = 0;
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    if (keep[v]) new_name[v] = n++;
  }
  return renamed(graph, new_name, n);
}

Graph breadth_first_piece(const Graph& graph, std::uint64_t n) {
  if (n >= graph.num_vertices()) return graph;
  std::vector<Vertex> new_name(graph.num_vertices(), kAbsent);
  std::vector<Vertex> found;
  found.reserve(n);
  const auto find = [&](Vertex v) {
    if (found.size() == n || new_name[v] != kAbsent) return;
    new_name[v] = static_cast<Vertex>(found.size());
    found.push_back(v);
  };
  for (Vertex start = 0; found.size() < n; ++start) {
    std::size_t next = found.size();
    find(start);
    for (; next < found.size(); ++next) {
      for (const HalfEdge& half : graph.incident(found[next])) find(half.to);
    }
  }
  return renamed(graph, new_name, static_cast<Vertex>(n));
}

}  // namespace ar3d
