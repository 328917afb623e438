// Step 1.1. Two edges of each colour at a vertex, out of two passes over chains of edges: one to
// orient them, one to colour them. The paper takes an Euler tour of a graph made 4-regular by
// dummy vertices; chains of pairs need neither, and closed ones are even by themselves. O(n + m),
// two cache misses per edge and pass, which is most of the time of effort 1 for large n.
#include "ar3d/algorithms/diamond/colouring.h"

#include <algorithm>
#include <bit>

#include "ar3d/model/error.h"

namespace ar3d::diamond {
namespace {

/// One end of an edge.
struct Port {
  Vertex v = 0;
  std::uint32_t slot = 0;
};

std::uint8_t bit(std::uint32_t slot) { return static_cast<std::uint8_t>(1u << slot); }

Port opposite(const Slots& slots, Port p) {
  const Vertex w = slots[p.v][p.slot];
  std::uint32_t slot = 0;
  while (slots[w][slot] != p.v) ++slot;
  return {w, slot};
}

/// Walks every chain of edges once, from an end if it has one. `partner(port)` is the slot linked
/// with the port at its vertex, or kNone; `visit(from, to, i)` is called for the i-th edge of the
/// chain.
template <class Partner, class Visit>
void walk_chains(const Slots& slots, Partner partner, Visit visit) {
  std::vector<std::uint8_t> used(slots.size(), 0);
  const auto walk = [&](Port from) {
    for (unsigned i = 0;; ++i) {
      const Port to = opposite(slots, from);
      used[from.v] |= bit(from.slot);
      used[to.v] |= bit(to.slot);
      visit(from, to, i);
      const std::uint32_t next = partner(to);
      if (next == kNone || (used[to.v] & bit(next))) return;
      from = {to.v, next};
    }
  };
  for (const bool only_ends : {true, false}) {
    for (Vertex v = 0; v < slots.size(); ++v) {
      for (std::uint32_t slot = 0; slot < 4 && slots[v][slot] != kNone; ++slot) {
        if (used[v] & bit(slot)) continue;
        if (!only_ends || partner(Port{v, slot}) == kNone) walk({v, slot});
      }
    }
  }
}

}  // namespace

Slots padded_slots(const Graph& graph) {
  expect(graph.max_degree() <= 4, "slots are for maximum degree 4");
  Slots slots(graph.num_vertices(), {kNone, kNone, kNone, kNone});
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    const auto row = graph.incident(v);
    std::transform(row.begin(), row.end(), slots[v].begin(),
                   [](const HalfEdge& h) { return h.to; });
  }
  return slots;
}

BalancedOrientation balanced_orientation(const Slots& slots) {
  BalancedOrientation result;
  result.out.assign(slots.size(), 0);
  result.in.assign(slots.size(), 0);
  const auto partner = [&](Port p) {
    const std::uint32_t other = p.slot ^ 1u;
    return slots[p.v][other] == kNone ? kNone : other;
  };
  walk_chains(slots, partner, [&](Port from, Port to, unsigned) {
    result.out[from.v] |= bit(from.slot);
    result.in[to.v] |= bit(to.slot);
  });
  return result;
}

TwoColouring two_colouring(const Graph& graph, const Slots& slots,
                           const BalancedOrientation& orientation) {
  const auto partner = [&](Port p) {  // the other slot of the same direction
    const unsigned out = orientation.out[p.v];
    const unsigned same = (out & bit(p.slot)) ? out : orientation.in[p.v];
    const unsigned other = same & ~unsigned{bit(p.slot)};
    return other == 0 ? kNone : static_cast<std::uint32_t>(std::countr_zero(other));
  };
  std::vector<std::uint8_t> red(slots.size(),
                                0);  // bit i: the edge of slot i leaves the vertex and is red
  walk_chains(slots, partner, [&](Port from, Port to, unsigned i) {
    const Port tail = (orientation.out[from.v] & bit(from.slot)) ? from : to;
    if (i % 2 == kRed) red[tail.v] |= bit(tail.slot);
  });
  TwoColouring result;
  for (auto& next : result.next) next.assign(slots.size(), {kNone, kNone});
  for (Vertex v = 0; v < slots.size(); ++v) {
    const auto row = graph.incident(v);
    for (std::uint32_t slot = 0; slot < row.size(); ++slot) {
      if (orientation.out[v] & bit(slot))
        result.next[red[v] & bit(slot) ? kRed : kGreen][v] = row[slot];
    }
  }
  return result;
}

}  // namespace ar3d::diamond
