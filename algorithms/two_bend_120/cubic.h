#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "ar3d/model/graph.h"

namespace ar3d::two_bend_120 {

inline constexpr Vertex kNoVertex = std::numeric_limits<Vertex>::max();

/// A cubic graph with vertices 0..n-1: three half-edges per vertex, whose edges keep the numbers of
/// the input. A half-edge's index among the three is its slot.
using CubicGraph = std::vector<std::array<HalfEdge, 3>>;

/// The slot of an edge among three half-edges, or edges.
inline std::size_t slot_of(const std::array<HalfEdge, 3>& near, EdgeId edge) {
  return near[0].edge == edge ? 0 : near[1].edge == edge ? 1 : 2;
}
inline std::size_t slot_of(const std::array<EdgeId, 3>& edges, EdgeId edge) {
  return edges[0] == edge ? 0 : edges[1] == edge ? 1 : 2;
}

/// The graph that is left when triangles are contracted as long as that leaves it simple, and how
/// to undo it. Nodes are the vertices of the input and, from n on, contracted triangles.
struct Nests {
  /// A node and its three edges; a contracted triangle's corner i has edge i.
  struct Nest {
    std::array<EdgeId, 3> edges{};
    std::array<std::uint32_t, 3> reach{1, 1, 1};  ///< Lemma F.8, by slot
    // Of contracted triangles:
    std::array<Vertex, 3> corners{};
    std::array<EdgeId, 3> sides{};         ///< side i is the one between the other two corners
    std::array<std::uint32_t, 3> steps{};  ///< how far corner i stands off along edge i
  };
  std::vector<Nest> nodes;
  std::vector<Edge> ends;    ///< per edge: the nodes that hold its ends u and v when it is drawn
  std::vector<Vertex> left;  ///< the nodes that no triangle holds
};

/// Step F.2: contracts triangles; 3-connected components become K4 or triangle-free, others may keep
/// triangles that share an edge. Cost: O(n).
Nests contract_triangles(const Graph& graph);

}  // namespace ar3d::two_bend_120
