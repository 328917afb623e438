#pragma once

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "ar3d/algorithms/diamond/guaranteed.h"
#include "ar3d/algorithms/diamond/routes.h"

namespace ar3d::testing {

/// One way to cut an order of n vertices into items.
struct Cut {
  std::vector<std::uint32_t> size;
  std::vector<bool> cycle;
};

/// All sequences of items with n vertices in all: paths of any length, cycles of at least 3
/// vertices.
inline std::vector<Cut> all_cuts(std::uint32_t n) {
  if (n == 0) return {{}};
  std::vector<Cut> result;
  for (std::uint32_t last = 1; last <= n; ++last) {
    for (const Cut& start : all_cuts(n - last)) {
      for (const bool cycle : {false, true}) {
        if (cycle && last < 3) continue;
        Cut cut = start;
        cut.size.push_back(last);
        cut.cycle.push_back(cycle);
        result.push_back(std::move(cut));
      }
    }
  }
  return result;
}

/// The order cut into items; the edges are appended to `edges`. False if one is there already.
inline bool make_items(const std::vector<Vertex>& order, const Cut& cut, std::vector<Edge>& edges,
                       diamond::Items& items) {
  items = {order, {}, {0}};
  std::uint32_t begin = 0;
  for (std::size_t i = 0; i < cut.size.size(); ++i) {
    const std::uint32_t end = begin + cut.size[i];
    for (std::uint32_t p = begin; p < end; ++p) {
      if (p + 1 == end && !cut.cycle[i]) {
        items.edge.push_back(diamond::kNone);
        continue;
      }
      const auto [u, v] = std::minmax(order[p], order[p + 1 == end ? begin : p + 1]);
      if (std::find(edges.begin(), edges.end(), Edge{u, v}) != edges.end()) return false;
      items.edge.push_back(static_cast<EdgeId>(edges.size()));
      edges.push_back({u, v});
    }
    items.begin.push_back(end);
    begin = end;
  }
  return true;
}

/// Calls visit(graph, green, red) for every pair of edge-disjoint colourings with their items in
/// every order, direction and rotation, up to the names of the vertices (the green order is
/// 0..n-1). This covers whatever the colouring stage can hand on.
template <class Visit>
std::size_t for_all_colourings(Vertex n, Visit visit) {
  const std::vector<Cut> cuts = all_cuts(n);
  std::vector<Vertex> green_order(n);
  std::iota(green_order.begin(), green_order.end(), 0u);
  std::size_t count = 0;
  for (const Cut& green_cut : cuts) {
    diamond::Items green;
    std::vector<Edge> green_edges;
    make_items(green_order, green_cut, green_edges, green);
    std::vector<Vertex> red_order = green_order;
    do {
      for (const Cut& red_cut : cuts) {
        std::vector<Edge> edges = green_edges;
        diamond::Items red;
        if (!make_items(red_order, red_cut, edges, red)) continue;
        visit(Graph(n, std::move(edges)), green, red);
        ++count;
      }
    } while (std::next_permutation(red_order.begin(), red_order.end()));
  }
  return count;
}

/// The guaranteed mode keeps its invariants, the theorem's box and its own formulas on every
/// colouring of n vertices.
inline std::size_t count_colouring_faults(Vertex n, std::size_t& colourings) {
  std::size_t faults = 0;
  colourings = for_all_colourings(
      n, [&](const Graph& graph, const diamond::Items& green, const diamond::Items& red) {
        const auto [placement, gaps] = diamond::place_guaranteed(graph, green, red);
        const auto extents = diamond::choose_tracks(graph, placement).extents;
        const std::int64_t side = 4 * std::int64_t{n} + 2 * gaps.H();
        const bool fine = diamond::keeps_invariants(graph, placement) &&
                          diamond::fits_theorem_box(extents, n) &&
                          gaps.H() <= gaps.m_green + gaps.rho + gaps.green_gaps + gaps.red_gaps &&
                          (n < 4 || (gaps.green_gaps <= 1 && gaps.red_gaps <= 1)) &&
                          (n < 2 || (extents[0] <= side && extents[1] <= side &&
                                     extents[2] <= 6 * std::int64_t{n} + 3 * gaps.H() - 4));
        faults += !fine;
      });
  return faults;
}

}  // namespace ar3d::testing
