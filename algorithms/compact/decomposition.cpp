// Step 1.1 again: every edge directed and green or red. The four roles at a vertex are what gives
// every edge letters of its own at both ends (Lemma C.1). O(n + m).
#include "ar3d/algorithms/compact/strip.h"
#include "ar3d/algorithms/diamond/fast/fast.h"
#include "ar3d/base/error.h"

namespace ar3d::compact {

Decomposition decompose(const Graph& graph) {
  constexpr Vertex kAhead = 16;  // heads are prefetched so many edges before they are written
  const diamond::TwoColouring colours = diamond::fast::colouring(graph);
  static_assert(diamond::kNone == kNobody);
  const HalfEdge nothing{kNobody, kNobody};
  Decomposition result;
  result.at.assign(graph.num_vertices(), {nothing, nothing, nothing, nothing});
  for (const auto colour : {diamond::kGreen, diamond::kRed}) {
    const ColourRole out = colour == diamond::kGreen ? kGreenOut : kRedOut;
    const auto& next = colours[colour];
    for (Vertex v = 0; v < graph.num_vertices(); ++v) {
      if (v + kAhead < next.size() && next[v + kAhead].to != kNobody) {
        __builtin_prefetch(&result.at[next[v + kAhead].to], 1);
      }
      const HalfEdge edge = next[v];
      if (edge.to == kNobody) continue;
      HalfEdge& in = result.at[edge.to][opposite(out)];
      expect(in.to == kNobody, "a vertex has one edge of each role");
      in = {v, edge.edge};
      result.at[v][out] = edge;
      if (out == kGreenOut) ++result.num_green;
    }
  }
  return result;
}

}  // namespace ar3d::compact
