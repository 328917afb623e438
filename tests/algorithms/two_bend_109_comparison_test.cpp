// How a new segment is compared with the older ones: the fast way against the plain one.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

#include "ar3d/algorithms/two_bend_109/drawn_segments.h"
#include "ar3d/algorithms/two_bend_109/layout.h"
#include "ar3d/algorithms/two_bend_109/placement.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/model/random.h"
#include "support/graphs.h"

namespace ar3d::two_bend_109 {
namespace {

/// How many points were tried, or -1 if some vertex found none; equal both ways.
std::int64_t tried_both_ways(const Graph& graph, Scale scale) {
  const auto parts = find_partition(graph);
  const Arrangement arrangement = arrange(graph, parts);
  const Layout layout = lay_out(graph, parts, arrangement, scale);
  const auto fast = place(graph, parts, arrangement, layout, 1, Comparison::filtered);
  const auto plain = place(graph, parts, arrangement, layout, 1, Comparison::plain);
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
    for (const Scale scale : {Scale{1}, Scale{2}, Scale{16}, Scale::always_enough(7)}) {
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
    tried_both_ways(graph, Scale::always_enough(static_cast<std::uint64_t>(n)));
  }
}

Star star_at(Point at) { return {at, stubs_of(Stance::middle, 0).ends}; }

/// Both kinds of comparison, on the same things.
struct Both {
  PlainSegments plain;
  DrawnSegments fast;

  /// The first star is nobody's neighbour.
  explicit Both(Point first) { add(star_at(first)); }
  void add(const Star& star) {
    plain.add_star(star);
    fast.add_star(star);
  }
  void add(const Segment& line) {
    plain.add_line(line);
    fast.add_line(line);
  }
  bool meets(const Segment& segment) const {
    const Query query{segment, {}, 0};
    EXPECT_EQ(fast.meets_any(query), plain.meets_any(query));
    return plain.meets_any(query);
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
    const Segment segment{point(), point()};
    const Segment line{point(), point()};
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
Segment through(Point p, RandomStream& random, int bits, bool upwards) {
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
        both.add(Segment{{coordinate(), 0, 0}, {coordinate(), -7, 1}});
      }
      Both other = both;
      both.add(through(p, random, bits, false));
      EXPECT_TRUE(both.meets(through(p, random, bits, true))) << bits;
      const Star star = star_at(p);
      other.add(star);
      const Point end = p + star.stubs[random.below(4)];
      EXPECT_TRUE(other.meets(through(end, random, bits, i % 2 == 0))) << bits;
    }
  }
}

TEST(TwoBend109Comparison, LeavesOutTheStubAtWhoseEndTheSegmentBegins) {
  Both both({0, 0, 0});
  const Star star = star_at({0, 0, 0});
  for (std::size_t i = 0; i < 4; ++i) {
    const Point end = star.segment(i).to;
    const Segment away{end, end + star.stubs[i]};
    for (std::size_t stub = 0; stub < 4; ++stub) {
      const Query query{away, {}, stub};
      EXPECT_EQ(both.plain.meets_any(query), stub != i);
      EXPECT_EQ(both.fast.meets_any(query), stub != i);
    }
  }
}

// The count of Lemma E.5, from the parts of a graph: segments of older vertices above the lower end
// of each edge down or back along a cycle.
TEST(TwoBend109Comparison, ConditionsAreFewerThanTheLemmaSays) {
  for (const Family& family : families()) {
    const Graph graph = generate(family, 200, 1);
    if (connected_components_of(graph).count != 1) continue;
    const auto parts = find_partition(graph);
    std::vector<std::int64_t> stars_before(graph.num_vertices(), -1);
    std::vector<std::int64_t> lines_before(graph.num_vertices());
    std::int64_t stars = 0, lines = 0;
    for (const Part& part : parts) {
      if (part.kind == PartKind::body) continue;
      for (const Vertex v : part.vertices) {
        std::int64_t conditions = 0, edges = 0;
        for (const HalfEdge& half : graph.incident(v)) {
          if (stars_before[half.to] < 0) continue;
          ++edges;
          conditions += 4 * (stars - stars_before[half.to]) + lines - lines_before[half.to] + 3;
        }
        conditions += edges * (edges - 1) / 2 + 10;
        EXPECT_LT(conditions, 18 * static_cast<std::int64_t>(graph.num_vertices()) + 18)
            << family.name;
        stars_before[v] = stars++;
        lines_before[v] = lines;
        lines += edges;
      }
    }
  }
}

}  // namespace
}  // namespace ar3d::two_bend_109
