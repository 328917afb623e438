#pragma once

#include <concepts>

#include "ar3d/algorithms/algorithm.h"
#include "ar3d/model/boost_graph.h"

namespace ar3d {

/// Draws any model of Boost's VertexListGraph and EdgeListGraph whose vertices have an index map;
/// vertices and edges of the drawing are those of from_boost(graph).
/// @throws InputError as draw() of a Graph, and on loops and parallel edges.
template <class BoostGraph>
requires(!std::same_as<BoostGraph, Graph>) Drawing
    draw(const Algorithm& algorithm, const BoostGraph& graph, const Settings& given = {}) {
  return draw(algorithm, from_boost(graph), given);
}

}  // namespace ar3d
