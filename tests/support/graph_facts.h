#pragma once

#include <cstdint>
#include <map>

#include "ar3d/model/graph.h"

namespace ar3d::testing {

/// What the property tests compare; computed by Boost.Graph and plain searches, never by
/// generators/.
std::map<std::uint32_t, std::uint64_t> degree_counts(const Graph& graph);
std::uint64_t components(const Graph& graph);
/// Edges whose removal disconnects (biconnected components of a single edge).
std::uint64_t bridges(const Graph& graph);
/// Length of a shortest cycle; 0 for forests. O(n m).
std::uint32_t girth(const Graph& graph);
/// Largest distance within a component. O(n m).
std::uint32_t diameter(const Graph& graph);
bool bipartite(const Graph& graph);
bool planar(const Graph& graph);
/// Vertex connectivity, capped at `limit`, by trying all cuts of fewer than `limit` <= 4 vertices.
/// Small graphs only.
std::uint32_t connectivity(const Graph& graph, std::uint32_t limit);
/// A cubic graph's proper 3-edge-colouring exists; backtracking, small graphs only.
bool three_edge_colourable(const Graph& graph);

}  // namespace ar3d::testing
