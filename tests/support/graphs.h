#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ar3d/model/graph.h"
#include "support/test.h"

namespace ar3d::testing {

Graph path(Vertex n);
Graph cycle(Vertex n);  // n >= 3
Graph complete(Vertex n);
Graph petersen();
Graph octahedron();
/// Disjoint union, vertices numbered one graph after the other.
Graph disjoint_union(const std::vector<Graph>& parts);
/// Random relabelling of the vertices and random order and direction of the edges.
Graph shuffled(const Graph& graph, std::uint64_t seed);
/// All graphs that `nauty-geng ARGS` prints (graph6 decoded here, independently of formats/), in
/// its order.
/// @throws std::runtime_error if it fails or prints nothing, so that no list is cut unnoticed.
std::vector<Graph> geng(const std::string& arguments);

/// The square of a cycle: v is joined to v + 1 and v + 2. Rich in triangles.
Graph squared_cycle(Vertex n);

}  // namespace ar3d::testing
