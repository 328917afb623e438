#include "ar3d/algorithms/diamond/colouring.h"

#include "ar3d/model/error.h"

namespace ar3d::theorem1 {
namespace {

/// One end of an edge: entry `slot` of incident(v).
struct Port {
  Vertex v = 0;
  std::uint32_t slot = 0;
};

unsigned bit(std::uint32_t slot) { return 1u << slot; }

Port opposite(const Graph& graph, Port p) {
  const HalfEdge half = graph.incident(p.v)[p.slot];
  const auto row = graph.incident(half.to);
  std::uint32_t slot = 0;
  while (row[slot].edge != half.edge) ++slot;
  return {half.to, slot};
}

/// Walks every chain of edges once, from an end if it has one. `partner(port)` is the slot linked
/// with the port at its vertex, or kNone; `visit(from, to, i)` is called for the i-th edge of the
/// chain.
template <class Partner, class Visit>
void walk_chains(const Graph& graph, Partner partner, Visit visit) {
  std::vector<std::uint8_t> used(graph.num_vertices(), 0);
  const auto walk = [&](Port from) {
    for (unsigned i = 0;; ++i) {
      const Port to = opposite(graph, from);
      used[from.v] = static_cast<std::uint8_t>(used[from.v] | bit(from.slot));
      used[to.v] = static_cast<std::uint8_t>(used[to.v] | bit(to.slot));
      visit(from, to, i);
      const std::uint32_t next = partner(to);
      if (next == kNone || (used[to.v] & bit(next))) return;
      from = {to.v, next};
    }
  };
  for (const bool only_ends : {true, false}) {
    for (Vertex v = 0; v < graph.num_vertices(); ++v) {
      for (std::uint32_t slot = 0; slot < graph.degree(v); ++slot) {
        if (used[v] & bit(slot)) continue;
        if (!only_ends || partner(Port{v, slot}) == kNone) walk({v, slot});
      }
    }
  }
}

}  // namespace

BalancedOrientation balanced_orientation(const Graph& graph) {
  expect(graph.max_degree() <= 4, "the colouring is for maximum degree 4");
  BalancedOrientation result;
  result.outgoing.assign(graph.num_vertices(), 0);
  const auto partner = [&](Port p) {
    const std::uint32_t other = p.slot ^ 1u;
    return other < graph.degree(p.v) ? other : kNone;
  };
  walk_chains(graph, partner, [&](Port from, Port, unsigned) {
    auto& mask = result.outgoing[from.v];
    mask = static_cast<std::uint8_t>(mask | bit(from.slot));
  });
  return result;
}

TwoColouring two_colouring(const Graph& graph, const BalancedOrientation& orientation) {
  // For the four bits of outgoing and a slot: the other slot of the same direction.
  const auto partner = [&](Port p) {
    const unsigned all = (1u << graph.degree(p.v)) - 1;
    const unsigned out = orientation.outgoing[p.v];
    const unsigned same = ((out & bit(p.slot)) ? out : all & ~out) & ~bit(p.slot);
    constexpr std::array<std::uint8_t, 9> kSlotOfBit = {0, 0, 1, 0, 2, 0, 0, 0, 3};
    return same == 0 ? kNone : std::uint32_t{kSlotOfBit[same]};
  };
  TwoColouring result;
  for (auto& next : result.next) next.assign(graph.num_vertices(), {kNone, kNone});
  walk_chains(graph, partner, [&](Port from, Port to, unsigned i) {
    const bool forward = orientation.outgoing[from.v] & bit(from.slot);
    const Port tail = forward ? from : to;
    result.next[i % 2][tail.v] = graph.incident(tail.v)[tail.slot];
  });
  return result;
}

}  // namespace ar3d::theorem1
