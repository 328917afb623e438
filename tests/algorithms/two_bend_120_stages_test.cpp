// The steps alone: conditions 1 to 4 of the orders, ancestors, and what goes wrong if one is broken.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "algorithms/two_bend_120_support.h"
#include "ar3d/algorithms/two_bend_120/growing_tree.h"
#include "ar3d/algorithms/two_bend_120/placement.h"
#include "ar3d/base/random.h"
#include "ar3d/generators/catalog.h"
#include "verify/draft.h"

namespace ar3d::two_bend_120 {
namespace {

CubicGraph cubic(const Graph& graph) {
  CubicGraph result(graph.num_vertices());
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    std::copy_n(graph.incident(v).begin(), 3, result[v].begin());
  }
  return result;
}

/// A graph without triangles that is 3-connected, with its numbering and orders.
struct Ordered {
  explicit Ordered(std::uint64_t seed) {
    Graph random = generate(testing_family(), 60, seed);
    while (!testing::is_cubic_and_3_connected(random) ||
           contract_triangles(random).left.size() < 60) {
      random = generate(testing_family(), 60, seed += 1000);
    }
    numbering = *find_numbering(cubic(random), [](const ForkOrder&) { return true; });
    graph = numbering.graph;
    orders = find_orders(numbering.forks).value();
  }
  static const Family& testing_family() { return find_family("random-cubic"); }

  /// Places by vertex; equal for a D and the U above it.
  std::vector<int> ranks(const std::vector<Vertex>& order) const {
    std::vector<int> result(graph.size(), -1);
    int rank = 0;
    for (const Vertex v : order) {
      const Fork& fork = numbering.forks[v];
      if (!fork.opens_up && numbering.forks[fork.stem].opens_up) result[fork.stem] = rank;
      result[v] = rank++;
    }
    return result;
  }

  /// False if some edge has no word for these orders.
  bool has_words(const Orders& tried) const {
    const Reach reach(graph.size(), {1, 1, 1});
    const ForkPlaces placement = place(numbering, tried, reach);
    try {
      for (Vertex v = 0; v < graph.size(); ++v) {
        for (const HalfEdge& half : graph[v]) {
          const FourVector& from = placement.at[v];
          const FourVector& to = placement.at[half.to];
          if (from[3] < to[3]) continue;
          const Direction first = placement.stars[v][slot_of(graph[v], half.edge)];
          const Direction last = -placement.stars[half.to][slot_of(graph[half.to], half.edge)];
          FourVector sum{};
          for (std::size_t i = 0; i < 4; ++i) sum[i] = to[i] - from[i];
          const auto [directions, lengths] = find_word(first, last, sum);
          for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 4; ++j) {
              sum[j] -= lengths[i] * to_four(directions[i])[j];
            }
          }
          if (sum != FourVector{}) return false;
        }
      }
    } catch (const InternalError&) {
      return false;
    }
    return true;
  }

  CubicGraph graph;
  ForkOrder numbering;
  Orders orders;
};

TEST(TwoBend120Orders, KeepTheirConditions) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const Ordered test(seed);
    const auto a = test.ranks(test.orders.a), b = test.ranks(test.orders.b);
    const auto& forks = test.numbering.forks;
    for (Vertex v = 1; v + 1 < test.graph.size(); ++v) {
      const auto& values = forks[v].opens_up ? a : b;
      const auto [low, high] = std::minmax(values[forks[v].prongs[0]], values[forks[v].prongs[1]]);
      EXPECT_TRUE(low < values[v] && values[v] < high) << "condition 1";
      const Vertex stem = forks[v].stem;
      if (forks[stem].stem == kNoVertex) continue;
      if (forks[stem].opens_up == forks[v].opens_up) {
        EXPECT_EQ(a[v] < a[stem], b[v] < b[stem]) << "condition 2";
        EXPECT_NE(a[v], a[stem]);
      } else {
        EXPECT_TRUE(a[v] == a[stem] && b[v] == b[stem]) << "condition 3";
      }
    }
    EXPECT_TRUE(test.has_words(test.orders));
  }
}

/// The whole connected graph after Step F.2.
CubicGraph core_of(const Graph& graph) {
  const Nests nests = contract_triangles(graph);
  std::vector<Vertex> name(nests.nodes.size());
  for (Vertex i = 0; i < nests.left.size(); ++i) name[nests.left[i]] = i;
  CubicGraph core(nests.left.size());
  for (Vertex i = 0; i < core.size(); ++i) {
    for (std::size_t slot = 0; slot < 3; ++slot) {
      const EdgeId edge = nests.nodes[nests.left[i]].edges[slot];
      const Edge ends = nests.ends[edge];
      core[i][slot] = {name[ends.u == nests.left[i] ? ends.v : ends.u], edge};
    }
  }
  return core;
}

// The pairs of edges that cut these graphs let chains return, but never against themselves.
TEST(TwoBend120Orders, AreFoundWhereverThereAreEnds) {
  int with_ends = 0, without = 0;
  for (const int n : {8, 10, 12}) {
    for (const Graph& graph : testing::geng("-C -d3 -D3 " + std::to_string(n))) {
      const CubicGraph core = core_of(graph);
      const auto numbering = find_numbering(core, [](const ForkOrder&) { return true; });
      ++(numbering ? with_ends : without);
      EXPECT_EQ(numbering.has_value(), find_numbering(core, [&](const ForkOrder& found) {
                                         return find_orders(found.forks).has_value();
                                       }).has_value());
    }
  }
  EXPECT_EQ(with_ends, 1 + 7 + 45);
  EXPECT_EQ(without, 4 + 11 + 36);
}

// A vertex of degree 3 has one place among its neighbours in at least one order, so few others do.
TEST(TwoBend120Mutation, AVertexMovedToTheEndOfAnOrderLeavesEdgesWithoutWords) {
  const Ordered test(5);
  int broken = 0, tried = 0;
  for (const bool in_a : {true, false}) {
    const auto& order = in_a ? test.orders.a : test.orders.b;
    for (std::size_t i = 1; i < order.size(); ++i) {
      Orders other = test.orders;
      auto& moved = in_a ? other.a : other.b;
      std::rotate(moved.begin(), moved.begin() + static_cast<std::ptrdiff_t>(i),
                  moved.begin() + static_cast<std::ptrdiff_t>(i) + 1);
      ++tried;
      broken += test.has_words(other) ? 0 : 1;
    }
  }
  EXPECT_GT(4 * broken, 3 * tried) << broken << " of " << tried;
}

TEST(TwoBend120Mutation, AMovedBendIsFound) {
  const Graph graph = generate(find_family("random-cubic"), 60, 2);
  testing::Draft draft = testing::draft_of(draw(graph));
  draft.edges[7].bends.at(0).z += 2;
  EXPECT_FALSE(certify(graph, draft.drawing(), row().guarantee).valid());
}

TEST(TwoBend120Placement, MakesRoomForTriangles) {
  const Ordered test(3);
  Reach reach(test.graph.size(), {1, 1, 1});
  const ForkPlaces plain = place(test.numbering, test.orders, reach);
  for (auto& each : reach) each = {9, 9, 9};
  const ForkPlaces roomy = place(test.numbering, test.orders, reach);
  for (Vertex v = 0; v < test.graph.size(); ++v) {
    for (const HalfEdge& half : test.graph[v]) {
      const auto height = [&](const ForkPlaces& p) {
        return std::abs(p.at[v][3] - p.at[half.to][3]);
      };
      EXPECT_GT(height(roomy), height(plain));
    }
  }
}

TEST(TwoBend120GrowingTree, FindsBranchesAsWalksToTheRootDo) {
  RandomStream random(1);
  GrowingTree tree(2000);
  std::vector<std::uint32_t> parent(2000), depth(2000);
  tree.add_root(0);
  for (std::uint32_t v = 1; v < 2000; ++v) {
    parent[v] = random.below(2) == 0 ? v - 1 : random.below(v);
    depth[v] = depth[parent[v]] + 1;
    tree.add(v, parent[v]);
  }
  for (int i = 0; i < 20000; ++i) {
    const std::uint32_t x = random.below(2000), y = random.below(2000);
    if (x == y) continue;
    std::uint32_t p = x, q = y;
    while (parent[p] != parent[q] && parent[p] != q && parent[q] != p) {
      (depth[p] >= depth[q] ? p : q) = parent[depth[p] >= depth[q] ? p : q];
    }
    EXPECT_EQ(tree.branches(x, y), (std::pair{p, q})) << x << ' ' << y;
  }
}

}  // namespace
}  // namespace ar3d::two_bend_120
