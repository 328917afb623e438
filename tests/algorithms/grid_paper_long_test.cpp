// Algorithm `grid-paper` on larger sets and sizes, certified, and its orders of growth.
#include <fmt/format.h>

#include <cmath>

#include "algorithms/grid_paper_support.h"
#include "ar3d/generators/families.h"

namespace ar3d::testing {
namespace {

TEST(GridPaperLong, ElevenAndTwelveVerticesWithRandomCyclesToo) {
  std::size_t drawn = 0;
  for (const int n : {11, 12}) {
    for (const Graph& graph : geng(fmt::format("-D3 {}", n))) {
      ASSERT_EQ(grid_paper_fault(graph), "");
      ASSERT_EQ(grid_paper_fault(graph, {Spread::least, true}, {.random_cycles = drawn}), "");
      ++drawn;
    }
  }
  EXPECT_EQ(drawn, 10946u + 36327u);
}

TEST(GridPaperLong, ConnectedCubicGraphsOfSixteenAndEighteenVertices) {
  std::size_t drawn = 0;
  for (const int n : {16, 18}) {
    for (const Graph& graph : geng(fmt::format("-c -d3 -D3 {}", n))) {
      ASSERT_EQ(grid_paper_fault(graph, {}, {.random_cycles = drawn}), "");
      if (n == 16) {
        ASSERT_EQ(grid_paper_fault(graph), "");
      }
      ++drawn;
    }
  }
  EXPECT_EQ(drawn, 4060u + 41301u);
}

TEST(GridPaperLong, EveryFamilyUpToThreeThousandVertices) {
  for (const Family& family : families()) {
    if (family.max_degree > 3) continue;
    for (const std::uint64_t n : {700u, 3000u}) {
      const Graph graph = shuffled(generate(family, n, 5), 6);
      for (const Options& options : all_grid_paper_options()) {
        ASSERT_EQ(grid_paper_fault(graph, options), "") << family.name << ' ' << n;
      }
    }
  }
}

/// Truncated cubic graphs, which have n/3 triangles, attain the orders of the proof: Cartesian ones
/// and, behind them, those in the paper's skewed coordinates.
TEST(GridPaperLong, TruncatedCubicGraphsGrowAsTheProofSays) {
  std::array<std::array<double, 6>, 2> extents{};
  for (const std::size_t i : {0u, 1u}) {
    const Graph graph = truncated(generate(find_family("random-cubic"), i == 0 ? 512 : 2048, 3));
    const Drawing drawing = grid_paper::draw(shuffled(graph, 1));
    const auto box = bounding_box(drawing).extents();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      extents[i][axis] = static_cast<double>(box[axis]);
      extents[i][3 + axis] = static_cast<double>(drawing.counters[axis].value);
    }
  }
  constexpr std::array kExponents = {3.0, 2.0, 3.0, 1.0, 2.0, 3.0};
  for (std::size_t axis = 0; axis < 6; ++axis) {
    const double ratio = extents[1][axis] / extents[0][axis];
    EXPECT_NEAR(std::log(ratio) / std::log(4), kExponents[axis], 0.1) << axis;
  }
}

}  // namespace
}  // namespace ar3d::testing
