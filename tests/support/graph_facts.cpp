#include "support/graph_facts.h"

#include <algorithm>
#include <boost/graph/biconnected_components.hpp>
#include <boost/graph/bipartite.hpp>
#include <boost/graph/boyer_myrvold_planar_test.hpp>
#include <boost/graph/connected_components.hpp>
#include <limits>
#include <vector>

#include "ar3d/model/boost_graph.h"

namespace ar3d::testing {
namespace {

constexpr std::uint32_t kUnseen = std::numeric_limits<std::uint32_t>::max();

/// Distances from `start`, and the shortest cycle length seen on the way (exact over all starts).
struct Search {
  std::vector<std::uint32_t> distance;
  std::uint32_t shortest_cycle = kUnseen;
  std::uint32_t farthest = 0;
};

Search search_from(const Graph& graph, Vertex start) {
  Search result;
  result.distance.assign(graph.num_vertices(), kUnseen);
  std::vector<EdgeId> by(graph.num_vertices(), kUnseen);
  std::vector<Vertex> queue = {start};
  result.distance[start] = 0;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const Vertex v = queue[i];
    result.farthest = result.distance[v];
    for (const HalfEdge& half : graph.incident(v)) {
      if (half.edge == by[v]) continue;
      if (result.distance[half.to] == kUnseen) {
        result.distance[half.to] = result.distance[v] + 1;
        by[half.to] = half.edge;
        queue.push_back(half.to);
      } else {
        result.shortest_cycle =
            std::min(result.shortest_cycle, result.distance[v] + result.distance[half.to] + 1);
      }
    }
  }
  return result;
}

bool connected_without(const Graph& graph, const std::vector<bool>& removed) {
  std::vector<Vertex> stack;
  std::vector<bool> seen = removed;
  for (Vertex v = 0; v < graph.num_vertices() && stack.empty(); ++v) {
    if (!removed[v]) stack.push_back(v);
  }
  if (!stack.empty()) seen[stack.front()] = true;
  while (!stack.empty()) {
    const Vertex v = stack.back();
    stack.pop_back();
    for (const HalfEdge& half : graph.incident(v)) {
      if (seen[half.to]) continue;
      seen[half.to] = true;
      stack.push_back(half.to);
    }
  }
  return std::count(seen.begin(), seen.end(), false) == 0;
}

bool has_cut(const Graph& graph, std::uint32_t size, Vertex first, std::vector<bool>& removed) {
  if (size == 0) return !connected_without(graph, removed);
  for (Vertex v = first; v < graph.num_vertices(); ++v) {
    removed[v] = true;
    const bool cut = has_cut(graph, size - 1, v + 1, removed);
    removed[v] = false;
    if (cut) return true;
  }
  return false;
}

/// Colours edges along `order`; used[v] is the set of colours at v.
bool colour_from(const Graph& graph, const std::vector<EdgeId>& order, std::size_t i,
                 std::vector<unsigned>& used) {
  if (i == order.size()) return true;
  const Edge e = graph.edge(order[i]);
  const unsigned colours = i == 0 ? 1u : 3u;  // the first edge's colour is free to choose
  for (unsigned c = 0; c < colours; ++c) {
    const unsigned bit = 1u << c;
    if ((used[e.u] | used[e.v]) & bit) continue;
    used[e.u] |= bit;
    used[e.v] |= bit;
    if (colour_from(graph, order, i + 1, used)) return true;
    used[e.u] ^= bit;
    used[e.v] ^= bit;
  }
  return false;
}

}  // namespace

std::map<std::uint32_t, std::uint64_t> degree_counts(const Graph& graph) {
  std::map<std::uint32_t, std::uint64_t> counts;
  for (Vertex v = 0; v < graph.num_vertices(); ++v) ++counts[graph.degree(v)];
  return counts;
}

std::uint64_t components(const Graph& graph) {
  std::vector<std::uint32_t> component(graph.num_vertices());
  return boost::connected_components(
      graph, boost::make_iterator_property_map(component.begin(), get(boost::vertex_index, graph)));
}

std::uint64_t bridges(const Graph& graph) {
  std::vector<std::size_t> block(graph.num_edges());
  const std::size_t count = boost::biconnected_components(
      graph, boost::make_iterator_property_map(block.begin(), get(boost::edge_index, graph)));
  std::vector<std::uint32_t> edges_of(count, 0);
  for (const std::size_t b : block) ++edges_of[b];
  return static_cast<std::uint64_t>(std::count(edges_of.begin(), edges_of.end(), 1u));
}

std::uint32_t girth(const Graph& graph) {
  std::uint32_t best = kUnseen;
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    best = std::min(best, search_from(graph, v).shortest_cycle);
  }
  return best == kUnseen ? 0 : best;
}

std::uint32_t diameter(const Graph& graph) {
  std::uint32_t longest = 0;
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    longest = std::max(longest, search_from(graph, v).farthest);
  }
  return longest;
}

bool bipartite(const Graph& graph) { return boost::is_bipartite(graph); }

bool planar(const Graph& graph) { return boost::boyer_myrvold_planarity_test(graph); }

std::uint32_t connectivity(const Graph& graph, std::uint32_t limit) {
  std::vector<bool> removed(graph.num_vertices(), false);
  for (std::uint32_t size = 0; size < limit; ++size) {
    if (size + 1 >= graph.num_vertices()) return graph.num_vertices() == 0 ? 0 : size;
    if (has_cut(graph, size, 0, removed)) return size;
  }
  return limit;
}

bool three_edge_colourable(const Graph& graph) {
  std::vector<EdgeId> order;  // edges in breadth-first order, so that conflicts show early
  std::vector<bool> taken(graph.num_edges(), false);
  std::vector<bool> seen(graph.num_vertices(), false);
  for (Vertex start = 0; start < graph.num_vertices(); ++start) {
    if (seen[start]) continue;
    std::vector<Vertex> queue = {start};
    seen[start] = true;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      for (const HalfEdge& half : graph.incident(queue[i])) {
        if (!taken[half.edge]) order.push_back(half.edge);
        taken[half.edge] = true;
        if (!seen[half.to]) queue.push_back(half.to);
        seen[half.to] = true;
      }
    }
  }
  std::vector<unsigned> used(graph.num_vertices(), 0);
  return colour_from(graph, order, 0, used);
}

}  // namespace ar3d::testing
