// The public function: corner cases, refusals, efforts, counters, the last resort.

#include "ar3d/algorithms/two_bend_109/two_bend_109.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/two_bend_109_support.h"
#include "ar3d/algorithms/two_bend_109/layout.h"
#include "ar3d/base/error.h"
#include "ar3d/generators/catalog.h"
#include "support/graphs.h"
#include "support/names.h"

namespace ar3d::testing {
namespace {

TEST(TwoBend109, DrawsCornerCasesAtBothEfforts) {
  const Graph point(1, {});
  const std::vector<Graph> graphs = {
      Graph(),
      point,
      Graph(300, {}),
      complete(2),
      Graph(5, {{2, 0}, {2, 1}, {2, 3}, {4, 2}}),
      cycle(3),
      cycle(4),
      cycle(300),
      path(300),
      complete(4),
      complete(5),
      octahedron(),
      petersen(),
      disjoint_union({point, complete(5), point, complete(2), complete(5)}),
      disjoint_union(std::vector<Graph>(40, complete(4))),
  };
  for (const Graph& graph : graphs) {
    for (const int effort : {0, 1}) {
      EXPECT_EQ(two_bend_109_fault(graph, {.effort = effort}), "")
          << graph.num_vertices() << " vertices, effort " << effort;
    }
  }
}

TEST(TwoBend109, DrawsK5AsOneBody) {
  const Drawing drawing = two_bend_109::draw(complete(5));
  EXPECT_EQ(count_109(drawing, "bodies"), 1);
  EXPECT_EQ(count_109(drawing, "slots"), 0);
  EXPECT_EQ(bounding_box(drawing).extents(), (std::array<std::int64_t, 3>{28590, 15755, 41668}));
}

TEST(TwoBend109, RefusesDegreeFiveAndUnknownEfforts) {
  EXPECT_THROW(two_bend_109::draw(complete(6)), InputError);
  EXPECT_THROW(two_bend_109::draw(path(3), {.effort = 2}), InputError);
  EXPECT_THROW(two_bend_109::draw(path(3), {.effort = -1}), InputError);
  for (const std::int64_t jitter : {std::int64_t{0}, std::int64_t{12}, std::int64_t{1} << 31}) {
    EXPECT_THROW(two_bend_109::draw(path(3), {.first_jitter = jitter}), InputError);
  }
}

TEST(TwoBend109, CoordinatesThatMayPassTheRangeAreRefusedWithTheVertexNamed) {
  const Graph graph = generate(find_family("random-4-regular"), 1000, 1);
  const auto parts = two_bend_109::find_partition(graph);
  const auto arrangement = two_bend_109::arrange(graph, parts);
  for (const int bits : {44, 55, 56}) {
    try {
      two_bend_109::lay_out(graph, parts, arrangement, {std::int64_t{1} << bits});
      FAIL() << "a square of 2^" << bits << " points per side is too large for 1000 vertices";
    } catch (const InputError& e) {
      EXPECT_THAT(e.what(), ::testing::MatchesRegex(
                                "two-bend-109: a coordinate of vertex [0-9]+ may pass 2\\^60, the "
                                "graph is too large"));
    }
  }
}

// Behind 70,000 single vertices, so that the names are not those of the component.
TEST(TwoBend109, DrawRefusesWithTheVertexOfTheWholeGraphNamed) {
  const Graph long_one = generate(find_family("ladder"), 60000, 1);
  const Graph graph = disjoint_union({Graph(70000, {}), long_one});
  try {
    two_bend_109::draw(graph, {.first_jitter = std::int64_t{1} << 30});
    FAIL() << "its heights pass 2^60";
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), ::testing::MatchesRegex(
                              "two-bend-109: a coordinate of vertex ([7-9]|1[0-3])[0-9]{4} may "
                              "pass 2\\^60, the graph is too large"));
  }
}

TEST(TwoBend109, SameGraphSameDrawing) {
  const Graph graph = generate(find_family("random-4-regular"), 300, 2);
  const Drawing one = two_bend_109::draw(graph);
  const Drawing two = two_bend_109::draw(graph);
  EXPECT_EQ(drawing_hash(one), drawing_hash(two));
  EXPECT_EQ(one.counters, two.counters);
}

TEST(TwoBend109, TellsWhatItDid) {
  const Graph graph = generate(find_family("random-4-regular"), 1000, 2);
  const Drawing drawing = two_bend_109::draw(graph);
  EXPECT_EQ(count_109(drawing, "components"), 1);
  EXPECT_GT(count_109(drawing, "cycles"), 0);
  EXPECT_GT(count_109(drawing, "singles"), 500);
  EXPECT_EQ(count_109(drawing, "jitter"), 16);
  EXPECT_GE(count_109(drawing, "tried"), 900);
  const auto extents = bounding_box(drawing).extents();
  for (std::size_t axis = 0; axis < 3; ++axis) {  // two ends may be up to 15 away from the squares'
    EXPECT_LE(drawing.instance_bound.value()[axis] - extents[axis], axis == 2 ? 0 : 30);
  }
  const Drawing large = two_bend_109::draw(graph, {.effort = 0});
  EXPECT_EQ(count_109(large, "jitter"), two_bend_109::LayoutScale::always_enough(1000).jitter);
}

// One point for every vertex is not enough, and doubling the square helps.
TEST(TwoBend109, WidensTheSquareWhenAVertexFindsNoPoint) {
  std::size_t widened = 0;
  for (const Graph& graph : geng("-c -D4 7")) {
    const Drawing drawing = two_bend_109::draw(graph, {.first_jitter = 1});
    if (count_109(drawing, "jitter") > 1) ++widened;
    ASSERT_EQ(two_bend_109_fault(graph, drawing), "");
  }
  EXPECT_GT(widened, 0u);
}

TEST(TwoBend109, KeepsItsBoxFarBelowTheTheorems) {
  for (const std::uint64_t n : {100u, 1000u, 4000u}) {
    const Graph graph = generate(find_family("random-4-regular"), n, 1);
    const auto extents = bounding_box(two_bend_109::draw(graph)).extents();
    const auto size = static_cast<std::int64_t>(n);
    EXPECT_LE(extents[0], 100 * size * size);
    EXPECT_LE(extents[1], 20 * size);
    EXPECT_LE(extents[2], 50 * size * size * size);
  }
}

class TwoBend109Families : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(TwoBend109Families, AreCertifiedAtBothEfforts) {
  for (const Family& family : families()) {
    for (const int shuffle : {0, 1}) {
      const Graph graph = generate(family, GetParam(), 7, {{"shuffle", shuffle}});
      for (const int effort : {0, 1}) {
        EXPECT_EQ(two_bend_109_fault(graph, {.effort = effort}), "")
            << family.name << " shuffle " << shuffle << " effort " << effort;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, TwoBend109Families, ::testing::Values(5, 12, 40, 150, 600),
                         named("n"));

TEST(TwoBend109Random, RegularGraphsAreCertifiedAtBothEfforts) {
  for (const std::uint64_t n : {20u, 50u, 200u, 1000u, 4000u, 10000u}) {
    for (std::uint64_t seed = 1; seed <= (n <= 200 ? 20 : n <= 4000 ? 2 : 1); ++seed) {
      const Graph graph = generate(find_family("random-4-regular"), n, seed);
      for (const int effort : {0, 1}) {
        EXPECT_EQ(two_bend_109_fault(graph, {.effort = effort}), "")
            << "n " << n << " seed " << seed << " effort " << effort;
      }
    }
  }
}

}  // namespace
}  // namespace ar3d::testing
