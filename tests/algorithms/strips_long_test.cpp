// `compact` on the 108,376 graphs of maximum degree 4 with ten vertices, `compact-120` on those of
// maximum degree 3 with 11 and 12, both on graphs of a million and on many random ones.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "algorithms/strips_support.h"
#include "ar3d/generators/catalog.h"

namespace ar3d::testing {
namespace {

TEST(CompactLong, TenVerticesAreCertifiedAtEveryEffort) {
  const std::vector<Graph> graphs = geng("-D4 10");
  EXPECT_EQ(graphs.size(), 108376u);
  for (const Graph& graph : graphs) ASSERT_EQ(strip_fault(compact_strips(), graph), "");
}

TEST(Compact120Long, ElevenAndTwelveVerticesAreCertifiedAtEveryEffort) {
  for (const auto& [n, count] : {std::pair{11, 10946u}, std::pair{12, 36327u}}) {
    const std::vector<Graph> graphs = geng(fmt::format("-D3 {}", n));
    EXPECT_EQ(graphs.size(), count);
    std::uint64_t seed = 0;
    for (const Graph& graph : graphs) {
      ASSERT_EQ(strip_fault(compact_120_strips(), graph), "");
      const Graph relabelled = shuffled(graph, ++seed);
      ASSERT_EQ(strip_fault(compact_120_strips(), relabelled), "") << "seed " << seed;
    }
  }
}

class StripsLong : public Strips {};

TEST_P(StripsLong, OfAMillionVerticesAreCertified) {
  for (const std::string& family : {algorithm().regular, algorithm().small_union}) {
    const Graph graph = generate(find_family(family), 1000000, 1);
    EXPECT_EQ(strip_fault(algorithm(), graph, algorithm().draw(graph, 1)), "") << family;
  }
}

TEST_P(StripsLong, OfManyRandomGraphsAreCertified) {
  const char* irregular = algorithm().max_degree() == 4 ? "random-max-degree" : "random-subcubic";
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    const std::string family = seed % 2 == 0 ? algorithm().regular : irregular;
    const Graph graph = generate(find_family(family), 6 + 2 * (seed % 100), seed);
    ASSERT_EQ(strip_fault(algorithm(), graph), "") << family << " seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Of, StripsLong, kBothStripAlgorithms, kStripSuite);

}  // namespace
}  // namespace ar3d::testing
