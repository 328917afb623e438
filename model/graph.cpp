#include "ar3d/model/graph.h"

#include <fmt/format.h>

#include <limits>

#include "ar3d/model/error.h"
#include "ar3d/model/hash_stream.h"

namespace ar3d {
namespace {

constexpr std::uint64_t kMaxVertices = std::numeric_limits<Vertex>::max() - 1;
constexpr std::uint64_t kMaxEdges =
    (std::uint64_t{1} << 31) - 1;  // 2m half-edges are indexed by 32 bits

void refuse_bad_ends(std::uint64_t n, const std::vector<Edge>& edges) {
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto [u, v] = edges[e];
    if (u >= n || v >= n) {
      throw EdgeError(
          e, u, v,
          fmt::format("edge {} ({}, {}): vertex {} is out of range, the graph has {} vertices", e,
                      u, v, u >= n ? u : v, n));
    }
    if (u == v) throw EdgeError(e, u, v, fmt::format("edge {} ({}, {}) is a loop", e, u, v));
  }
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
  offsets_.assign(num_vertices + 1, 0);
  edges_ = std::make_shared<const std::vector<Edge>>(std::move(edges));
  build_rows();
  refuse_parallel_edges();
}

void Graph::build_rows() {
  for (const auto [u, v] : *edges_) {
    ++offsets_[u];
    ++offsets_[v];
  }
  std::uint32_t end = 0;
  for (std::uint32_t& entry :
       offsets_) {  // exclusive sums, shifted below while the rows are filled
    max_degree_ = std::max(max_degree_, entry);
    end += entry;
    entry = end;
  }
  half_edges_.resize(2 * edges_->size());
  for (std::size_t i = edges_->size(); i-- > 0;) {  // backwards, so that rows stand in input order
    const auto [u, v] = (*edges_)[i];
    half_edges_[--offsets_[u]] = {v, static_cast<EdgeId>(i)};
    half_edges_[--offsets_[v]] = {u, static_cast<EdgeId>(i)};
  }
}

void Graph::refuse_parallel_edges() const {
  constexpr Vertex kNobody = std::numeric_limits<Vertex>::max();
  std::vector<Vertex> stamp;  // only rows too long for the quadratic test need it
  for (Vertex v = 0; v < num_vertices(); ++v) {
    const auto row = incident(v);
    const auto refuse = [&](const HalfEdge& again) {
      const auto [a, b] = edge(again.edge);
      throw EdgeError(
          again.edge, a, b,
          fmt::format("edge {} ({}, {}) is parallel to an earlier edge", again.edge, a, b));
    };
    if (row.size() <= 8) {
      for (std::size_t i = 1; i < row.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          if (row[i].to == row[j].to) refuse(row[i]);
        }
      }
      continue;
    }
    if (stamp.empty()) stamp.assign(num_vertices(), kNobody);
    for (const HalfEdge& half : row) {
      if (stamp[half.to] == v) refuse(half);
      stamp[half.to] = v;
    }
  }
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
