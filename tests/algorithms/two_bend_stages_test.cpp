// The stages of the two-bend construction one by one, each against its invariant or a slow oracle.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "algorithms/two_bend_checks.h"
#include "algorithms/two_bend_graphs.h"
#include "ar3d/algorithms/two_bend/layout.h"
#include "ar3d/algorithms/two_bend/leans.h"
#include "ar3d/algorithms/two_bend/lists.h"
#include "ar3d/algorithms/two_bend/time_order.h"
#include "ar3d/generators/catalog.h"
#include "support/graphs.h"

namespace ar3d::two_bend {
namespace {

std::vector<LocalGraph> components_of(const Graph& graph) {
  std::vector<LocalGraph> result;
  ComponentReader reader(graph);
  LocalGraph component;
  while (reader.next(component)) result.push_back(component);
  return result;
}

std::size_t count_reachable_without(const LocalGraph& graph, Vertex from, Vertex u, Vertex v) {
  std::vector<bool> seen(graph.size(), false);
  std::vector<Vertex> stack{from};
  seen[from] = true;
  std::size_t count = 0;
  while (!stack.empty()) {
    const Vertex at = stack.back();
    stack.pop_back();
    ++count;
    for (std::size_t k = 0; k < graph.neighbours[at].degree(); ++k) {
      const Vertex to = graph.neighbours[at].to[k];
      if ((at == u && to == v) || (at == v && to == u) || seen[to]) continue;
      seen[to] = true;
      stack.push_back(to);
    }
  }
  return count;
}

TEST(TwoBendNumeric, CeilSqrtIsExact) {
  for (std::int64_t value = 0; value < 2000; ++value) {
    const std::int64_t h = ceil_sqrt(value);
    EXPECT_TRUE(h * h >= value && (h == 0 || (h - 1) * (h - 1) < value)) << value;
  }
  for (const std::int64_t root :
       {std::int64_t{94906267}, std::int64_t{1} << 30, (std::int64_t{1} << 31) - 1}) {
    EXPECT_EQ(ceil_sqrt(root * root), root);
    EXPECT_EQ(ceil_sqrt(root * root + 1), root + 1);
    EXPECT_EQ(ceil_sqrt(root * root - 1), root);
  }
}

/// Lemma 2.10: the largest run gives the least height among all runs coprime to q.
TEST(TwoBendNumeric, ArmAndLeanIsTheLowest) {
  for (std::int64_t along = 2; along < 40; ++along) {
    for (std::int64_t q = 1; q < 80; ++q) {
      const ArmLean shape = arm_and_lean(along, q);
      EXPECT_EQ(shape.arm + shape.run, along);
      EXPECT_EQ(std::gcd(shape.run, q), 1);
      EXPECT_GE(shape.height * shape.height, shape.run * shape.run + q * q);       // Lemma 2.2
      EXPECT_GE(2 * shape.run * shape.run + 2 * shape.run * shape.height, q * q);  // Lemma 2.3
      for (std::int64_t run = 1; run < along; ++run) {
        if (std::gcd(run, q) != 1) continue;
        std::int64_t height = lean_height(run, q);
        while (2 * run * run + 2 * run * height < q * q) ++height;
        EXPECT_GE(along - run + height, shape.total_height());
      }
    }
  }
}

TEST(TwoBendBlocks, BridgesAreThoseWhoseRemovalDisconnects) {
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    for (const LocalGraph& graph : components_of(testing::random_graph_of_any_kind(20, seed))) {
      const BlockTree blocks = find_blocks(graph);
      for (Vertex v = 0; v < graph.size(); ++v) {
        for (std::size_t k = 0; k < graph.neighbours[v].degree(); ++k) {
          const Vertex u = graph.neighbours[v].to[k];
          EXPECT_EQ(blocks.is_bridge(v, u), count_reachable_without(graph, v, v, u) < graph.size());
        }
      }
    }
  }
}

TEST(TwoBendOrder, StOrderHasNoInnerSourceOrSink) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    RandomStream random(seed);
    const Graph input = testing::random_necklace(2 + random.below(4), random).graph();
    for (const LocalGraph& graph : components_of(input)) {
      const BlockTree blocks = find_blocks(graph);
      StOrder st(graph, blocks);
      const Vertex s = random.below(graph.size());
      const Vertex t = (s + 1 + random.below(graph.size() - 1)) % graph.size();
      if (blocks.is_bridge(s, t)) continue;
      const LongVector<Vertex> list = st.order(s, t);
      std::vector<std::size_t> place(graph.size());
      for (std::size_t i = 0; i < list.size(); ++i) place[list[i]] = i;
      EXPECT_EQ(list.front(), s);
      EXPECT_EQ(list.back(), t);
      for (const Vertex v : list) {
        bool earlier = v == s;
        bool later = v == t;
        for (const Vertex u : graph.neighbours[v].to)
          (place[u] < place[v] ? earlier : later) = true;
        EXPECT_TRUE(earlier && later);
      }
    }
  }
}

TEST(TwoBendOrder, RepairGivesAnyEndOfACubicBlockTwoClosingNeighbours) {
  for (const int n : {10, 12}) {
    for (const Graph& input : testing::geng(fmt::format("-c -d3 -D3 {}", n))) {
      const LocalGraph graph = components_of(input)[0];
      const BlockTree blocks = find_blocks(graph);
      if (blocks.blocks.size() > 1) continue;
      StOrder st(graph, blocks);
      for (Vertex s = 0; s < graph.size(); ++s) {
        for (Vertex t = 0; t < graph.size(); ++t) {
          if (s == t) continue;
          LongVector<Vertex> list = st.order(s, t);
          EXPECT_TRUE(repair_true_sink(graph, list));
          std::reverse(list.begin(), list.end());
          EXPECT_TRUE(repair_true_sink(graph, list));
          EXPECT_GE(count_closing_neighbours(graph, list), 2u);
          std::reverse(list.begin(), list.end());
          EXPECT_GE(count_closing_neighbours(graph, list), 2u);
        }
      }
    }
  }
}

TEST(TwoBendList, EntryListAgreesWithAVector) {
  RandomStream random(3);
  LongVector<NodeId> oracle(8);
  std::iota(oracle.begin(), oracle.end(), 0u);
  EntryList list(300, oracle);
  for (NodeId v = 8; v < 300; ++v) {
    const std::size_t i = random.below(static_cast<std::uint32_t>(oracle.size()));
    if (random.chance(1, 2) || i == 0) {
      list.insert_after(oracle[i], v);
      oracle.insert(oracle.begin() + static_cast<std::ptrdiff_t>(i) + 1, v);
    } else {
      list.insert_before(oracle[i], v);
      oracle.insert(oracle.begin() + static_cast<std::ptrdiff_t>(i), v);
    }
  }
  for (std::size_t i = 0; i < oracle.size(); ++i) {
    for (std::size_t j = 0; j < oracle.size(); ++j)
      EXPECT_EQ(list.before(oracle[i], oracle[j]), i < j);
  }
  EXPECT_EQ(list.in_order(), oracle);
}

void expect_layout(const Flow& flow, const Lists& lists, const Layout& layout) {
  for (const bool columns : {false, true}) {
    const View view(flow, columns);
    const LongVector<NodeId>& list = lists[columns ? 1 : 0];
    EXPECT_TRUE(merges_are_between(view, list));
    EXPECT_TRUE(merges_keep_distances(view, columns ? layout.columns : layout.rows));
    EXPECT_TRUE(shared_rows_are_plane(view, columns ? layout.rows : layout.columns));
    for (NodeId v = 0; v < view.size(); ++v) {
      EXPECT_EQ(std::count(list.begin(), list.end(), v),
                view.is_owner(v) || view.is_listed_merge(v));
    }
  }
  EXPECT_TRUE(rays_differ(flow, layout));
  EXPECT_TRUE(vv_leans_are_primitive(flow, layout));
}

/// Every condition on every stage, with both efforts and in the safe layout.
void expect_stages(const Graph& whole) {
  for (LocalGraph graph : components_of(whole)) {
    if (graph.size() <= 6) continue;  // single vertices and fixed bodies among them
    BlockTree blocks = find_blocks(graph);
    const LongVector<QBody> bodies = cut_q_bodies(graph, blocks);
    const TimeOrder order = find_time_order(graph, blocks);
    EXPECT_EQ(order.list.size() + 4 * bodies.size(), graph.size());
    EXPECT_TRUE(is_time_order(graph, order));
    const Flow flow = build_flow(graph, blocks, order);
    EXPECT_TRUE(arms_are_not_parallel(flow));
    EXPECT_EQ(std::count_if(flow.nodes.begin(), flow.nodes.end(),
                            [](const Node& v) { return v.ins == 0; }),
              1);
    for (const bool share : {false, true}) {
      Flow own = flow;
      const Lists lists = build_lists(own, share);
      const auto layout = find_layout(own, lists, share);
      if (layout) expect_layout(own, lists, *layout);
    }
    Flow safe = flow;
    const Lists lists = build_safe_lists(safe);
    expect_layout(safe, lists, find_safe_layout(safe, lists));
  }
}

TEST(TwoBendStages, KeepEveryConditionOnRandomGraphs) {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(seed);
    expect_stages(testing::random_graph_of_any_kind(30, seed));
  }
}

TEST(TwoBendStages, KeepEveryConditionOnFamilies) {
  for (const Family& family : families()) {
    if (family.max_degree > 3) continue;
    SCOPED_TRACE(family.name);
    expect_stages(generate(family, 300, 2, {{"shuffle", 1}}));
  }
}

/// Every condition holds on good stages and fails on spoilt ones.
TEST(TwoBendChecks, SeeWhatIsSpoilt) {
  RandomStream random(7);
  LocalGraph graph = components_of(testing::random_cubic_sketch(60, random).graph())[0];
  const BlockTree blocks = find_blocks(graph);
  const TimeOrder order = find_time_order(graph, blocks);
  Flow flow = build_flow(graph, blocks, order);
  const Lists lists = build_lists(flow, true);
  const Layout layout = find_layout(flow, lists, true).value();
  const View rows(flow, false);
  EXPECT_TRUE(is_time_order(graph, order));
  EXPECT_TRUE(arms_are_not_parallel(flow));
  expect_layout(flow, lists, layout);

  TimeOrder turned = order;
  std::rotate(turned.list.begin(), turned.list.begin() + 1, turned.list.end());
  EXPECT_FALSE(is_time_order(graph, turned));
  Flow parallel = flow;
  const auto split = std::find_if(parallel.nodes.begin(), parallel.nodes.end(),
                                  [](const Node& v) { return v.type == NodeType::split; });
  split->neighbour.fill(split->neighbour[split->ins]);
  EXPECT_FALSE(arms_are_not_parallel(parallel));
  LongVector<NodeId> list = lists[0];
  const auto merge =
      std::find_if(list.begin(), list.end(), [&](NodeId v) { return rows.is_listed_merge(v); });
  ASSERT_NE(merge, list.end());
  std::rotate(merge, merge + 1, list.end());  // behind all others
  EXPECT_FALSE(merges_are_between(rows, list));
  const LongVector<LongId>& vv = flow.vv_edges;
  ASSERT_FALSE(vv.empty());
  const NodeId m = flow.edges[vv[0]].lower;
  const NodeId s = flow.edges[vv[0]].upper;
  Layout spoilt = layout;
  spoilt.rows[m] = spoilt.rows[rows.ins(m)[0]];
  EXPECT_FALSE(merges_keep_distances(rows, spoilt.rows));
  spoilt.rows[m] = spoilt.rows[s] + 2;
  spoilt.columns[s] = spoilt.columns[m] + 2;
  EXPECT_FALSE(vv_leans_are_primitive(flow, spoilt));
  std::fill(spoilt.columns.begin(), spoilt.columns.end(), 1);
  EXPECT_FALSE(rays_differ(flow, spoilt));
  EXPECT_FALSE(shared_rows_are_plane(rows, spoilt.columns));
}

/// The height is the least that Lemmas 2.2 and 2.3 allow, so one less must be seen, and so must a
/// lean with an inner lattice point and one that ends beside its arm.
TEST(TwoBendChecks, SeeASpoiltArmOrLean) {
  for (std::int64_t along = 2; along <= 60; ++along) {
    for (std::int64_t across = 1; across <= 60; ++across) {
      const ArmLean good = arm_and_lean(along, across);
      EXPECT_TRUE(is_sound(good, along, across));
      EXPECT_FALSE(is_sound({good.arm, good.run, good.height - 1}, along, across));
      EXPECT_FALSE(is_sound({good.arm + 1, good.run, good.height}, along, across));
      EXPECT_FALSE(is_sound({0, along, good.height + along * along}, along, across));
      if (across > 1 && along > across) {
        EXPECT_FALSE(is_sound({along - across, across, 3 * across}, along, across));
      }
    }
  }
}

}  // namespace
}  // namespace ar3d::two_bend
