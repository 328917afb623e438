#pragma once

#include "ar3d/algorithms/compact_120/strip.h"
#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"

namespace ar3d::compact_120 {

/// Bounds on the extents of any drawing in a strip of this size (Lemma D.10).
std::array<std::int64_t, 3> box_of(const StripSize& size);

/// The drawing in space; one byte per edge besides the graph's own edge list.
Drawing lift(const Graph& graph, const Strip& strip);

}  // namespace ar3d::compact_120
