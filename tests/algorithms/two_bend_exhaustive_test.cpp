#include <fmt/format.h>
#include <gtest/gtest.h>

#include "algorithms/two_bend_support.h"
#include "support/names.h"

namespace ar3d::testing {
namespace {

class TwoBendExhaustive : public ::testing::TestWithParam<int> {};

/// Every graph of maximum degree 3 with n vertices, as given and relabelled, ordinary and safe.
TEST_P(TwoBendExhaustive, CertifiesEveryGraphOfMaximumDegree3) {
  const int n = GetParam();
  std::uint64_t seed = 0;
  for (const Graph& graph : geng(fmt::format("-D3 {}", n))) {
    expect_certified(graph);
    expect_certified(graph, {.force_safe_layout = true});
    for (int i = 0; i < 5; ++i) expect_certified(shuffled(graph, ++seed));
    expect_certified(graph, {.effort = 0});
    if (HasFailure()) break;
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, TwoBendExhaustive, ::testing::Range(1, 12), named("n"));

}  // namespace
}  // namespace ar3d::testing
