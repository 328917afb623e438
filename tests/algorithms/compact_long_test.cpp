// The 108,376 graphs of maximum degree 4 with ten vertices, and graphs of a million.

#include <gtest/gtest.h>

#include "algorithms/compact_support.h"
#include "ar3d/generators/catalog.h"
#include "support/graphs.h"

namespace ar3d {
namespace {

TEST(CompactLong, TenVerticesAreCertifiedInEveryMode) {
  const std::vector<Graph> graphs = testing::geng("-D4 10");
  EXPECT_EQ(graphs.size(), 108376u);
  for (const Graph& graph : graphs) {
    for (const compact::Options& options : testing::compact_modes()) {
      ASSERT_EQ(testing::compact_fault(graph, options), "") << "effort " << options.effort;
    }
  }
}

TEST(CompactLong, AMillionVerticesAreCertified) {
  for (const char* family : {"random-4-regular", "union-octahedron"}) {
    EXPECT_EQ(testing::compact_fault(generate(find_family(family), 1000000, 1), {}), "") << family;
  }
}

TEST(CompactLong, ManyRandomGraphsAreCertified) {
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    const char* family = seed % 2 == 0 ? "random-4-regular" : "random-max-degree";
    const Graph graph = generate(find_family(family), 5 + seed % 200, seed);
    for (const compact::Options& options : testing::compact_modes()) {
      ASSERT_EQ(testing::compact_fault(graph, options), "") << family << " seed " << seed;
    }
  }
}

}  // namespace
}  // namespace ar3d
