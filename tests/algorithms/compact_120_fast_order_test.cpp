// Levels and owners beside the plain ones (compact_120_plain_order.h).
#include <gtest/gtest.h>

#include <boost/pending/disjoint_sets.hpp>
#include <set>
#include <string>
#include <vector>

#include "algorithms/compact_120_plain_order.h"
#include "ar3d/algorithms/compact_120/order.h"
#include "ar3d/generators/catalog.h"

namespace ar3d::compact_120 {
namespace {

void expect_same_owners(const Owners& owners, const Owners& plain) {
  ASSERT_EQ(owners.crowded, plain.crowded);
  if (plain.crowded.empty()) {  // else owners mean nothing
    ASSERT_EQ(owners.sides, plain.sides);
  }
}

/// What Step D.4 promises, by union-find instead of a search.
void expect_owners(const Graph& graph, const Order& order, const Owners& owners) {
  const std::size_t nodes = 2 * std::size_t{graph.num_vertices()};
  const auto node = [&](Vertex v, Vertex towards) {
    return 2 * std::size_t{v} + (order.is_right(v, towards) ? 0 : 1);
  };
  boost::disjoint_sets_with_storage<> sets(nodes);
  const auto root = [&](std::size_t i) { return sets.find_set(i); };
  std::vector<int> owned(nodes), spare(nodes);  // spare: nodes less edges, by root
  for (std::size_t i = 0; i < nodes; ++i) sets.make_set(i);
  for (const Edge& edge : graph.edges()) sets.union_set(node(edge.u, edge.v), node(edge.v, edge.u));
  for (std::size_t i = 0; i < nodes; ++i) ++spare[root(i)];
  for (const Edge& edge : graph.edges()) --spare[root(node(edge.u, edge.v))];
  std::vector<int> tails(graph.num_edges());
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    for (unsigned k = 0; k < graph.degree(v); ++k) {
      const HalfEdge edge = graph.incident(v)[k];
      ASSERT_EQ((owners.right_edges(v) >> k & 1) != 0, order.is_right(v, edge.to));
      if (!owners.owns(v, k)) continue;
      ++tails[edge.edge];
      ++owned[node(v, edge.to)];
    }
  }
  for (EdgeId e = 0; e < graph.num_edges(); ++e) {
    const auto [u, v] = graph.edge(e);
    if (spare[root(node(u, v))] < 0) continue;  // crowded: there owners mean nothing
    ASSERT_EQ(tails[e], 1) << e;
  }
  std::set<Vertex> crowded;
  for (std::size_t i = 0; i < nodes; ++i) {
    const int left = spare[root(i)];
    if (left < 0) crowded.insert(static_cast<Vertex>(i / 2));
    if (left == 0) {
      ASSERT_EQ(owned[i], 1) << "every node of a component with one cycle owns an edge";
    }
    if (left > 0) {
      ASSERT_LE(owned[i], 1);
    }
  }
  ASSERT_EQ(std::set<Vertex>(owners.crowded.begin(), owners.crowded.end()), crowded);
}

TEST(Compact120Owners, FollowRanksThatChange) {
  RandomStream random(3);
  int crowded = 0;
  int uncrowded = 0;
  for (const std::uint64_t n : {4u, 10u, 40u, 400u}) {
    const Graph graph = generate(find_family("random-cubic"), n, n);
    Order order;
    for (Vertex v = 0; v < graph.num_vertices(); ++v) {
      order.rank.push_back(static_cast<std::uint16_t>(10 * v));
    }
    const UnwrittenVector<PaddedRow> rows = rows_of(graph);
    ChangingOwners changing(rows, order);
    for (int step = 0; step < 300; ++step) {
      Order next = order;
      std::vector<Vertex> changed;
      const auto change = [&](Vertex v, std::uint32_t rank) {
        next.rank[v] = static_cast<std::uint16_t>(rank);
        changed.push_back(v);
        for (const HalfEdge& edge : graph.incident(v)) changed.push_back(edge.to);
      };
      for (std::uint32_t i = random.below(6); i > 0; --i) {
        const Vertex v = random.below(graph.num_vertices());
        const std::uint32_t rank = random.below(10 * graph.num_vertices());
        change(v, rank - rank % 10 + 1 + v % 9);
      }
      if (step % 10 == 9) {  // two change sides
        const Edge edge = graph.edge(random.below(static_cast<std::uint32_t>(graph.num_edges())));
        change(edge.u, order.rank[edge.v]);
        change(edge.v, order.rank[edge.u]);
      }
      bool proper = true;
      for (const Edge& edge : graph.edges()) {
        proper = proper && next.rank[edge.u] != next.rank[edge.v];
      }
      if (!proper) continue;
      changing.change(next, changed);
      order = std::move(next);
      const Owners anew = choose_owners(graph, order);
      expect_owners(graph, order, anew);
      expect_same_owners(changing.owners(), anew);
      (anew.crowded.empty() ? uncrowded : crowded) += 1;
    }
  }
  EXPECT_GT(crowded, 100);
  EXPECT_GT(uncrowded, 20);
}

/// @return 1 if the first sweeps left crowded components.
int expect_plain_order(const Graph& graph, std::uint64_t seed) {
  for (const int repairs : {0, 1, 30}) {
    const auto [order, owners] = plain::swept_order(graph, RandomStream(seed), repairs);
    const NarrowOrder fast = narrow_order(graph, strips::NumbersAhead(seed), repairs);
    EXPECT_EQ(fast.moved_components > 0, !owners.crowded.empty());
    if (!owners.crowded.empty()) continue;
    const Links links = assign_arms(graph, order, owners);
    EXPECT_EQ(fast.links.of, links.of);
    EXPECT_TRUE(fast.links.at == links.at);
    for (Vertex v = 0; v < graph.num_vertices(); ++v) {
      EXPECT_EQ(fast.position[v], 100 * order.rank[v] / 3);
    }
  }
  return plain::swept_order(graph, RandomStream(seed), 0).second.crowded.empty() ? 0 : 1;
}

TEST(Compact120Levels, AreThePlainOnesOnEveryFamily) {
  int repaired = 0;
  for (const Family& family : families()) {
    if (family.max_degree > 3) continue;
    for (const std::uint64_t n : {12u, 100u, 1500u}) {
      SCOPED_TRACE(family.name + " " + std::to_string(n));
      repaired += expect_plain_order(generate(family, n, 4, {{"shuffle", 1}}), n);
    }
  }
  EXPECT_GT(repaired, 10);
}

TEST(Compact120Levels, AreThePlainOnesOnALargeGraph) {
  EXPECT_EQ(expect_plain_order(generate(find_family("laves-graph"), 60000, 1), 1), 1);
}

}  // namespace
}  // namespace ar3d::compact_120
