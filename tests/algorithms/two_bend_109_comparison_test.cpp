// How a new segment is compared with the older ones: the fast way against the plain one.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "ar3d/algorithms/two_bend_109/drawn_segments.h"
#include "ar3d/algorithms/two_bend_109/layout.h"
#include "ar3d/algorithms/two_bend_109/placement.h"
#include "ar3d/base/random.h"
#include "ar3d/generators/catalog.h"
#include "support/graphs.h"

namespace ar3d::two_bend_109 {
namespace {

/// How many points were tried, or -1 if some vertex found none; equal both ways.
std::int64_t tried_both_ways(const Graph& graph, LayoutScale scale) {
  const auto parts = find_partition(graph);
  const SlotArrangement arrangement = arrange(graph, parts);
  const Layout layout = lay_out(graph, parts, arrangement, scale);
  const auto fast = place(graph, parts, arrangement, layout, 1);
  const auto plain = place(graph, parts, arrangement, layout, 1, /*is_filtered=*/false);
  EXPECT_EQ(fast.has_value(), plain.has_value());
  if (!fast || !plain) return -1;
  EXPECT_EQ(fast->at, plain->at);
  EXPECT_EQ(fast->ends, plain->ends);
  EXPECT_EQ(fast->tried, plain->tried);
  return plain->tried;
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
  for (const int n : {100, 700, 2000}) {
    const Graph graph = generate(find_family("random-4-regular"), static_cast<std::uint64_t>(n), 4);
    EXPECT_GE(tried_both_ways(graph, {16}), n >= 700 ? n + 1 : 1) << "some are tried twice";
    tried_both_ways(graph, LayoutScale::always_enough(static_cast<std::uint64_t>(n)));
  }
}

VertexStubs star_at(Point at) { return {at, stubs_of(Stance::middle, 0).ends}; }

/// Both kinds of comparison, on the same things.
struct Both {
  DrawnSegments plain{/*is_filtered=*/false};
  DrawnSegments fast;

  /// The first star is nobody's neighbour.
  explicit Both(Point first) { add(star_at(first)); }
  void add(const VertexStubs& star) {
    plain.add_star(star);
    fast.add_star(star);
  }
  void add(const LatticeSegment& line) {
    plain.add_line(line);
    fast.add_line(line);
  }
  bool meets(const LatticeSegment& segment) const {
    const bool meets = plain.meets_any(segment, {}, 0);
    EXPECT_EQ(fast.meets_any(segment, {}, 0), meets);
    return meets;
  }
};

TEST(TwoBend109Comparison, SaysOfRandomSegmentsWhatThePlainOneSays) {
  RandomStream random(5);
  int stars = 0, lines = 0;
  for (int i = 0; i < 20000; ++i) {
    const std::uint32_t size = 3 + static_cast<std::uint32_t>(i % 12);
    const auto point = [&] {
      return Point{random.below(size), random.below(size), random.below(size)};
    };
    const LatticeSegment segment{point(), point()};
    const LatticeSegment line{point(), point()};
    if (segment.from == segment.to || line.from == line.to) continue;
    Both with_star({1000, 1000, -1000});
    with_star.add(star_at(point()));
    stars += with_star.meets(segment) ? 1 : 0;
    Both with_line({1000, 1000, -1000});
    with_line.add(line);
    lines += with_line.meets(segment) ? 1 : 0;
  }
  EXPECT_GT(stars, 300);
  EXPECT_GT(lines, 300);
}

/// A segment through the point, of 2^bits along each axis.
LatticeSegment through(Point p, RandomStream& random, int bits, bool upwards) {
  const auto part = [&] {
    return static_cast<std::int64_t>(random.next64() >> (65 - bits)) *
           (random.below(2) == 0 ? 1 : -1);
  };
  Vector u{part() / 4, part() / 4, part() | 1};
  if (upwards) u.z = std::abs(u.z);
  return {p + -u, p + u};
}

// Rounding must not hide a meeting, whatever the size of the numbers.
TEST(TwoBend109Comparison, FindsEveryMeetingOfLargeSegments) {
  RandomStream random(6);
  for (int bits = 8; bits <= 59; ++bits) {
    for (int i = 0; i < 200; ++i) {
      const auto coordinate = [&] {
        return static_cast<std::int64_t>(random.next64() >> (64 - bits));
      };
      const Point p{coordinate(), coordinate(), coordinate()};
      Both both({-5000, 0, -5000});
      // Many that do not meet it, so that blocks of several are seen.
      for (int k = 0; k < i; ++k) {
        both.add(star_at({coordinate(), coordinate() + 100, coordinate()}));
        both.add(LatticeSegment{{coordinate(), 0, 0}, {coordinate(), -7, 1}});
      }
      Both other = both;
      both.add(through(p, random, bits, false));
      EXPECT_TRUE(both.meets(through(p, random, bits, true))) << bits;
      const VertexStubs star = star_at(p);
      other.add(star);
      const Point end = p + star.stubs[random.below(4)];
      EXPECT_TRUE(other.meets(through(end, random, bits, i % 2 == 0))) << bits;
    }
  }
}

TEST(TwoBend109Comparison, LeavesOutTheStubAtWhoseEndTheSegmentBegins) {
  Both both({0, 0, 0});
  const VertexStubs star = star_at({0, 0, 0});
  for (std::size_t i = 0; i < 4; ++i) {
    const Point end = star.segment(i).to;
    const LatticeSegment away{end, end + star.stubs[i]};
    for (std::size_t stub = 0; stub < 4; ++stub) {
      EXPECT_EQ(both.plain.meets_any(away, {}, stub), stub != i);
      EXPECT_EQ(both.fast.meets_any(away, {}, stub), stub != i);
    }
  }
}

/// Conditions as Lemma E.5 counts them: segments of older vertices above the lower end of each edge
/// down or back along a cycle.
class ConditionCount {
 public:
  explicit ConditionCount(const Graph& graph) : graph_(graph), before_(graph.num_vertices()) {}

  /// Of the vertices of one part that is no body, each; of a body as a whole.
  std::vector<std::int64_t> of(const VertexPart& part) {
    std::vector<std::int64_t> conditions;
    if (part.kind == PartKind::body) {
      std::int64_t sum = 0, edges = 0;
      for (const Vertex v : part.vertices) sum += edges_down(v, edges);
      conditions.push_back(sum + edges * (edges - 1) / 2);
      segments_ += edges + 3 * static_cast<std::int64_t>(part.body->links.size()) + edges;
      return conditions;
    }
    for (const Vertex v : part.vertices) {
      std::int64_t edges = 0;
      const std::int64_t sum = edges_down(v, edges);
      conditions.push_back(sum + 3 * edges + edges * (edges - 1) / 2 + 10);
      before_[v] = segments_;
      segments_ += 4 + edges;
    }
    return conditions;
  }

 private:
  std::int64_t edges_down(Vertex v, std::int64_t& edges) const {
    std::int64_t sum = 0;
    for (const HalfEdge& half : graph_.incident(v)) {
      if (!before_[half.to]) continue;
      ++edges;
      sum += segments_ - *before_[half.to];
    }
    return sum;
  }

  const Graph& graph_;
  std::int64_t segments_ = 0;
  std::vector<std::optional<std::int64_t>> before_;  ///< segments drawn before a vertex
};

/// How many bodies with edges to earlier parts it has.
int expect_few_conditions(const Graph& graph, const std::string& name) {
  ConditionCount count(graph);
  const auto n = static_cast<std::int64_t>(graph.num_vertices());
  int bodies = 0;
  for (const VertexPart& part : find_partition(graph)) {
    const bool is_body = part.kind == PartKind::body;
    bodies += is_body && n > static_cast<std::int64_t>(part.vertices.size()) ? 1 : 0;
    for (const std::int64_t conditions : count.of(part)) {
      EXPECT_LT(conditions, is_body ? 36 * n + 16 : 18 * n + 18) << name;
    }
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
