// Lemma F.7: the cores without a numbering. Their drawings were found by searches and are proved
// right by the verifier in the tests, as all others are. Cost: O(1), a search among few labellings.
#include <numeric>

#include "ar3d/algorithms/two_bend_120/placement.h"
#include "ar3d/model/isomorphism.h"

namespace ar3d::two_bend_120 {
namespace {

// Points of vertices, then edges with their bends.
// clang-format off
const std::vector<SmallCore>& table() {
  static const std::vector<SmallCore> kTable = {
      {{{1, 1, 2}, {1, 4, 3}, {4, 2, 4}, {4, 3, 1}},
       {{0, 1, {{0, 2, 2}, {0, 3, 3}}}, {0, 2, {{1, 0, 3}, {2, 0, 4}}}, {0, 3, {{3, 1, 0}, {4, 2, 0}}}, {1, 2, {{3, 4, 5}, {4, 3, 5}}}, {1, 3, {{1, 5, 2}, {2, 5, 1}}}, {2, 3, {{5, 2, 3}, {5, 3, 2}}}}},
      {{{2, 1, 2}, {6, 4, 1}, {3, 5, 5}, {5, 2, 4}, {4, 4, 3}, {1, 5, 3}},
       {{0, 3, {{2, 0, 3}, {3, 0, 4}}}, {0, 4, {{3, 1, 1}, {4, 2, 1}}}, {0, 5, {{0, 3, 2}, {0, 4, 3}}}, {1, 3, {{7, 3, 1}, {7, 2, 2}}}, {1, 4, {{6, 5, 2}, {5, 5, 3}}}, {1, 5, {{5, 4, 0}, {4, 5, 0}}}, {2, 3, {{4, 5, 6}, {5, 4, 6}}}, {2, 4, {{3, 4, 4}}}, {2, 5, {{2, 6, 5}, {1, 6, 4}}}}},
      {{{12, 8, 15}, {13, 17, 1}, {19, 13, 7}, {1, 6, 6}, {12, 5, 10}, {22, 15, 12}, {11, 18, 4}, {6, 1, 8}},
       {{0, 3, {{11, 7, 15}, {2, 7, 6}}}, {0, 4, {{13, 8, 14}, {13, 5, 11}}}, {1, 4, {{13, 16, 0}, {12, 15, 0}}}, {0, 5, {{12, 9, 16}, {18, 15, 16}}}, {1, 5, {{14, 18, 1}, {22, 18, 9}}}, {2, 5, {{23, 13, 11}, {23, 14, 12}}}, {1, 6, {{12, 17, 2}, {12, 18, 3}}}, {2, 6, {{13, 19, 7}, {11, 19, 5}}}, {3, 6, {{0, 6, 5}, {0, 7, 4}}}, {2, 7, {{19, 11, 5}, {9, 1, 5}}}, {3, 7, {{1, 5, 7}, {2, 5, 8}}}, {4, 7, {{7, 0, 10}, {6, 0, 9}}}}},
      {{{16, 5, 3}, {13, 24, 7}, {27, 23, 16}, {18, 3, 1}, {39, 6, 17}, {29, 19, 10}, {12, 24, 4}, {39, 5, 20}, {9, 1, 8}, {37, 6, 15}},
       {{0, 3, {{16, 4, 2}, {17, 3, 2}}}, {1, 4, {{22, 24, 16}, {22, 23, 17}}}, {2, 5, {{28, 24, 16}, {29, 24, 15}}}, {0, 6, {{5, 16, 3}, {5, 17, 4}}}, {1, 6, {{13, 25, 6}, {12, 25, 5}}}, {2, 6, {{14, 23, 3}, {13, 24, 3}}}, {2, 7, {{27, 18, 21}, {39, 6, 21}}}, {3, 7, {{19, 4, 1}, {38, 4, 20}}}, {4, 7, {{40, 6, 18}, {40, 5, 19}}}, {1, 8, {{0, 11, 7}, {0, 10, 8}}}, {3, 8, {{18, 2, 0}, {17, 1, 0}}}, {5, 8, {{10, 0, 10}, {9, 0, 9}}}, {0, 9, {{32, 5, 19}, {33, 6, 19}}}, {4, 9, {{39, 5, 16}, {38, 5, 15}}}, {5, 9, {{30, 19, 9}, {37, 12, 9}}}}},
  };
  return kTable;
}
// clang-format on

}  // namespace

std::optional<SmallCore> small_core_of(const CubicGraph& graph) {
  std::vector<Edge> edges;
  for (Vertex v = 0; v < graph.size(); ++v) {
    for (const HalfEdge& half : graph[v]) {
      if (v < half.to) edges.push_back({v, half.to});
    }
  }
  const Graph core(graph.size(), std::move(edges));
  for (const SmallCore& small : table()) {
    std::vector<Edge> drawn;
    for (const auto& [u, v, bends] : small.lines) drawn.push_back({u, v});
    std::vector<Vertex> order(small.at.size());
    std::iota(order.begin(), order.end(), 0);
    const auto names = find_isomorphism(Graph(order.size(), std::move(drawn)), core, order);
    if (!names) continue;
    SmallCore result = small;
    for (const Vertex v : order) result.at[(*names)[v]] = small.at[v];
    for (auto& [u, v, bends] : result.lines) {
      u = (*names)[u];
      v = (*names)[v];
    }
    return result;
  }
  return std::nullopt;
}

}  // namespace ar3d::two_bend_120
