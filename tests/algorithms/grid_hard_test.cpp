// Algorithm `grid` on the families that are hard for it, some thousand vertices, certified at every
// effort; and its steps, counted at two sizes: they grow like n.
#include <fmt/format.h>

#include <array>

#include "algorithms/grid_checks.h"
#include "ar3d/algorithms/grid/flat.h"
#include "ar3d/generators/catalog.h"
#include "support/graphs.h"

namespace ar3d::testing {
namespace {

struct HardFamily {
  std::string name;
  Settings parameters;

  Graph graph(std::uint64_t n) const {
    if (name == "nested-cubic-triangles") {
      return shuffled(nested_cubic_triangles(static_cast<Vertex>(n / 3)), 5);
    }
    return shuffled(generate(find_family(name), n, 5, parameters), 6);
  }
};

std::vector<HardFamily> hard_families() {
  return {{"cubic-tree", {{"leaf", 5}}},
          {"cubic-tree", {{"leaf", 7}}},
          {"cubic-tree", {{"leaf", 5}, {"shape", 1}}},
          {"random-cubic-tree", {}},
          {"random-cubic-bridges", {{"bridges", 50}}},
          {"block-chain", {}},
          {"true-sinks", {}},
          {"nested-cubic-triangles", {}},
          {"flower-snark", {}},
          {"goldberg-snark", {}},
          {"blanusa-snark", {{"type", 1}}},
          {"blanusa-snark", {{"type", 2}}},
          {"union-flower-snark", {}},
          {"union-petersen", {}},
          {"mixed-union", {}},
          {"spine-with-pendant-trees", {}},
          {"percolated-laves-graph", {}},
          {"random-cubic", {}}};
}

class GridOnHardFamilies : public ::testing::TestWithParam<HardFamily> {};

TEST_P(GridOnHardFamilies, IsCertifiedAtEveryEffort) {
  const Graph graph = GetParam().graph(4000);
  ASSERT_GT(graph.num_vertices(), 3500u);
  for (const int effort : {0, 1}) {
    ASSERT_EQ(grid_fault(graph, effort), "") << "effort " << effort;
  }
}

/// Steps a vertex of every kind.
std::array<double, 5> step_rates(const Graph& graph, const grid::PlaneOptions& options) {
  const grid::StepCounts steps =
      grid::assign_planes(graph, grid::processing_order(graph), options).steps;
  std::array<double, 5> rates{};
  std::ranges::transform(std::array{steps.chain_steps, steps.heights_tried, steps.end_visits,
                                    steps.blocks, steps.attempts},
                         rates.begin(), [&](std::int64_t count) {
                           return static_cast<double>(count) / graph.num_vertices();
                         });
  return rates;
}

TEST_P(GridOnHardFamilies, TakesStepsInProportionToItsVertices) {
  const std::array<Graph, 2> graphs = {GetParam().graph(10000), GetParam().graph(100000)};
  // The core, the default effort, and flat numbers with as many defects as can be had.
  for (const grid::PlaneOptions& options :
       {grid::PlaneOptions{.flat = false}, grid::PlaneOptions{.longest_chain = 8192},
        grid::PlaneOptions{.longest_chain = 0}}) {
    const auto small = step_rates(graphs[0], options);
    const auto large = step_rates(graphs[1], options);
    for (std::size_t kind = 0; kind < small.size(); ++kind) {
      // A second attempt doubles a count; chains may be longer where there are more labels.
      EXPECT_LE(large[kind], 2 * small[kind] + 1) << "kind " << kind;
      EXPECT_LE(large[kind], kind == 0 ? 20 : 4) << "kind " << kind;
    }
  }
}

std::string name_of(const ::testing::TestParamInfo<HardFamily>& info) {
  std::string name = info.param.name;
  for (const Setting& value : info.param.parameters) {
    name += fmt::format("_{}_{}", value.name, value.value);
  }
  std::ranges::replace(name, '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Families, GridOnHardFamilies, ::testing::ValuesIn(hard_families()),
                         name_of);

constexpr std::int64_t kFar = std::int64_t{1} << 40;

TEST(GridLimits, AnEndThatNeedsATooLowNumberGetsOneNearTheLimit) {
  // x - y is a defect whose slot asks for X_2(y) more than 2^40 below X_2(x).
  const std::vector<grid::Ports> ports(2);
  std::vector<grid::PlaneNumbers> x = {{5, -1, grid::kUnsetNumber}, {1, -3, grid::kUnsetNumber}};
  for (const grid::Colour label : {0u, 1u}) {
    const std::vector<grid::ColourDefect> defects = {{0, 1, 0, label, 2}};
    const std::vector<grid::HeightSlot> slots = {{2, kFar}};
    std::vector<grid::PlaneNumbers> numbers = x;
    std::int64_t blocks = 0;
    grid::number_third_colour(ports, {0, 2}, defects, slots, numbers, blocks);
    EXPECT_LE(std::abs(std::int64_t{numbers[1][2]}), grid::height_limit(2) + 100);
  }
}

}  // namespace
}  // namespace ar3d::testing
