#include <fmt/format.h>
#include <gtest/gtest.h>

#include "algorithms/two_bend_paper_support.h"
#include "ar3d/generators/catalog.h"
#include "support/names.h"

namespace ar3d::testing {
namespace {

class TwoBendPaperExhaustive : public ::testing::TestWithParam<int> {};

TEST_P(TwoBendPaperExhaustive, EveryGraphOfMaximumDegree3) {
  std::uint64_t seed = 0;
  for (const Graph& graph : geng(fmt::format("-D3 {}", GetParam()))) {
    expect_right_in_reference(graph);
    expect_right_in_reference(shuffled(graph, ++seed));
    if (HasFailure()) break;
  }
}
INSTANTIATE_TEST_SUITE_P(Sizes, TwoBendPaperExhaustive, ::testing::Range(1, 10), named("n"));

TEST(TwoBendPaperExhaustive, ConnectedCubicGraphsUpTo14) {
  for (int n = 4; n <= 14; n += 2) {
    for (const Graph& graph : geng(fmt::format("-c -d3 -D3 {}", n))) {
      expect_right_in_reference(graph);
      if (HasFailure()) return;
    }
  }
}

TEST(TwoBendPaperExhaustive, RandomCubicGraphsUpTo2000) {
  const Family& family = find_family("random-cubic");
  for (const std::uint64_t n : {500, 1000, 2000}) {
    for (const std::uint64_t seed : {1, 2, 3}) {
      expect_right_in_reference(generate(family, n, seed, complete_parameters(family, {})));
    }
  }
}

TEST(TwoBendPaperExhaustive, RandomMixturesOfFigures) {
  RandomStream random(4);
  const Family& family = find_family("random-subcubic");
  for (std::uint64_t i = 0; i < 1500; ++i) {
    Blown blown(generate(family, 2 + random.below(10), i, complete_parameters(family, {})));
    const std::uint32_t figures = 1 + random.below(24);
    for (std::uint32_t j = 0; j < figures; ++j) blown.any(random);
    expect_right_in_reference(blown.graph(), fmt::format("mixture {}", i));
    if (HasFailure()) return;
  }
}

TEST(TwoBendPaperExhaustive, LongCyclesPrismsAndManyComponents) {
  for (const char* name : {"cycle", "prism", "union-k4", "mixed-union", "path", "edgeless"}) {
    const Family& family = find_family(name);
    expect_right_in_reference(generate(family, 1200, 1, complete_parameters(family, {})), name);
  }
}

}  // namespace
}  // namespace ar3d::testing
