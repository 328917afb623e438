#pragma once

#include "ar3d/algorithms/compact/decomposition.h"
#include "ar3d/algorithms/compact/placement.h"
#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"

namespace ar3d::compact {

/// Bounds on the extents of any drawing in a strip of this size.
std::array<std::int64_t, 3> box_of(const StripSize& size);

/// The drawing in space; one byte per edge besides the graph's own edge list.
Drawing lift(const Graph& graph, const Decomposition& links, const Placement& placement);

}  // namespace ar3d::compact
