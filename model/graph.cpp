#include "ar3d/model/graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "ar3d/model/error.h"
#include "ar3d/model/graph_rows.h"
#include "ar3d/model/hash_stream.h"

namespace ar3d {
namespace {

constexpr std::uint64_t kMaxVertices = std::numeric_limits<Vertex>::max() - 1;
constexpr std::uint64_t kMaxEdges =
    (std::uint64_t{1} << 31) - 1;  // 2m half-edges are indexed by 32 bits

void refuse_bad_ends(std::uint64_t n, const std::vector<Edge>& edges) {
  std::size_t bad = edges.size();
  const int threads = threads_for(edges.size());
#pragma omp parallel for schedule(static) reduction(min : bad) num_threads(threads)
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto [u, v] = edges[e];
    if (u >= n || v >= n || u == v) bad = std::min(bad, e);
  }
  if (bad == edges.size()) return;
  const auto [u, v] = edges[bad];
  if (u == v && u < n) {
    throw EdgeError(bad, u, v, fmt::format("edge {} ({}, {}) is a loop", bad, u, v));
  }
  throw EdgeError(
      bad, u, v,
      fmt::format("edge {} ({}, {}): vertex {} is out of range, the graph has {} vertices", bad, u,
                  v, u >= n ? u : v, n));
}

/// Rows up to this length are searched for parallel edges by comparing all pairs.
constexpr std::size_t kShortRow = 8;

/// Where the first neighbour that stands in the row before stands again; row.size() if none does.
std::size_t first_repeat(std::span<const HalfEdge> row) {
  for (std::size_t i = 1; i < row.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (row[i].to == row[j].to) return i;
    }
  }
  return row.size();
}

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
  edges_ = std::make_shared<const std::vector<Edge>>(std::move(edges));
  Rows rows = rows_of(num_vertices, *edges_);
  offsets_ = std::move(rows.offsets);
  half_edges_ = std::move(rows.half_edges);
  max_degree_ = rows.max_degree;
  refuse_parallel_edges();
}

void Graph::refuse_parallel_edges() const {
  Vertex bad = num_vertices();
  bool long_rows = false;
  const int threads = threads_for(half_edges_.size());
#pragma omp parallel for schedule(static) num_threads(threads) reduction(min    \
                                                                         : bad) \
    reduction(||                                                                \
              : long_rows)
  for (Vertex v = 0; v < num_vertices(); ++v) {
    const auto row = incident(v);
    if (row.size() > kShortRow) {
      long_rows = true;
    } else if (first_repeat(row) != row.size()) {
      bad = std::min(bad, v);
    }
  }
  std::size_t place = bad < num_vertices() ? first_repeat(incident(bad)) : 0;
  if (long_rows) {
    std::vector<Vertex> stamp(num_vertices(), num_vertices());
    for (Vertex v = 0; v < bad; ++v) {
      const auto row = incident(v);
      for (std::size_t i = 0; row.size() > kShortRow && i < row.size() && v < bad; ++i) {
        if (std::exchange(stamp[row[i].to], v) != v) continue;
        bad = v;
        place = i;
      }
    }
  }
  if (bad == num_vertices()) return;
  const EdgeId e = incident(bad)[place].edge;
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
  constexpr std::uint32_t kUnseen = std::numeric_limits<std::uint32_t>::max();
  Components result;
  result.of.assign(graph.num_vertices(), kUnseen);
  std::vector<Vertex> stack;
  for (Vertex start = 0; start < graph.num_vertices(); ++start) {
    if (result.of[start] != kUnseen) continue;
    result.of[start] = result.count;
    stack.push_back(start);
    while (!stack.empty()) {
      const Vertex v = stack.back();
      stack.pop_back();
      for (const HalfEdge& half : graph.incident(v)) {
        if (result.of[half.to] != kUnseen) continue;
        result.of[half.to] = result.count;
        stack.push_back(half.to);
      }
    }
    ++result.count;
  }
  return result;
}

}  // namespace ar3d
