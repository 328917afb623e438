// Who meets anything older: the sweep against the plain comparison of all pairs.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "algorithms/two_bend_109_support.h"
#include "ar3d/algorithms/two_bend_109/drawn_segments.h"
#include "ar3d/algorithms/two_bend_109/layout.h"
#include "ar3d/base/random.h"
#include "ar3d/generators/catalog.h"
#include "support/graphs.h"

namespace ar3d::two_bend_109 {
namespace {

using Owners = std::vector<std::uint32_t>;

/// What owners_that_meet() says, from all pairs in exact integers. Of what is as before nothing may
/// meet.
Owners plain(const DrawnSegments& drawn, const DrawnSegments&) {
  std::set<std::uint32_t> owners;
  const auto compare = [&](const DrawnSegment& a, const DrawnSegment& b) {
    if (a.owner != b.owner && meet(a.at, b.at)) owners.insert(std::max(a.owner, b.owner));
  };
  for (std::size_t i = 0; i < drawn.middles.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) compare(drawn.middles[i], drawn.middles[j]);
    for (std::size_t j = 0; j < drawn.stubs.size(); ++j) {
      if (j != drawn.middles[i].stub) compare(drawn.middles[i], drawn.stubs[j]);
    }
  }
  return Owners(owners.begin(), owners.end());
}

/// How many points were tried, or -1 if some square is too small; equal both ways.
std::int64_t tried_both_ways(const Graph& graph, LayoutScale scale) {
  const OrderedGraph order = testing::ordered(graph);
  const SlotArrangement arrangement = arrange(order);
  const Layout layout = lay_out(order, order.parts, arrangement, scale);
  Placement fast(graph.num_vertices()), slow(graph.num_vertices());
  const bool is_placed = place(order, order.parts, arrangement, layout, 1, slow, plain);
  EXPECT_EQ(place(order, order.parts, arrangement, layout, 1, fast), is_placed);
  if (!is_placed) return -1;
  EXPECT_EQ(fast.at, slow.at);
  EXPECT_EQ(fast.ends, slow.ends);
  EXPECT_EQ(fast.tried, slow.tried);
  return slow.tried;
}

TEST(TwoBend109Comparison, SmallGraphsArePlacedAlikeBothWays) {
  int failed = 0, retried = 0;
  for (const Graph& graph : testing::geng("-c -D4 7")) {
    for (const LayoutScale scale :
         {LayoutScale{1}, LayoutScale{2}, LayoutScale{16}, LayoutScale::always_enough(7)}) {
      const std::int64_t tried = tried_both_ways(graph, scale);
      failed += tried < 0 ? 1 : 0;
      retried += tried > 7 ? 1 : 0;
    }
  }
  EXPECT_GT(failed, 0);
  EXPECT_GT(retried, 0);
}

TEST(TwoBend109Comparison, LargeGraphsArePlacedAlikeBothWays) {
  for (const char* family : {"random-4-regular", "torus", "percolated-square-grid"}) {
    for (const int n : {100, 700, 1600}) {
      const Graph graph = generate(find_family(family), static_cast<std::uint64_t>(n), 4);
      if (connected_components_of(graph).count > 1) continue;
      EXPECT_GE(tried_both_ways(graph, {16}), n >= 700 ? n + 1 : 1) << "some are tried twice";
      // In squares of four points much meets, so there are rounds in which few have moved.
      tried_both_ways(graph, {2});
      tried_both_ways(graph, LayoutScale::always_enough(static_cast<std::uint64_t>(n)));
    }
  }
}

/// As many middles and stubs at random places, upwards, of owners in order.
DrawnSegments random_segments(std::uint32_t count, std::uint32_t size, RandomStream& random) {
  const auto segment = [&](std::uint32_t owner) {
    for (;;) {
      const Point p{random.below(size), random.below(size), random.below(size)};
      const Point q{random.below(size), random.below(size), random.below(size)};
      if (p != q && p.z <= q.z) return DrawnSegment{{p, q}, owner, 0};
    }
  };
  DrawnSegments drawn;
  for (std::uint32_t i = 0; i < count; ++i) {
    drawn.stubs.push_back(segment(i));
    drawn.middles.push_back(segment(i));
    drawn.middles.back().stub = random.below(i + 1);
  }
  return drawn;
}

TEST(TwoBend109Comparison, SaysOfRandomSegmentsWhatThePlainOneSays) {
  RandomStream random(5);
  std::size_t met = 0, pairs = 0;
  for (std::uint32_t i = 0; i < 3000; ++i) {
    const DrawnSegments drawn = random_segments(1 + i % 120, 3 + i % 40, random);
    const Owners owners = owners_that_meet(drawn, {});
    ASSERT_EQ(owners, plain(drawn, {})) << i;
    met += owners.size();
    pairs += drawn.middles.size();
  }
  EXPECT_GT(met, 1000u);
  EXPECT_LT(met + 1000, pairs);
}

TEST(TwoBend109Comparison, FewThatMovedAreComparedWithAll) {
  RandomStream random(7);
  std::size_t met = 0;
  for (std::uint32_t i = 0; i < 300; ++i) {
    const std::uint32_t count = 100 + i % 50;
    DrawnSegments drawn = random_segments(count, 300, random);
    const Owners known = plain(drawn, {});
    for (auto* all : {&drawn.middles, &drawn.stubs}) {  // without those that meet
      std::erase_if(*all, [&](const DrawnSegment& one) {
        return std::find(known.begin(), known.end(), one.owner) != known.end();
      });
    }
    for (DrawnSegment& middle : drawn.middles) middle.stub = ~0u;
    ASSERT_TRUE(plain(drawn, {}).empty());
    const DrawnSegments before = drawn;
    for (auto* all : {&drawn.middles, &drawn.stubs}) {
      LatticeSegment& moved = (*all)[random.below(static_cast<std::uint32_t>(all->size()))].at;
      const Point p =
          drawn.middles[random.below(static_cast<std::uint32_t>(drawn.middles.size()))].at.from;
      moved = {p + Vector{-2, 4, -6}, p + Vector{1, -2, 3}};
    }
    const Owners owners = owners_that_meet(drawn, before);
    ASSERT_EQ(owners, plain(drawn, {})) << i;
    met += owners.size();
  }
  EXPECT_GT(met, 300u);
}

/// A segment through the point, of 2^bits along each axis.
LatticeSegment through(Point p, RandomStream& random, int bits) {
  const auto part = [&] {
    return static_cast<std::int64_t>(random.next64() >> (65 - bits)) *
           (random.below(2) == 0 ? 1 : -1);
  };
  const Vector u{part() / 4, part() / 4, std::abs(part() | 1)};
  return {p + -u, p + u};
}

// Neither rounding nor the borders of slabs and cells hide a meeting, whatever the size.
TEST(TwoBend109Comparison, FindsEveryMeetingOfLargeSegments) {
  RandomStream random(6);
  for (int bits = 8; bits <= 59; ++bits) {
    for (std::uint32_t i = 0; i < 100; ++i) {
      const auto coordinate = [&] {
        return static_cast<std::int64_t>(random.next64() >> (64 - bits));
      };
      const Point p{coordinate(), coordinate(), coordinate()};
      DrawnSegments drawn;
      for (std::uint32_t k = 0; k < i; ++k) {  // many beside
        const Point q{coordinate(), coordinate(), coordinate()};
        drawn.middles.push_back({through(q, random, bits), k, ~0u});
        drawn.stubs.push_back({{q, q + Vector{1, 11, 19}}, k, 0});
      }
      drawn.middles.push_back({through(p, random, bits), 100, ~0u});
      const bool is_stub = i % 2 == 0;
      (is_stub ? drawn.stubs : drawn.middles).push_back({through(p, random, bits), 101, ~0u});
      const Owners owners = owners_that_meet(drawn, {});
      EXPECT_THAT(owners, ::testing::Contains(101u)) << bits;
      EXPECT_EQ(owners, plain(drawn, {}));
    }
  }
}

TEST(TwoBend109Comparison, LeavesOutTheStubAtWhoseEndTheMiddleBegins) {
  DrawnSegments drawn;
  for (const Vector end : stubs_of(Stance::middle, 0).ends) {
    const Point at{0, 0, 0};
    drawn.stubs.push_back(
        {end.z > 0 ? LatticeSegment{at, at + end} : LatticeSegment{at + end, at}, 0, 0});
  }
  for (std::uint32_t i = 0; i < 4; ++i) {
    const Point end = Point{0, 0, 0} + stubs_of(Stance::middle, 0).ends[i];
    for (std::uint32_t stub = 0; stub < 4; ++stub) {
      drawn.middles = {{{end, end + Vector{3, 5, 100}}, 1, stub}};
      EXPECT_EQ(owners_that_meet(drawn, {}), stub == i ? Owners{} : Owners{1});
    }
    drawn.middles[0].owner = 0;
    EXPECT_EQ(owners_that_meet(drawn, {}), Owners{}) << "of one owner";
  }
}

/// Counts conditions as Lemma E.5 does: segments of older vertices above the lower end of each edge
/// down or back along a cycle, and that the edge is not flat. Returns how many bodies with edges to
/// earlier parts there are.
int expect_few_conditions(const Graph& graph, const std::string& name) {
  const auto n = static_cast<std::int64_t>(graph.num_vertices());
  std::int64_t segments = 0;
  std::vector<std::optional<std::int64_t>> before(graph.num_vertices());  // drawn before a vertex
  int bodies = 0;
  for (const VertexPart& part : find_partition(graph)) {
    const bool is_body = part.kind == PartKind::body;
    std::int64_t sum = 0, edges = 0;
    for (const Vertex v : part.vertices) {
      for (const HalfEdge& half : graph.incident(v)) {
        if (!before[half.to]) continue;
        ++edges;
        sum += segments - *before[half.to];
      }
      if (is_body) continue;
      EXPECT_LT(sum + 4 * edges + edges * (edges - 1) / 2 + 10, 18 * n + 22) << name;
      before[v] = segments;
      segments += 4 + edges;
      sum = edges = 0;
    }
    if (!is_body) continue;
    EXPECT_LT(sum + edges + edges * (edges - 1) / 2, 36 * n + 22) << name;
    segments += 2 * edges + 3 * static_cast<std::int64_t>(part.body->links.size());
    bodies += n > static_cast<std::int64_t>(part.vertices.size()) ? 1 : 0;
  }
  return bodies;
}

TEST(TwoBend109Comparison, ConditionsAreFewerThanTheLemmaSays) {
  for (const Family& family : families()) {
    const Graph graph = generate(family, 200, 1);
    if (connected_components_of(graph).count == 1) expect_few_conditions(graph, family.name);
  }
  int bodies = 0;
  for (const Graph& graph : testing::geng("-c -D4 8")) {
    bodies += expect_few_conditions(graph, "a graph with 8 vertices");
  }
  EXPECT_GT(bodies, 0);
}

}  // namespace
}  // namespace ar3d::two_bend_109
