#include "ar3d/verify/metrics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "ar3d/verify/closest_pair.h"
#include "verify/random_drafts.h"

namespace ar3d {
namespace {

using testing::Draft;
using ::testing::ElementsAre;

Guarantee with_bound(std::int64_t per_vertex) {
  Guarantee guarantee = testing::no_promise();
  const AxisBound bound{per_vertex, 1, 2, 0};
  guarantee.bound = {"test", "test", {bound, bound, bound}};
  return guarantee;
}

TEST(Metrics, OfADrawingByHand) {
  Draft draft;
  draft.vertices = {{0, 0, 0}, {4, 4, 0}, {10, 0, 0}};
  draft.edges = {{{0, 1}, {{2, 2, 2}}}, {{1, 2}, {}}};
  const Metrics m = measure(draft.graph(), draft.drawing(), with_bound(5));
  EXPECT_THAT(m.extents, ElementsAre(10, 4, 2));
  EXPECT_DOUBLE_EQ(m.log2_volume, std::log2(11) + std::log2(5) + std::log2(3));
  EXPECT_DOUBLE_EQ(m.volume_per_n3, 80.0 / 27.0);
  EXPECT_THAT(m.bend_histogram, ElementsAre(1, 1));
  EXPECT_DOUBLE_EQ(m.total_edge_length, 4 * std::sqrt(3.0) + std::sqrt(52.0));
  EXPECT_DOUBLE_EQ(m.longest_edge_length, std::sqrt(52.0));
  EXPECT_DOUBLE_EQ(m.smallest_vertex_distance, std::sqrt(32.0));
  EXPECT_THAT(m.theorem_bound, ElementsAre(15.0, 15.0, 15.0));
  EXPECT_DOUBLE_EQ(m.slack[1], 1 - 4 / 15.0);
}

TEST(Metrics, LengthsAreThoseOfTheLattice) {
  Draft draft;
  draft.lattice = kTallLattice;
  draft.vertices = {{0, 0, 0}, {0, 0, 3}, {2, 0, 0}};
  draft.edges = {{{0, 1}, {}}};
  const Metrics m = measure(draft.graph(), draft.drawing(), with_bound(5));
  EXPECT_DOUBLE_EQ(m.total_edge_length, std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(m.smallest_vertex_distance, std::sqrt(3.0));  // less than 2
}

TEST(Metrics, WhatDoesNotExistIsMissing) {
  const Metrics empty = measure(Graph(), Draft{}.drawing(), with_bound(5));
  EXPECT_TRUE(std::isnan(empty.smallest_vertex_distance));
  EXPECT_TRUE(std::isnan(empty.slack[0]));
  EXPECT_TRUE(std::isnan(empty.volume_per_n3));
  EXPECT_EQ(empty.log2_volume, 0);
  const Metrics unbounded = measure(Graph(), Draft{}.drawing(), testing::no_promise());
  EXPECT_TRUE(std::isnan(unbounded.theorem_bound[2]));
}

TEST(Metrics, CatalogueIsComplete) {
  std::set<std::string> names;
  Metrics m;
  m.bend_histogram = {10, 11, 12, 13, 14, 15, 16, 17, 18};
  for (const Metric& metric : metrics()) {
    EXPECT_TRUE(names.insert(metric.name).second) << metric.name;
    EXPECT_FALSE(metric.unit.empty() || metric.definition.empty()) << metric.name;
    const double value = metric.value(m);
    if (metric.name == "bends_0") {
      EXPECT_EQ(value, 10);
    }
    if (metric.name == "bends_6") {
      EXPECT_EQ(value, 16);
    }
    if (metric.name == "bends_7") {
      EXPECT_EQ(value, 35);
    }
  }
}

double squared_distance(const Drawing& drawing, Vertex u, Vertex v) {
  const double length =
      approximate_length(drawing.lattice(), drawing.vertex(u) - drawing.vertex(v));
  return length * length;
}

void expect_closest(const Draft& draft) {
  const Drawing drawing = draft.drawing();
  const auto pair = verify::closest_pair(drawing);
  ASSERT_TRUE(pair.has_value());
  ASSERT_NE(pair->u, pair->v);
  double smallest = INFINITY;
  for (Vertex v = 0; v < drawing.num_vertices(); ++v) {
    for (Vertex u = 0; u < v; ++u) smallest = std::min(smallest, squared_distance(drawing, u, v));
  }
  ASSERT_NEAR(squared_distance(drawing, pair->u, pair->v), smallest, smallest * 1e-9);
}

TEST(ClosestPair, IsTheBestOfAllPairs) {
  RandomStream random(7);
  const Lattice skew{{{{5, 2, -1}, {2, 4, 1}, {-1, 1, 3}}}, 2};
  for (const Lattice& lattice : {kCubeLattice, kTallLattice, skew}) {
    for (int i = 0; i < 300; ++i) {
      Draft draft;
      draft.lattice = lattice;
      const std::uint32_t n = 2 + random.below(60);
      const std::uint32_t side = 1 + random.below(i % 3 == 0 ? 10 : 1000);
      const std::uint32_t height = i % 2 == 0 ? 1 : side;
      for (std::uint32_t v = 0; v < n; ++v) {
        draft.vertices.push_back({std::int64_t{random.below(side)} - side / 2, random.below(side),
                                  random.below(height)});
      }
      ASSERT_NO_FATAL_FAILURE(expect_closest(draft)) << i;
      ASSERT_NO_FATAL_FAILURE(expect_closest(testing::RandomDrafts::far_away(draft))) << i;
    }
  }
}

TEST(ClosestPair, ComparesExactlyWhereDoublesCannot) {
  const std::int64_t far = kMaxCoordinate;
  Draft draft;  // the pairs' distances differ by 1 in 2^61
  draft.vertices = {{-far, 0, 0}, {0, 0, 0}, {far - 1, 0, 0}};
  auto pair = verify::closest_pair(draft.drawing());
  EXPECT_EQ(pair->u + pair->v, 3u);
  draft.vertices = {{1 - far, 0, 0}, {0, 0, 0}, {far, 0, 0}};
  pair = verify::closest_pair(draft.drawing());
  EXPECT_EQ(pair->u + pair->v, 1u);
}

}  // namespace
}  // namespace ar3d
