#include "ar3d/algorithms/two_bend_paper/two_bend_paper.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "algorithms/two_bend_paper_support.h"
#include "ar3d/algorithms/catalog.h"
#include "ar3d/algorithms/two_bend_paper/contraction.h"
#include "ar3d/algorithms/two_bend_paper/general_position.h"
#include "ar3d/algorithms/two_bend_paper/growth.h"
#include "ar3d/base/error.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/verify/assessment/real_segments.h"
#include "ar3d/verify/examination.h"

namespace ar3d::testing {
namespace {

using two_bend_paper::draw_real;
using two_bend_paper::FigureKind;
using two_bend_paper::RealType;

Graph made(const char* family, std::uint64_t n, std::uint64_t seed = 1) {
  return generate(find_family(family), n, seed);
}

TEST(TwoBendPaper, AllSmallGraphs) {
  for (int n = 1; n <= 7; ++n) {
    for (const Graph& graph : geng(fmt::format("-D3 {}", n))) {
      expect_right_in_reference(graph);
      if (HasFailure()) return;
    }
  }
  expect_right_in_reference(Graph());
}

TEST(TwoBendPaper, SmallConnectedCubicGraphsAsGivenAndRelabelled) {
  for (int n = 4; n <= 10; n += 2) {
    std::uint64_t seed = 0;
    for (const Graph& graph : geng(fmt::format("-c -d3 -D3 {}", n))) {
      expect_right_in_reference(graph);
      expect_right_in_reference(shuffled(graph, ++seed));
    }
  }
}

TEST(TwoBendPaper, EveryFamilyOfMaximumDegreeThree) {
  for (const Family& family : families()) {
    if (family.max_degree > 3) continue;
    expect_right_in_reference(generate(family, 40, 7), family.name);
  }
}

TEST(TwoBendPaper, NestsOfHexagonsAndHeptagons) {
  for (const int levels : {1, 2, 3, 10, 40, 79}) {
    expect_right_in_reference(nest(complete(4), levels), "hexagons in K4");
  }
  for (const int levels : {1, 2, 3, 10, 30}) {
    expect_right_in_reference(nest(cycle(5), levels), "heptagons in C5");
    expect_right_in_reference(nest(path(3), levels), "heptagons in a path");
  }
}

TEST(TwoBendPaper, RandomMixturesOfFigures) { expect_mixtures_right(60, RandomStream(1), 8, 12); }

TEST(TwoBendPaper, Unions) {
  const Graph five = disjoint_union({complete(4), cycle(5), path(1), petersen(), path(3)});
  const Graph graph = disjoint_union(std::vector<Graph>(40, five));
  expect_right_in_reference(graph);
  expect_right_in_reference(shuffled(graph, 5));
}

TEST(TwoBendPaper, RandomCubicGraphs) {
  for (const std::uint64_t n : {10, 30, 100, 300}) {
    expect_right_in_reference(made("random-cubic", n, n));
  }
}

double coordinate(const BigInteger& value, int unit) { return verify::rounded(value, unit); }

/// Largest difference of coordinates in relation to the largest coordinate.
double difference_of(const RealPoints& a, const RealPoints& b) {
  double largest = 1, difference = 0;
  const auto look_at = [&](const BigInteger& x, const BigInteger& y) {
    const double p = coordinate(x, a.unit_exponent), q = coordinate(y, b.unit_exponent);
    largest = std::max({largest, std::abs(p), std::abs(q)});
    difference = std::max(difference, std::abs(p - q));
  };
  const auto look_at_lists = [&](const std::vector<BigPoint>& p, const std::vector<BigPoint>& q) {
    ASSERT_EQ(p.size(), q.size());
    for (std::size_t i = 0; i < p.size(); ++i) {
      look_at(p[i].x, q[i].x);
      look_at(p[i].y, q[i].y);
      look_at(p[i].z, q[i].z);
    }
  };
  look_at_lists(a.vertices, b.vertices);
  look_at_lists(a.bends, b.bends);
  return difference / largest;
}

/// Another decision moves points by far more than rounding: all types draw the same.
TEST(TwoBendPaper, AllTypesTakeTheSameDecisions) {
  std::vector<Graph> graphs = {made("random-cubic", 60), made("iterated-truncation", 100),
                               made("cubic-tree", 60), nest(complete(4), 12), nest(cycle(5), 6)};
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Blown blown(made("random-subcubic", 12, seed));
    RandomStream random(seed);
    for (int j = 0; j < 5; ++j) blown.any(random);
    graphs.push_back(blown.graph());
  }
  const double bits[] = {24, 53, 64, 113};
  for (const Graph& graph : graphs) {
    const RealPoints reference = draw_real(graph, RealType::reference);
    for (int type = 0; type + 1 < two_bend_paper::kRealTypes; ++type) {
      const RealPoints points = draw_real(graph, static_cast<RealType>(type));
      EXPECT_EQ(points.offsets, reference.offsets);
      const double allowed = std::max(std::exp2(10 - bits[type]), 0x1p-50);
      EXPECT_LT(difference_of(points, reference), allowed) << points.type;
    }
  }
}

TEST(TwoBendPaper, EveryTypeMissesByItsOwnRounding) {
  const Graph graph = made("random-cubic", 50);
  double previous = 1;
  for (int type = 0; type < two_bend_paper::kRealTypes; ++type) {
    const RealAssessment found = assess(graph, draw_real(graph, static_cast<RealType>(type)));
    EXPECT_FALSE(found.is_broken());
    EXPECT_GT(found.largest_miss, 0);
    EXPECT_LT(found.largest_miss, previous / 100);
    previous = found.largest_miss;
  }
}

/// The build excludes contraction, fast-math and x87 arithmetic; this tells if it does not.
TEST(TwoBendPaper, ArithmeticRoundsOncePerOperation) {
  EXPECT_EQ(two_bend_paper::arithmetic_departures(), "");
}

TEST(TwoBendPaper, RefusesLargerDegrees) {
  EXPECT_THROW(draw_real(complete(5), RealType::reference), InputError);
}

TEST(TwoBendPaper, TheCatalogueRowIsMeasuredAndNeverProved) {
  const Algorithm& row = find_algorithm("two-bend-paper");
  EXPECT_EQ(row.guarantee.claim, Claim::measured);
  for (const Algorithm* proved : proved_algorithms()) EXPECT_NE(proved->name, row.name);
  const Graph graph = made("random-cubic", 30);
  const Drawing drawing = draw(row, graph);
  ASSERT_NE(drawing.real, nullptr);
  EXPECT_EQ(drawing.real->type, "double");
  const Examination found = examine(graph, drawing, row.guarantee);
  EXPECT_TRUE(found.certificate.measured);
  EXPECT_FALSE(found.certificate.valid());
  EXPECT_FALSE(found.certificate.violated());
  ASSERT_NE(found.summary.real, nullptr);
  EXPECT_EQ(found.summary.real->crossings, 0u);
  EXPECT_LT(found.summary.real->largest_miss, 1e-9);
  EXPECT_EQ(found.drawing_hash, drawing_hash(drawing));
  EXPECT_NE(found.drawing_hash, drawing_hash(draw(row, graph, {{"type", 0}})));
  EXPECT_EQ(measure(drawing).total_edge_length, found.summary.total_edge_length);
  EXPECT_THROW(draw(row, graph, {{"type", 5}}), InputError);
  EXPECT_THROW(row.draw(graph, {{"type", -1}}), InputError);
  EXPECT_TRUE(examine(graph, drawing, find_algorithm("two-bend").guarantee).certificate.violated())
      << "points of a real type do not keep the guarantee of a lattice";
}

TEST(TwoBendPaper, TheBoxIsRoundedOutwardsAndThePictureFollowsThePoints) {
  const Graph graph = made("random-cubic", 30);
  const Drawing drawing = draw(find_algorithm("two-bend-paper"), graph);
  const Box box = measure(drawing).box;
  const int unit = drawing.real->unit_exponent;
  double low = 0, high = 0;
  for (const BigPoint& p : drawing.real->vertices) {
    low = std::min(low, coordinate(p.z, unit));
    high = std::max(high, coordinate(p.z, unit));
  }
  EXPECT_LE(static_cast<double>(box.low.z), low);
  EXPECT_GE(static_cast<double>(box.high.z), high);
  EXPECT_EQ(drawing.num_vertices(), 30u);
  const double scale =
      static_cast<double>(drawing.vertex(7).z) / coordinate(drawing.real->vertices[7].z, unit);
  EXPECT_NEAR(std::log2(scale), std::round(std::log2(scale)), 1e-6) << "a power of two";
}

TEST(TwoBendPaperContraction, LeavesNoTriangleOutsideK4) {
  RandomStream random(9);
  for (int i = 0; i < 200; ++i) {
    Blown blown(made("random-subcubic", 2 + random.below(12), static_cast<std::uint64_t>(i)));
    for (int j = 0; j < 6; ++j) blown.any(random);
    const two_bend_paper::ContractedGraph graph = two_bend_paper::contract(blown.graph());
    for (two_bend_paper::Node v = 0; v < graph.num_nodes(); ++v) {
      if (!graph.alive[v] || is_in_k4(graph, v)) continue;
      const two_bend_paper::Star& star = graph.stars[v];
      for (const HalfEdge a : star) {
        EXPECT_TRUE(graph.alive[a.to]);
        for (const HalfEdge b : star) {
          EXPECT_TRUE(a.edge == b.edge || a.to != b.to) << "a double edge";
          for (const HalfEdge c : graph.stars[a.to]) {
            EXPECT_TRUE(c.to != b.to || a.to == b.to) << "a triangle";
          }
        }
      }
    }
  }
}

FigureKind only_figure(const Graph& graph) {
  const two_bend_paper::ContractedGraph contracted = two_bend_paper::contract(graph);
  EXPECT_EQ(contracted.contractions.size(), 1u);
  return contracted.contractions.at(0).figure;
}

TEST(TwoBendPaperContraction, KnowsItsFigures) {
  EXPECT_EQ(only_figure(complete(3)), FigureKind::triangle);
  EXPECT_EQ(only_figure(Graph(4, {{0, 1}, {0, 2}, {1, 2}, {1, 3}, {2, 3}})), FigureKind::diamond);
  EXPECT_EQ(only_figure(Graph(5, {{0, 1}, {0, 2}, {1, 3}, {1, 4}, {2, 3}, {2, 4}, {3, 4}})),
            FigureKind::fat_leaf);
  EXPECT_TRUE(two_bend_paper::contract(complete(4)).contractions.empty());
}

TEST(TwoBendPaperGrowth, AddsAShortestCycle) {
  const two_bend_paper::ContractedGraph contracted = two_bend_paper::contract(petersen());
  std::vector<two_bend_paper::Node> all(10);
  for (two_bend_paper::Node v = 0; v < 10; ++v) all[v] = v;
  ShortestCycleSearch search(10);
  const auto length_without = [&](const std::vector<bool>& inside) {
    return two_bend_paper::shortest_cycle(contracted, all, inside, search).size();
  };
  EXPECT_EQ(length_without(std::vector<bool>(10)), 5u);
  std::vector<bool> no_five = std::vector<bool>(10);
  no_five[0] = no_five[1] = true;
  EXPECT_GE(length_without(no_five), 5u);
  EXPECT_EQ(length_without(std::vector<bool>(10, true)), 0u);
}

TEST(TwoBendPaperGrowth, EveryNodeIsAddedOnceAndRaysAreThere) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const two_bend_paper::ContractedGraph graph =
        two_bend_paper::contract(made("random-subcubic", 40, seed));
    std::vector<int> times(graph.num_nodes());
    std::vector<bool> ray(graph.num_nodes());
    for (const two_bend_paper::Component& component : two_bend_paper::grow(graph)) {
      for (const two_bend_paper::Step& step : component.steps) {
        for (const HalfEdge below : step.below) EXPECT_TRUE(ray[below.to]);
        for (const two_bend_paper::CycleVertex& vertex : step.cycle) {
          ++times[vertex.node];
          EXPECT_TRUE(!vertex.is_below || ray[vertex.third->to]);
          ray[vertex.node] = vertex.has_ray();
        }
        if (step.kind == two_bend_paper::StepKind::cycle) continue;
        ++times[step.node];
        ray[step.node] = step.has_ray;
      }
      if (component.k4) {
        for (const two_bend_paper::Node node : *component.k4) ++times[node];
      }
    }
    for (two_bend_paper::Node v = 0; v < graph.num_nodes(); ++v) {
      EXPECT_EQ(times[v], graph.alive[v] ? 1 : 0);
    }
  }
}

TEST(TwoBendPaperPosition, QualityIsZeroOnAndNearLines) {
  using two_bend_paper::Foot;
  using two_bend_paper::position_quality;
  const std::vector<Foot> feet = {{0, 0}, {2, 2}, {5, 0}};
  EXPECT_EQ(position_quality({1, 1}, feet), 0);
  EXPECT_EQ(position_quality({2, 2}, feet), 0);
  EXPECT_EQ(position_quality({7, 0}, feet), 0);
  EXPECT_EQ(position_quality({3, 3 + 0x1p-45}, feet), 0);
  EXPECT_GT(position_quality({2, 1}, feet), 1);
  EXPECT_TRUE(std::isinf(position_quality({2, 1}, {{0, 0}})));
}

}  // namespace
}  // namespace ar3d::testing
