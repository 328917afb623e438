// Large graphs, certified at both efforts.

#include <gtest/gtest.h>

#include "algorithms/two_bend_109_support.h"
#include "ar3d/generators/catalog.h"

namespace ar3d::testing {
namespace {

TEST(TwoBend109Long, RandomRegularGraphsOfAHundredThousandVertices) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    const Graph graph = generate(find_family("random-4-regular"), 100000, seed);
    for (const int effort : {0, 1}) {
      EXPECT_EQ(two_bend_109_fault(graph, {.effort = effort}), "") << "effort " << effort;
    }
  }
}

TEST(TwoBend109Long, EveryFamilyWithTenThousandVertices) {
  for (const Family& family : families()) {
    for (const int effort : {0, 1}) {
      const Graph graph = generate(family, 10000, 3, {{"shuffle", effort}});
      EXPECT_EQ(two_bend_109_fault(graph, {.effort = effort}), "") << family.name;
    }
  }
}

}  // namespace
}  // namespace ar3d::testing
