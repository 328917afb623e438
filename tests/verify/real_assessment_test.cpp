// What is found in drawings of real types, without tolerance.
#include "ar3d/verify/assessment/real_assessment.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <utility>
#include <vector>

#include "ar3d/base/error.h"
#include "ar3d/base/random.h"
#include "ar3d/verify/assessment/real_segments.h"

namespace ar3d::testing {
namespace {

using verify::BigVector;
using verify::short_of_120;

BigPoint point(std::int64_t x, std::int64_t y, std::int64_t z) { return {x, y, z}; }

RealPoints drawing(std::vector<BigPoint> vertices, const std::vector<std::vector<BigPoint>>& bends,
                   int unit_exponent = 0) {
  RealPoints points;
  points.unit_exponent = unit_exponent;
  points.vertices = std::move(vertices);
  for (const auto& list : bends) {
    points.bends.insert(points.bends.end(), list.begin(), list.end());
    points.offsets.push_back(points.bends.size());
  }
  return points;
}

TEST(RealAssessment, AngleOf120IsNoMiss) {
  EXPECT_EQ(short_of_120(point(1, -1, 0), point(0, 1, -1)), 0);
  EXPECT_EQ(short_of_120(point(7, -7, 0), point(0, 3, -3)), 0);
}

TEST(RealAssessment, MissesOfKnownAngles) {
  EXPECT_NEAR(short_of_120(point(1, 0, 0), point(0, 1, 0)), 30, 1e-13);
  EXPECT_NEAR(short_of_120(point(1, 0, 0), point(-5, 0, 0)), -60, 1e-13);
  EXPECT_NEAR(short_of_120(point(1, 0, 0), point(3, 0, 0)), 120, 1e-13);
  EXPECT_NEAR(short_of_120(point(1, 0, 0), point(-1, 1, 0)), -15, 1e-13);
  EXPECT_NEAR(short_of_120(point(1, 0, 0), point(1, 1, 0)), 75, 1e-13);
}

/// (N, -N, 1) and (0, 1, -1): the angle is 120 degrees and about 1 / (N 2 sqrt3 ...) more or less;
/// the formula of two doubles would see nothing. Compared with 500 bits.
TEST(RealAssessment, TinyMissesKeepTheirRelativeAccuracy) {
  using Exact = boost::multiprecision::number<
      boost::multiprecision::cpp_bin_float<500, boost::multiprecision::digit_base_2>>;
  RandomStream random(3);
  for (int i = 0; i < 300; ++i) {
    const unsigned bits = 10 + random.below(120);
    const auto perturbed = [&](int c) {
      return BigInteger((BigInteger(c) << bits) + static_cast<int>(random.below(7)) - 3);
    };
    const BigVector u{perturbed(1), perturbed(-1), perturbed(0)};
    const BigVector v{perturbed(0), perturbed(1), perturbed(-1)};
    const Exact a(dot(u, v)), b(dot(u, u)), c(dot(v, v));
    const Exact angle = acos(a / sqrt(b * c));
    const Exact wanted = (acos(Exact(-1) / 2) - angle) * 180 / acos(Exact(-1));
    const auto expected = static_cast<double>(wanted);
    EXPECT_NEAR(short_of_120(u, v), expected, 1e-13 * std::abs(expected)) << bits;
  }
}

TEST(RealAssessment, CountsAnglesSharesAndBends) {
  // A star of degree 3 in the plane x + y + z = 0, and an edge with one bend of 90 degrees.
  const Graph graph(6, {{0, 1}, {0, 2}, {0, 3}, {4, 5}});
  const RealAssessment found =
      assess(graph, drawing({point(0, 0, 0), point(1, -1, 0), point(0, 1, -1), point(-1, 0, 1),
                             point(9, 0, 0), point(10, 1, 0)},
                            {{}, {}, {}, {point(10, 0, 0)}}));
  EXPECT_EQ(found.angles, 4u);
  EXPECT_NEAR(found.largest_miss, 30, 1e-13);
  EXPECT_NEAR(found.mean_square_miss, 900. / 4, 1e-10);
  EXPECT_EQ(found.within, (std::array<std::uint64_t, 4>{3, 3, 3, 3}));
  EXPECT_EQ(found.bend_histogram, (std::vector<std::uint64_t>{3, 1}));
  EXPECT_EQ(found.segments, 5u);
  EXPECT_FALSE(found.is_broken());
}

TEST(RealAssessment, AtABendMoreThan120IsRightAndAtAVertexOfDegree3ItIsNot) {
  const Graph path(3, {{0, 1}, {1, 2}});
  EXPECT_EQ(assess(path, drawing({point(0, 0, 0), point(1, 0, 0), point(2, 0, 0)}, {{}, {}}))
                .largest_miss,
            0);
  const Graph star(4, {{0, 1}, {0, 2}, {0, 3}});
  EXPECT_NEAR(
      assess(star, drawing({point(0, 0, 0), point(1, 0, 0), point(-1, 0, 0), point(0, 0, 1)},
                           {{}, {}, {}}))
          .largest_miss,
      60, 1e-12);
}

TEST(RealAssessment, CollapsedSegmentsAreCountedAndLeftOut) {
  const Graph graph(2, {{0, 1}});
  const RealAssessment found =
      assess(graph, drawing({point(0, 0, 0), point(2, 0, 0)},
                            {{point(1, 0, 0), point(1, 0, 0), point(2, 0, 0)}}));
  EXPECT_EQ(found.collapsed, 2u);
  EXPECT_EQ(found.segments, 2u);
  EXPECT_EQ(found.angles, 1u);
  EXPECT_EQ(found.crossings, 0u);
  EXPECT_TRUE(found.is_broken());
}

TEST(RealAssessment, SeesCrossingsOverlapsAndVerticesOnEdges) {
  const Graph two(4, {{0, 1}, {2, 3}});
  const auto crossings = [&](std::vector<BigPoint> vertices) {
    return assess(two, drawing(std::move(vertices), {{}, {}})).crossings;
  };
  EXPECT_EQ(crossings({point(0, 0, 0), point(2, 2, 0), point(0, 2, 0), point(2, 0, 0)}), 1u);
  EXPECT_EQ(crossings({point(0, 0, 0), point(4, 0, 0), point(3, 0, 0), point(9, 0, 0)}), 1u);
  EXPECT_EQ(crossings({point(0, 0, 0), point(4, 0, 0), point(2, 0, 0), point(2, 5, 0)}), 1u);
  EXPECT_EQ(crossings({point(0, 0, 0), point(4, 0, 0), point(4, 0, 0), point(9, 5, 0)}), 1u);
  EXPECT_EQ(crossings({point(0, 0, 0), point(4, 0, 0), point(5, 0, 0), point(9, 0, 0)}), 0u);
  EXPECT_EQ(crossings({point(0, 0, 0), point(2, 2, 0), point(0, 2, 1), point(2, 0, 1)}), 0u);
  const Graph path(3, {{0, 1}, {1, 2}});
  EXPECT_EQ(
      assess(path, drawing({point(0, 0, 0), point(3, 0, 0), point(1, 0, 0)}, {{}, {}})).crossings,
      1u)
      << "neighbours that run back over each other";
  const Graph lone(3, {{0, 1}});
  EXPECT_EQ(assess(lone, drawing({point(0, 0, 0), point(4, 0, 0), point(2, 0, 0)}, {{}})).crossings,
            1u);
}

/// The filter and the sweep against every pair, on drawings of few lattice points, as they are and
/// far away from the origin, where doubles cannot tell the points apart.
TEST(RealAssessment, CrossingsAreThoseOfAllPairs) {
  RandomStream random(2);
  std::uint64_t total = 0;
  for (int i = 0; i < 1500; ++i) {
    const Vertex n = 3 + random.below(6);
    std::vector<Edge> edges;
    for (Vertex v = 1; v < n; ++v) {
      if (random.below(4) > 0) edges.push_back({random.below(v), v});
    }
    const Graph graph(n, edges);
    const BigInteger far = i % 3 == 0 ? BigInteger(0) : BigInteger(1) << (20 * (i % 7));
    const auto any = [&]() -> BigPoint {
      return {far + random.below(3), far + random.below(3), random.below(3)};
    };
    std::vector<BigPoint> vertices;
    for (Vertex v = 0; v < n; ++v) vertices.push_back(any());
    std::vector<std::vector<BigPoint>> bends(graph.num_edges());
    for (auto& list : bends) {
      for (std::uint32_t b = random.below(3); b > 0; --b) list.push_back(any());
    }
    const RealPoints points = drawing(vertices, bends, -static_cast<int>(random.below(60)));
    const std::vector<verify::RealSegment> segments = verify::segments_of(graph, points);
    std::uint64_t expected = 0;
    for (std::size_t s = 0; s < segments.size(); ++s) {
      for (std::size_t t = 0; t < s; ++t) expected += verify::crosses(graph, segments, s, t);
    }
    ASSERT_EQ(verify::count_crossings(graph, segments, points.unit_exponent), expected);
    total += expected;
  }
  EXPECT_GT(total, 1000u);
}

TEST(RealAssessment, DoesNotDependOnTheUnit) {
  const Graph star(4, {{0, 1}, {0, 2}, {0, 3}});
  const auto at = [&](int unit, const BigInteger& scale) {
    return assess(star, drawing({{0, 0, 0}, {scale, 0, 0}, {-scale, scale, 0}, {0, -scale, scale}},
                                {{}, {}, {}}, unit));
  };
  const RealAssessment one = at(0, 1);
  for (const unsigned shift : {1u, 60u, 300u}) {
    const RealAssessment other = at(-static_cast<int>(shift), BigInteger(1) << shift);
    EXPECT_EQ(one.largest_miss, other.largest_miss);
    EXPECT_EQ(one.condition, other.condition);
  }
}

TEST(RealAssessment, RefusesADrawingOfAnotherGraph) {
  EXPECT_THROW(assess(Graph(2, {{0, 1}}), drawing({point(0, 0, 0)}, {{}})), InputError);
  EXPECT_THROW(assess(Graph(1, {}), drawing({point(0, 0, 0)}, {{}})), InputError);
}

TEST(RealPoints, SumsOfDoublesAreExact) {
  const double parts[] = {1, 0x1p-60, -0x1p-130};
  const DyadicNumber sum = dyadic_sum(parts);
  EXPECT_EQ(sum.exponent, -130);
  EXPECT_EQ(sum.integer, (BigInteger(1) << 130) + (BigInteger(1) << 70) - 1);
  EXPECT_EQ(dyadic_sum({}).integer, 0);
  const double denormal[] = {-0x1p-1074};
  EXPECT_EQ(dyadic_sum(denormal).integer, -1);
  EXPECT_EQ(dyadic_sum(denormal).exponent, -1074);
  const double infinite[] = {std::numeric_limits<double>::infinity()};
  EXPECT_THROW(dyadic_sum(infinite), InternalError);
}

TEST(RealPoints, GetTheCoarsestCommonUnit) {
  const auto number = [](double value) { return dyadic_sum(std::span(&value, 1)); };
  RealPointsBuilder builder("double");
  builder.add_vertex({number(0.75), number(-4), number(0)});
  builder.add_edge({{number(1.5), number(0), number(0)}});
  const RealPoints points = builder.finish();
  EXPECT_EQ(points.unit_exponent, -2);
  EXPECT_EQ(points.vertices[0], (BigPoint{3, -16, 0}));
  EXPECT_EQ(points.bends_of(0)[0], (BigPoint{6, 0, 0}));
}

}  // namespace
}  // namespace ar3d::testing
