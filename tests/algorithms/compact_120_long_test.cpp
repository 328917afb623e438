// The graphs of maximum degree 3 with 11 and 12 vertices, the 4060 connected cubic graphs with 16,
// and graphs of a million.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "algorithms/compact_120_support.h"
#include "ar3d/generators/catalog.h"
#include "support/graphs.h"

namespace ar3d {
namespace {

TEST(Compact120Long, ElevenAndTwelveVerticesAreCertifiedInEveryMode) {
  for (const int n : {11, 12}) {
    for (const Graph& graph : testing::geng(fmt::format("-D3 {}", n))) {
      for (const compact_120::Options& options : testing::compact_120_modes()) {
        ASSERT_EQ(testing::compact_120_fault(graph, options), "") << "effort " << options.effort;
      }
    }
  }
}

TEST(Compact120Long, AMillionVerticesAreCertified) {
  for (const char* family : {"random-cubic", "union-k4"}) {
    EXPECT_EQ(testing::compact_120_fault(generate(find_family(family), 1000000, 1),
                                         compact_120::Options{}),
              "")
        << family;
  }
}

TEST(Compact120Long, ManyRandomGraphsAreCertified) {
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    const Graph graph = seed % 2 == 0
                            ? generate(find_family("random-cubic"), 4 + 2 * (seed % 100), seed)
                            : generate(find_family("random-subcubic"), 6 + 2 * (seed % 100), seed);
    for (const compact_120::Options& options : testing::compact_120_modes()) {
      ASSERT_EQ(testing::compact_120_fault(graph, options), "") << "seed " << seed;
    }
  }
}

}  // namespace
}  // namespace ar3d
