// The public function: corner cases, refusals, efforts, counters, the last resort.

#include "ar3d/algorithms/two_bend_109/two_bend_109.h"

#include "algorithms/two_bend_109_support.h"
#include "ar3d/algorithms/two_bend_109/layout.h"
#include "ar3d/generators/catalog.h"
#include "support/graphs.h"
#include "support/names.h"
#include "support/problem.h"

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

TEST(TwoBend109, RefusesJittersThatAreNoPowerOfTwo) {
  for (const std::int64_t jitter : {std::int64_t{0}, std::int64_t{12}, std::int64_t{1} << 31}) {
    EXPECT_THROW(two_bend_109::draw(path(3), {.first_jitter = jitter}), InputError);
  }
}

TEST(TwoBend109, CoordinatesThatMayPassTheRangeAreRefusedWithTheVertexNamed) {
  const Graph graph = generate(find_family("random-4-regular"), 1000, 1);
  const auto order = ordered(graph);
  const auto arrangement = two_bend_109::arrange(order);
  const std::string begin = "two-bend-109: a coordinate of vertex ";
  const std::string end = " may pass 2\\^60, the graph is too large";
  for (const int bits : {44, 55, 56}) {
    const two_bend_109::LayoutScale scale{std::int64_t{1} << bits};
    EXPECT_THAT(problem([&] { two_bend_109::lay_out(order, order.parts, arrangement, scale); }),
                MatchesRegex(begin + "[0-9]+" + end));
  }
  // Behind 70,000 single vertices, so that the names are not those of the component.
  const Graph behind =
      disjoint_union({Graph(70000, {}), generate(find_family("ladder"), 60000, 1)});
  EXPECT_THAT(problem([&] { two_bend_109::draw(behind, {.first_jitter = std::int64_t{1} << 30}); }),
              MatchesRegex(begin + "([7-9]|1[0-3])[0-9]{4}" + end));
}

// Recorded with g++ 12.2; the same with every compiler and on every machine.
TEST(TwoBend109, DrawsTheSameEverywhere) {
  const auto hash = [](const char* family, std::uint64_t n, int effort) {
    return drawing_hash(
        two_bend_109::draw(generate(find_family(family), n, 2), {.effort = effort}));
  };
  EXPECT_EQ(hash("random-4-regular", 300, 0), "87da1a4a62f1c53fb368fc7766031015");
  EXPECT_EQ(hash("random-4-regular", 300, 1), "f836feca698e5475f65ea3b01daf4967");
  EXPECT_EQ(hash("random-4-regular", 20000, 1), "f425bb150853187fb5b6f63cf33e37cf");
  EXPECT_EQ(hash("torus", 10000, 1), "dbaaed7fd138b822b6103da1e956ddcf");
  EXPECT_EQ(hash("percolated-square-grid", 10000, 1), "3135708fe0ec431e2dd7922edb5f3a40");
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
