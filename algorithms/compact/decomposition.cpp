#include "ar3d/algorithms/compact/decomposition.h"

#include "ar3d/algorithms/diamond/colouring.h"
#include "ar3d/model/error.h"

namespace ar3d::compact {

Decomposition decompose(const Graph& graph) {
  const theorem1::TwoColouring colours = [&] {
    const theorem1::Slots slots = theorem1::padded_slots(graph);
    return theorem1::two_colouring(graph, slots, theorem1::balanced_orientation(slots));
  }();
  static_assert(theorem1::kNone == kNobody);
  const HalfEdge nothing{kNobody, kNobody};
  Decomposition result;
  result.at.assign(graph.num_vertices(), {nothing, nothing, nothing, nothing});
  for (const auto colour : {theorem1::kGreen, theorem1::kRed}) {
    const Role out = colour == theorem1::kGreen ? kGreenOut : kRedOut;
    for (Vertex v = 0; v < graph.num_vertices(); ++v) {
      const HalfEdge edge = colours.next[colour][v];
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
