#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "ar3d/model/graph.h"

namespace ar3d {

/// Maps the vertices of one small graph to those of another so that edges become edges and nothing
/// else does: the first map in the lexicographic order of the images; nothing if there is none.
/// @param order  the vertices as images are chosen for them: near an earlier one, few are tried.
/// @param may_be  (v, image): which images are allowed. Cost: exponential.
std::optional<std::vector<Vertex>> find_isomorphism(
    const Graph& from, const Graph& to, std::span<const Vertex> order,
    const std::function<bool(Vertex, Vertex)>& may_be = [](Vertex, Vertex) { return true; });

}  // namespace ar3d
