// Step 1.1. Two edges of each colour at a vertex, out of two passes over chains of edges: one to
// orient them, one to colour them. The paper takes an Euler tour of a graph made 4-regular by
// dummy vertices; chains of pairs need neither, and closed ones are even by themselves. O(n + m),
// two cache misses per edge and pass, which is most of the time of effort 1 for large n.
#include "ar3d/algorithms/diamond/colouring.h"

#include <algorithm>
#include <bit>

#include "ar3d/base/error.h"
#include "ar3d/base/parallel.h"

namespace ar3d::diamond {
namespace {

/// One end of an edge.
struct Port {
  Vertex v = 0;
  std::uint32_t entry = 0;
};

std::uint8_t bit(std::uint32_t entry) { return static_cast<std::uint8_t>(1u << entry); }

Port opposite(const PaddedNeighbours& neighbours, Port p) {
  const Vertex w = neighbours[p.v][p.entry];
  std::uint32_t entry = 0;
  while (neighbours[w][entry] != p.v) ++entry;
  return {w, entry};
}

/// Walks every chain of edges once, from an end if it has one. `partner(port)` is the entry linked
/// with the port at its vertex, or kNone; `visit(from, to, i)` is called for the i-th edge of the
/// chain.
template <class Partner, class Visit>
void walk_chains(const PaddedNeighbours& neighbours, Partner partner, Visit visit) {
  std::vector<std::uint8_t> used(neighbours.size(), 0);
  const auto walk = [&](Port from) {
    for (unsigned i = 0;; ++i) {
      const Port to = opposite(neighbours, from);
      used[from.v] |= bit(from.entry);
      used[to.v] |= bit(to.entry);
      visit(from, to, i);
      const std::uint32_t next = partner(to);
      if (next == kNone || (used[to.v] & bit(next))) return;
      from = {to.v, next};
    }
  };
  for (const bool only_ends : {true, false}) {
    for (Vertex v = 0; v < neighbours.size(); ++v) {
      for (std::uint32_t entry = 0; entry < 4 && neighbours[v][entry] != kNone; ++entry) {
        if (used[v] & bit(entry)) continue;
        if (!only_ends || partner(Port{v, entry}) == kNone) walk({v, entry});
      }
    }
  }
}

}  // namespace

PaddedNeighbours padded_neighbours(const Graph& graph, std::uint32_t threads) {
  expect(graph.max_degree() <= 4, "four entries are for maximum degree 4");
  PaddedNeighbours neighbours(graph.num_vertices());
  for_ranges_in_threads(threads, graph.num_vertices(),
                        [&](std::uint32_t, std::size_t begin, std::size_t end) {
                          for (auto v = static_cast<Vertex>(begin); v < end; ++v) {
                            const auto row = graph.incident(v);
                            if (row.size() == 4) {
                              neighbours[v] = {row[0].to, row[1].to, row[2].to, row[3].to};
                              continue;
                            }
                            neighbours[v].fill(kNone);
                            std::ranges::transform(row, neighbours[v].begin(), &HalfEdge::to);
                          }
                        });
  return neighbours;
}

BalancedOrientation balanced_orientation(const PaddedNeighbours& neighbours) {
  BalancedOrientation result;
  auto &out = result[0], &in = result[1];
  out.assign(neighbours.size(), 0);
  in.assign(neighbours.size(), 0);
  const auto partner = [&](Port p) {
    const std::uint32_t other = p.entry ^ 1u;
    return neighbours[p.v][other] == kNone ? kNone : other;
  };
  walk_chains(neighbours, partner, [&](Port from, Port to, unsigned) {
    out[from.v] |= bit(from.entry);
    in[to.v] |= bit(to.entry);
  });
  return result;
}

TwoColouring two_colouring(const Graph& graph, const PaddedNeighbours& neighbours,
                           const BalancedOrientation& orientation) {
  const auto &out = orientation[0], &in = orientation[1];
  const auto partner = [&](Port p) {  // the other entry of the same direction
    const unsigned same = (out[p.v] & bit(p.entry)) ? out[p.v] : in[p.v];
    const unsigned other = same & ~unsigned{bit(p.entry)};
    return other == 0 ? kNone : static_cast<std::uint32_t>(std::countr_zero(other));
  };
  std::vector<std::uint8_t> red(neighbours.size(),
                                0);  // bit i: the edge to entry i leaves the vertex and is red
  walk_chains(neighbours, partner, [&](Port from, Port to, unsigned i) {
    const Port tail = (out[from.v] & bit(from.entry)) ? from : to;
    if (i % 2 == kRed) red[tail.v] |= bit(tail.entry);
  });
  TwoColouring result;
  for (auto& next : result) next.assign(neighbours.size(), {kNone, kNone});
  for (Vertex v = 0; v < neighbours.size(); ++v) {
    const auto row = graph.incident(v);
    for (std::uint32_t entry = 0; entry < row.size(); ++entry) {
      if (out[v] & bit(entry)) result[red[v] & bit(entry) ? kRed : kGreen][v] = row[entry];
    }
  }
  return result;
}

}  // namespace ar3d::diamond
