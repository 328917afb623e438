// Builds graphs and checks their edges. The check that accepts a good list is quick; only a bad one
// is searched again for the edge that the message names.
#include "ar3d/model/graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <boost/graph/breadth_first_search.hpp>
#include <set>

#include "ar3d/base/error.h"
#include "ar3d/base/hash_stream.h"
#include "ar3d/base/parallel.h"
#include "ar3d/model/boost_graph.h"
#include "ar3d/model/canonical_edges.h"

namespace ar3d {
namespace {

constexpr std::uint64_t kMaxVertices = std::numeric_limits<Vertex>::max() - 1;
constexpr std::uint64_t kMaxEdges =
    (std::uint64_t{1} << 31) - 1;  // 2m half-edges are indexed by 32 bits

void refuse_bad_ends(std::uint64_t n, const std::vector<Edge>& edges) {
  const auto is_bad = [n](Edge e) { return e.u >= n || e.v >= n || e.u == e.v; };
  std::atomic<bool> has_bad = false;
  for_ranges_in_threads(threads_for(edges.size()), edges.size(),
                        [&](std::uint32_t, std::size_t begin, std::size_t end) {
                          bool found = false;
                          for (std::size_t e = begin; e < end; ++e) found |= is_bad(edges[e]);
                          if (found) has_bad = true;
                        });
  if (!has_bad) return;
  const auto bad =
      static_cast<std::size_t>(std::find_if(edges.begin(), edges.end(), is_bad) - edges.begin());
  const auto [u, v] = edges[bad];
  if (u == v && u < n) {
    throw EdgeError(bad, u, v, fmt::format("edge {} ({}, {}) is a loop", bad, u, v));
  }
  throw EdgeError(
      bad, u, v,
      fmt::format("edge {} ({}, {}): vertex {} is out of range, the graph has {} vertices", bad, u,
                  v, u >= n ? u : v, n));
}

/// Boost's colours of a search that numbers components: white is a vertex without a number.
struct NumberedColours {
  static constexpr std::uint32_t kUnseen = std::numeric_limits<std::uint32_t>::max();
  using key_type = Vertex;
  using value_type = boost::default_color_type;
  using reference = value_type;
  using category = boost::read_write_property_map_tag;
  friend value_type get(const NumberedColours& colours, Vertex v) {
    return colours.components->of[v] == kUnseen ? boost::white_color : boost::black_color;
  }
  friend void put(const NumberedColours& colours, Vertex v, value_type) {
    colours.components->of[v] = colours.components->count;
  }

  Components* components;
};

}  // namespace

Graph::Graph(std::uint64_t num_vertices, std::vector<Edge> edges) {
  if (num_vertices > kMaxVertices) {
    throw InputError(
        fmt::format("{} vertices are too many, the limit is {}", num_vertices, kMaxVertices));
  }
  if (edges.size() > kMaxEdges) {
    throw InputError(
        fmt::format("{} edges are too many, the limit is {}", edges.size(), kMaxEdges));
  }
  refuse_bad_ends(num_vertices, edges);
  const std::uint64_t repeating = make_canonical(num_vertices, edges);
  edges_ = std::make_shared<const std::vector<Edge>>(std::move(edges));
  if (repeating != num_vertices) refuse_parallel_edges(repeating);
  max_degree_ = make_adjacency_lists(num_vertices, *edges_, offsets_, half_edges_);
}

void Graph::refuse_parallel_edges(std::uint64_t repeating) const {
  std::set<Vertex> seen;
  EdgeId e = 0;
  for (;; ++e) {
    expect(e < num_edges(), "a repeated edge stands in the list");
    const auto [u, v] = edge(e);
    if (std::min(u, v) == repeating && !seen.insert(std::max(u, v)).second) break;
  }
  const auto [u, v] = edge(e);
  throw EdgeError(e, u, v, fmt::format("edge {} ({}, {}) is parallel to an earlier edge", e, u, v));
}

std::string graph_hash(const Graph& graph) {
  HashStream hash;
  hash.put(graph.num_vertices());
  for (const auto [u, v] : graph.edges()) {
    hash.put(u);
    hash.put(v);
  }
  return hash.digest();
}

Graph relabelled(const Graph& graph, std::span<const Vertex> new_name) {
  const Vertex n = graph.num_vertices();
  std::vector<bool> taken(n, false);
  if (new_name.size() != n) {
    throw InputError(fmt::format("{} new names for {} vertices", new_name.size(), n));
  }
  for (const Vertex name : new_name) {
    if (name >= n || taken[name]) {
      throw InputError(fmt::format("new name {} is out of range or given twice", name));
    }
    taken[name] = true;
  }
  std::vector<Edge> edges(graph.edges().begin(), graph.edges().end());
  for (Edge& e : edges) e = {new_name[e.u], new_name[e.v]};
  return Graph(n, std::move(edges));
}

Components connected_components_of(const Graph& graph) {
  Components result;
  result.of.assign(graph.num_vertices(), NumberedColours::kUnseen);
  boost::queue<Vertex> queue;
  for (Vertex start = 0; start < graph.num_vertices(); ++start) {
    if (result.of[start] != NumberedColours::kUnseen) continue;
    boost::breadth_first_visit(graph, start, queue, boost::default_bfs_visitor(),
                               NumberedColours{&result});
    ++result.count;
  }
  return result;
}

std::vector<bool> in_largest_component(const Graph& graph) {
  const Components components = connected_components_of(graph);
  std::vector<Vertex> sizes(components.count);
  for (const std::uint32_t component : components.of) ++sizes[component];
  const auto largest = std::max_element(sizes.begin(), sizes.end()) - sizes.begin();
  std::vector<bool> inside(graph.num_vertices());
  for (Vertex v = 0; v < graph.num_vertices(); ++v) inside[v] = components.of[v] == largest;
  return inside;
}

}  // namespace ar3d
