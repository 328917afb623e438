// The public function: corner cases, refusals, options, counters, fallback, guarantee.

#include "ar3d/algorithms/compact/compact.h"

#include <gtest/gtest.h>

#include "algorithms/compact_support.h"
#include "ar3d/algorithms/catalog.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/model/error.h"
#include "support/graphs.h"

namespace ar3d {
namespace {

using testing::compact_fault;
using testing::compact_modes;
using testing::complete;
using testing::count_of;

TEST(Compact, DrawsCornerCasesInEveryMode) {
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
      Graph(5, {{2, 0}, {2, 1}, {2, 3}, {2, 4}}),
      complete(5),
      testing::octahedron(),
      testing::path(300),
      testing::disjoint_union(std::vector<Graph>(60, complete(5))),
  };
  for (const Graph& graph : graphs) {
    for (const compact::Options& options : compact_modes()) {
      EXPECT_EQ(compact_fault(graph, options), "")
          << graph.num_vertices() << " vertices, effort " << options.effort;
    }
  }
}

TEST(Compact, RefusesDegreeFiveAndUnknownEfforts) {
  EXPECT_THROW(compact::draw(complete(6)), InputError);
  EXPECT_THROW(compact::draw(testing::path(3), {.effort = 3}), InputError);
  EXPECT_THROW(compact::draw(testing::path(3), {.effort = -1}), InputError);
}

TEST(Compact, SameGraphSameDrawing) {
  const Graph graph = generate(find_family("random-4-regular"), 300, 2);
  for (const compact::Options& options : compact_modes()) {
    EXPECT_EQ(drawing_hash(compact::draw(graph, options)),
              drawing_hash(compact::draw(graph, options)));
    EXPECT_EQ(compact::draw(graph, options).counters, compact::draw(graph, options).counters);
  }
}

// Recorded with g++ 12.2; the same with every compiler and on every machine.
TEST(Compact, DrawsTheSameEverywhere) {
  const Graph graph = generate(find_family("random-4-regular"), 300, 2);
  EXPECT_EQ(drawing_hash(compact::draw(graph)), "aabf22af98398fd3928258bf767b90b6");
  EXPECT_EQ(drawing_hash(compact::draw(graph, {.effort = 0})), "d813043e7bd7b2317bffc5277acc45af");
}

TEST(Compact, TellsWhatItDid) {
  const Graph graph = generate(find_family("random-4-regular"), 1000, 2);
  const Drawing narrow = compact::draw(graph);
  EXPECT_EQ(count_of(narrow, "zones"), 0);
  EXPECT_GT(count_of(narrow, "ejections"), 0);
  EXPECT_GE(count_of(narrow, "trials"), 1000);
  const Drawing zones = compact::draw(graph, {.effort = 0});
  EXPECT_EQ(count_of(zones, "zones"), 1);
  EXPECT_EQ(count_of(zones, "ejections"), 0);
  EXPECT_GT(count_of(zones, "columns"), 10 * count_of(narrow, "columns"));
}

TEST(Compact, FallsBackOnTheZonesWhenNoNarrowStripCanBeFilled) {
  for (const char* family : {"path", "random-4-regular", "union-k5"}) {
    const Graph graph = generate(find_family(family), 500, 2);
    const Drawing drawing = compact::draw_from(graph, compact::Tightness{.cells = 25, .rows = 60});
    EXPECT_EQ(count_of(drawing, "zones"), 1) << family;
    EXPECT_EQ(count_of(drawing, "widenings"), 8) << family;
    EXPECT_LE(count_of(drawing, "ejections"), 8 * (250 + 20)) << family;
    EXPECT_EQ(compact_fault(graph, drawing), "") << family;
  }
}

TEST(Compact, StripsBeyondTheTheoremsBoxAreNotTried) {
  const Graph graph = testing::path(500);
  const Drawing drawing = compact::draw_from(graph, compact::Tightness{.extra_columns = 100000});
  EXPECT_EQ(count_of(drawing, "zones"), 1);
  EXPECT_EQ(count_of(drawing, "widenings"), 0);
  EXPECT_EQ(compact_fault(graph, drawing), "");
}

TEST(Compact, VolumeGrowsWithPowerOneAndAHalf) {
  // The largest is 1000 times the smallest: a volume of order n^2 would miss by a factor of 30.
  for (const std::uint64_t n : {100u, 1000u, 10000u, 100000u}) {
    const Graph graph = generate(find_family("random-4-regular"), n, 1);
    const auto [x, y, z] = bounding_box(compact::draw(graph)).extents();
    for (const std::int64_t side : {x, y, z}) {
      EXPECT_LT(side * side, 20 * 20 * static_cast<std::int64_t>(n)) << n;
    }
  }
}

TEST(Compact, MoreEffortMakesRandomGraphsSmaller) {
  const Graph graph = generate(find_family("random-4-regular"), 3000, 1);
  const auto volume = [&](int effort) {
    const auto [x, y, z] = bounding_box(compact::draw(graph, {.effort = effort})).extents();
    return x * y * z;
  };
  EXPECT_LT(volume(1), volume(0));
  EXPECT_LT(volume(2), volume(1));
}

TEST(Compact, IsInTheCatalogue) {
  const Algorithm& row = find_algorithm("compact");
  const Drawing drawing = draw(row, complete(5), {{"effort", 2}});
  EXPECT_EQ(drawing.algorithm(), "compact");
  EXPECT_TRUE(certify(complete(5), drawing, row.guarantee).valid());
  EXPECT_THROW(draw(row, complete(6)), InputError);
  EXPECT_THROW(draw(row, complete(5), {{"effort", 3}}), InputError);
}

}  // namespace
}  // namespace ar3d
