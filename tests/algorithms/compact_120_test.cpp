// The public function: corner cases, refusals, options, counters, fallback, guarantee.

#include "ar3d/algorithms/compact_120/compact_120.h"

#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/compact_120_support.h"
#include "ar3d/algorithms/catalog.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/model/error.h"
#include "support/graphs.h"

namespace ar3d {
namespace {

using testing::compact_120_fault;
using testing::compact_120_modes;
using testing::complete;
using testing::count_120;

TEST(Compact120, DrawsCornerCasesInEveryMode) {
  const Graph point(1, {});
  const std::vector<Graph> graphs = {
      Graph(),
      point,
      Graph(2, {}),
      Graph(500, {}),
      complete(2),
      Graph(2, {{1, 0}}),
      testing::disjoint_union({point, complete(2), point}),
      testing::cycle(3),
      Graph(4, {{2, 0}, {2, 1}, {2, 3}}),
      complete(4),
      testing::petersen(),
      testing::path(300),
      testing::disjoint_union(std::vector<Graph>(60, complete(4))),
  };
  for (const Graph& graph : graphs) {
    for (const compact_120::Options& options : compact_120_modes()) {
      EXPECT_EQ(compact_120_fault(graph, options), "")
          << graph.num_vertices() << " vertices, effort " << options.effort;
    }
  }
}

TEST(Compact120, RefusesDegreeFourAndUnknownEfforts) {
  EXPECT_THROW(compact_120::draw(complete(5)), InputError);
  EXPECT_THROW(compact_120::draw(testing::path(3), {.effort = 3}), InputError);
  EXPECT_THROW(compact_120::draw(testing::path(3), {.effort = -1}), InputError);
}

TEST(Compact120, SameGraphSameDrawing) {
  const Graph graph = generate(find_family("random-cubic"), 300, 2);
  for (const compact_120::Options& options : compact_120_modes()) {
    const Drawing one = compact_120::draw(graph, options);
    const Drawing two = compact_120::draw(graph, options);
    EXPECT_EQ(drawing_hash(one), drawing_hash(two));
    EXPECT_EQ(one.counters, two.counters);
  }
}

// Recorded with g++ 12.2; the same with every compiler and on every machine.
TEST(Compact120, DrawsTheSameEverywhere) {
  const Graph graph = generate(find_family("random-cubic"), 300, 2);
  EXPECT_EQ(drawing_hash(compact_120::draw(graph)), "710a4ec6aaa310ae2e5a9453063e3974");
  EXPECT_EQ(drawing_hash(compact_120::draw(graph, {.effort = 0})),
            "1a12a894c58eb1e68964dcc9748b9916");
}

TEST(Compact120, VerticesLieInOnePlane) {
  const Graph graph = generate(find_family("random-cubic"), 100, 2);
  for (const compact_120::Options& options : compact_120_modes()) {
    const Drawing drawing = compact_120::draw(graph, options);
    for (Vertex v = 0; v < graph.num_vertices(); ++v) {
      const Point p = drawing.vertex(v);
      EXPECT_EQ(5 * p.x + 5 * p.y, 3 * p.z);
    }
  }
}

TEST(Compact120, TellsWhatItDid) {
  const Graph graph = generate(find_family("random-cubic"), 1000, 2);
  const Drawing narrow = compact_120::draw(graph);
  EXPECT_EQ(count_120(narrow, "zones"), 0);
  EXPECT_EQ(count_120(narrow, "moved_components"), 0);
  EXPECT_GT(count_120(narrow, "ejections"), 0);
  EXPECT_GE(count_120(narrow, "trials"), 1000);
  const Drawing zones = compact_120::draw(graph, {.effort = 0});
  EXPECT_EQ(count_120(zones, "zones"), 1);
  EXPECT_EQ(count_120(zones, "ejections"), 0);
  EXPECT_GT(count_120(zones, "columns"), 10 * count_120(narrow, "columns"));
}

TEST(Compact120, FallsBackOnTheZonesWhenNoNarrowStripCanBeFilled) {
  for (const char* family : {"path", "random-cubic", "union-k4"}) {
    const Graph graph = generate(find_family(family), 500, 2);
    const Drawing drawing = compact_120::draw_from(
        graph, compact_120::Tightness{.cells = 10, .rows = 60, .extra_columns = 0});
    EXPECT_EQ(count_120(drawing, "zones"), 1) << family;
    EXPECT_EQ(count_120(drawing, "widenings"), 8) << family;
    EXPECT_LE(count_120(drawing, "ejections"), 8 * (250 + 20)) << family;
    EXPECT_EQ(compact_120_fault(graph, drawing), "") << family;
  }
}

TEST(Compact120, StripsBeyondTheTheoremsBoxAreNotTried) {
  const Graph graph = testing::path(500);
  const Drawing drawing =
      compact_120::draw_from(graph, compact_120::Tightness{.extra_columns = 100000});
  EXPECT_EQ(count_120(drawing, "zones"), 1);
  EXPECT_EQ(count_120(drawing, "widenings"), 0);
  EXPECT_EQ(compact_120_fault(graph, drawing), "");
}

TEST(Compact120, VolumeGrowsWithPowerOneAndAHalf) {
  // The largest is 1000 times the smallest: a volume of order n^2 would miss by a factor of 30.
  for (const std::uint64_t n : {100u, 1000u, 10000u, 100000u}) {
    const Graph graph = generate(find_family("random-cubic"), n, 1);
    const auto [x, y, z] = bounding_box(compact_120::draw(graph)).extents();
    EXPECT_LT(x * y * z / static_cast<std::int64_t>(n),
              3000 * static_cast<std::int64_t>(std::sqrt(static_cast<double>(n))))
        << n;
  }
}

TEST(Compact120, MoreEffortMakesRandomGraphsSmaller) {
  const Graph graph = generate(find_family("random-cubic"), 3000, 1);
  const auto volume = [&](int effort) {
    const auto [x, y, z] = bounding_box(compact_120::draw(graph, {.effort = effort})).extents();
    return x * y * z;
  };
  EXPECT_LT(volume(1), volume(0));
  EXPECT_LT(volume(2), volume(1));
}

TEST(Compact120, IsInTheCatalogue) {
  const Algorithm& row = find_algorithm("compact-120");
  const Drawing drawing = draw(row, complete(4), {{"effort", 2}});
  EXPECT_EQ(drawing.algorithm(), "compact-120");
  EXPECT_TRUE(certify(complete(4), drawing, row.guarantee).valid());
  EXPECT_THROW(draw(row, complete(5)), InputError);
  EXPECT_THROW(draw(row, complete(4), {{"effort", 3}}), InputError);
}

}  // namespace
}  // namespace ar3d
