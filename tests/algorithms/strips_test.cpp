// The public functions of `compact` and `compact-120`: corner cases, refusals, options, counters,
// fallback, guarantee.
#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/strips_support.h"
#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/error.h"
#include "ar3d/generators/catalog.h"

namespace ar3d::testing {
namespace {

Graph regular_graph(const StripAlgorithm& algorithm, std::uint64_t n, std::uint64_t seed = 2) {
  return generate(find_family(algorithm.regular), n, seed);
}

TEST_P(Strips, DrawCornerCasesAtEveryEffort) {
  const Graph point(1, {});
  std::vector<Graph> graphs = {Graph(),
                               point,
                               Graph(2, {}),
                               Graph(500, {}),
                               complete(2),
                               Graph(2, {{1, 0}}),
                               disjoint_union({point, complete(2), point}),
                               cycle(3),
                               path(300),
                               generate(find_family(algorithm().small_union), 300, 1)};
  graphs.insert(graphs.end(), algorithm().extremes.begin(), algorithm().extremes.end());
  for (const Graph& graph : graphs) {
    EXPECT_EQ(strip_fault(algorithm(), graph), "") << graph.num_vertices() << " vertices";
  }
}

TEST_P(Strips, TellWhatTheyDid) {
  const Graph graph = regular_graph(algorithm(), 1000);
  const Drawing narrow = algorithm().draw(graph, 1);
  EXPECT_EQ(counter_of(narrow, "zones"), 0);
  EXPECT_GT(counter_of(narrow, "ejections"), 0);
  EXPECT_GE(counter_of(narrow, "trials"), 1000);
  const Drawing zones = algorithm().draw(graph, 0);
  EXPECT_EQ(counter_of(zones, "zones"), 1);
  EXPECT_EQ(counter_of(zones, "ejections"), 0);
  EXPECT_GT(counter_of(zones, "columns"), 10 * counter_of(narrow, "columns"));
}

TEST_P(Strips, FallBackOnTheZonesWhenNoNarrowStripCanBeFilled) {
  for (const std::string& family :
       {std::string("path"), algorithm().regular, algorithm().small_union}) {
    const Graph graph = generate(find_family(family), 500, 2);
    const Drawing drawing = algorithm().draw_from(graph, algorithm().too_tight);
    EXPECT_EQ(counter_of(drawing, "zones"), 1) << family;
    EXPECT_EQ(counter_of(drawing, "widenings"), 8) << family;
    EXPECT_LE(counter_of(drawing, "ejections"), 8 * (250 + 20)) << family;
    EXPECT_EQ(strip_fault(algorithm(), graph, drawing), "") << family;
  }
}

TEST_P(Strips, BeyondTheTheoremsBoxAreNotTried) {
  const Graph graph = path(500);
  const Drawing drawing = algorithm().draw_from(graph, strips::Tightness{.extra_columns = 100000});
  EXPECT_EQ(counter_of(drawing, "zones"), 1);
  EXPECT_EQ(counter_of(drawing, "widenings"), 0);
  EXPECT_EQ(strip_fault(algorithm(), graph, drawing), "");
}

TEST_P(Strips, VolumeGrowsWithPowerOneAndAHalf) {
  // The largest is 1000 times the smallest: a volume of order n^2 would miss by a factor of 30.
  for (const double n : {1e2, 1e3, 1e4, 1e5}) {
    const Graph graph = regular_graph(algorithm(), static_cast<std::uint64_t>(n), 1);
    const auto [x, y, z] = bounding_box(algorithm().draw(graph, 1)).extents();
    EXPECT_LT(static_cast<double>(x * y * z), algorithm().volume_per_n_1_5 * std::pow(n, 1.5)) << n;
  }
}

TEST_P(Strips, MoreEffortMakesRandomGraphsSmaller) {
  const Graph graph = regular_graph(algorithm(), 3000, 1);
  const auto volume = [&](int effort) {
    const auto [x, y, z] = bounding_box(algorithm().draw(graph, effort)).extents();
    return x * y * z;
  };
  EXPECT_LT(volume(1), volume(0));
  EXPECT_LT(volume(2), volume(1));
}

TEST_P(Strips, DrawTheSameEverywhere) {
  const Graph graph = regular_graph(algorithm(), 300);
  for (const int effort : {0, 1}) {
    EXPECT_EQ(drawing_hash(algorithm().draw(graph, effort)),
              algorithm().hashes.at(static_cast<std::size_t>(effort)));
  }
}

INSTANTIATE_TEST_SUITE_P(Of, Strips, kBothStripAlgorithms, kStripSuite);

TEST(Compact120, MovesNoComponentOfARandomGraph) {
  const Graph graph = regular_graph(compact_120_strips(), 1000);
  EXPECT_EQ(counter_of(compact_120::draw(graph), "moved_components"), 0);
}

TEST(Compact120, VerticesLieInOnePlane) {
  const Graph graph = regular_graph(compact_120_strips(), 100);
  for (const int effort : kStripEfforts) {
    const Drawing drawing = compact_120::draw(graph, {.effort = effort});
    for (Vertex v = 0; v < graph.num_vertices(); ++v) {
      const Point p = drawing.vertex(v);
      EXPECT_EQ(5 * p.x + 5 * p.y, 3 * p.z);
    }
  }
}

}  // namespace
}  // namespace ar3d::testing
