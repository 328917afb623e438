#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "ar3d/base/long_vector.h"

namespace ar3d {

using Vertex = std::uint32_t;
using EdgeId = std::uint32_t;

struct Edge {
  Vertex u = 0;
  Vertex v = 0;
  friend bool operator==(const Edge&, const Edge&) = default;
};

/// One end of an edge as seen from a vertex: the other end and the edge's number.
struct HalfEdge {
  Vertex to = 0;
  EdgeId edge = 0;
  friend bool operator==(const HalfEdge&, const HalfEdge&) = default;
};

/// A simple, undirected, immutable graph with vertices 0..n-1, stored as compressed rows. Edges are
/// pairs (u, v) with u < v, numbered in ascending order of (u, v) however they came; half-edges of
/// a vertex ascend by neighbour, hence by edge. 4(n+1) + 24 m bytes. Copies share the edge list.
class Graph {
 public:
  /// The graph without vertices.
  Graph() : Graph(0, {}) {}

  /// @param num_vertices  n < 2^32 - 1.
  /// @param edges  m < 2^31 pairs of ids below n in any order, no loops, no pair twice either way.
  /// @throws EdgeError naming the offending edge (its index in `edges`) and value, InputError if
  /// too many. Cost: O(n + m log D), D the largest degree, on all threads; memory: make_canonical.
  Graph(std::uint64_t num_vertices, std::vector<Edge> edges);

  Vertex num_vertices() const { return static_cast<Vertex>(offsets_.size() - 1); }
  EdgeId num_edges() const { return static_cast<EdgeId>(edges_->size()); }
  /// Largest degree; 0 if there are no edges.
  std::uint32_t max_degree() const { return max_degree_; }
  std::uint32_t degree(Vertex v) const { return offsets_[v + 1] - offsets_[v]; }

  Edge edge(EdgeId e) const { return (*edges_)[e]; }
  std::span<const Edge> edges() const { return *edges_; }
  /// The edge list for owners that outlive the graph (a Drawing keeps it without copying).
  const std::shared_ptr<const std::vector<Edge>>& shared_edges() const { return edges_; }

  std::span<const HalfEdge> incident(Vertex v) const {
    return {half_edges_.data() + offsets_[v], half_edges_.data() + offsets_[v + 1]};
  }
  Vertex other_end(EdgeId e, Vertex v) const {
    const Edge ends = edge(e);
    return ends.u == v ? ends.v : ends.u;
  }

 private:
  /// @param repeating  the smallest end of a pair that stands twice among edges_, as they came.
  void refuse_parallel_edges(std::uint64_t repeating) const;

  std::shared_ptr<const std::vector<Edge>> edges_;
  UnwrittenVector<std::uint32_t> offsets_;
  UnwrittenVector<HalfEdge> half_edges_;
  std::uint32_t max_degree_ = 0;
};

/// 128-bit hash of (n, edges in their order), as 32 hexadecimal digits; equal on all platforms.
std::string graph_hash(const Graph& graph);

/// The graph with vertex v renamed to new_name[v] (a permutation).
/// @throws InputError if new_name is not a permutation of 0..n-1.
Graph relabelled(const Graph& graph, std::span<const Vertex> new_name);

/// Component number of every vertex, numbered by smallest vertex; O(n + m).
struct Components {
  std::uint32_t count = 0;
  std::vector<std::uint32_t> of;  // one entry per vertex
};
Components connected_components_of(const Graph& graph);

/// Returns which vertices are in the largest component, the first of equally large ones; O(n + m).
std::vector<bool> in_largest_component(const Graph& graph);

}  // namespace ar3d
