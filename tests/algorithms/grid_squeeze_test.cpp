// Step 3.14: squeezed drawings are certified, longer on no axis, and keep their edges' directions.
#include "ar3d/algorithms/efforts.h"
#include "ar3d/algorithms/grid/grid.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/verify/certificate.h"
#include "support/graphs.h"

namespace ar3d::testing {
namespace {

/// What is wrong with the squeezed drawing; "" if nothing.
std::string squeezing_fault(const Graph& graph, const Drawing& drawing) {
  const Drawing small = grid::squeezed(graph, drawing);
  const Certificate certificate = certify(graph, small, grid::row().guarantee);
  if (!certificate.valid()) return certificate.violations.front().message;
  const auto before = bounding_box(drawing).extents();
  const auto after = bounding_box(small).extents();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (after[axis] > before[axis]) return "longer on axis " + std::to_string(axis);
  }
  if (small.counters != drawing.counters) return "other counters";
  if (small.instance_bound != drawing.instance_bound) return "another bound";
  return count_bends(small) == count_bends(drawing) ? "" : "other bends";
}

double share(const Graph& graph) {
  const auto volume = [&](int effort) {
    return static_cast<double>(
        volume_of(bounding_box(grid::draw(graph, {.effort = effort})).extents()));
  };
  return volume(2) / volume(1);
}

TEST(GridSqueeze, AllSmallGraphsAreCertified) {
  for (int n = 1; n <= 7; ++n) {
    for (const Graph& graph : geng("-D3 " + std::to_string(n))) {
      for (const int effort : {0, 1}) {
        ASSERT_EQ(squeezing_fault(graph, grid::draw(graph, {.effort = effort})), "") << n;
      }
    }
  }
}

TEST(GridSqueeze, FamiliesAndRelabelledCopiesAreCertified) {
  for (const Family& family : families()) {
    for (const int shuffle : {0, 1}) {
      const Graph graph = generate(family, 60, 2, {{"shuffle", shuffle}});
      if (graph.max_degree() > 3) continue;
      for (const int effort : {0, 1}) {
        EXPECT_EQ(squeezing_fault(graph, grid::draw(graph, {.effort = effort})), "") << family.name;
      }
    }
  }
}

TEST(GridSqueeze, EffortTwoIsLessThanHalfOfEffortOne) {
  EXPECT_LT(share(generate(find_family("random-cubic"), 100, 1)), 0.5);
  EXPECT_LT(share(generate(find_family("prism"), 100, 1)), 0.5);
}

TEST(GridSqueeze, ALineOfBlocksClosesUpToOneStep) {
  // An edge along (1, 1, 0) of 9 steps, its ends without other edges.
  const Graph graph(2, {{0, 1}});
  const Drawing drawing =
      drawing_from_points("grid", graph, std::vector<Point>{{0, 0, 0}, {9, 9, 0}});
  const Drawing small = grid::squeezed(graph, drawing);
  EXPECT_EQ(bounding_box(small).extents(), (std::array<std::int64_t, 3>{1, 1, 0}));
}

TEST(GridSqueeze, DrawingsWithTooManyStepsStayAsTheyAre) {
  const Graph graph(2, {{0, 1}});
  const std::int64_t far = grid::kMostSqueezed + 1;
  const Drawing drawing =
      drawing_from_points("grid", graph, std::vector<Point>{{0, 0, 0}, {far, far, 0}});
  EXPECT_EQ(drawing_hash(grid::squeezed(graph, drawing)), drawing_hash(drawing));
}

}  // namespace
}  // namespace ar3d::testing
