#include "algorithms/diamond_colourings.h"
#include "algorithms/diamond_support.h"
#include "support/graphs.h"

namespace ar3d::testing {
namespace {

// The case n = 7 of the size bound's proof: every pair of colourings, with the items in every order
// and direction.
TEST(GuaranteedMode, FitsOnEveryColouringOfSevenVertices) {
  std::size_t colourings = 0;
  EXPECT_EQ(count_colouring_faults(7, colourings), 0u);
  EXPECT_EQ(colourings, 32961660u);
}

TEST(EveryGraphOfTenVertices, IsCertifiedInEveryMode) {
  const std::vector<Graph> graphs = geng("-D4 10");
  EXPECT_GT(graphs.size(), 100000u);
  for (const Graph& graph : graphs) {
    ASSERT_EQ(diamond_fault(graph), "");
  }
}

TEST(EveryFourRegularGraphOfTwelveVertices, IsCertifiedInFiftyLabellings) {
  std::uint64_t seed = 1000000;
  for (const Graph& graph : geng("-c -d4 -D4 12")) {
    for (int relabelling = 0; relabelling < 50; ++relabelling) {
      ASSERT_EQ(diamond_fault(shuffled(graph, ++seed)), "") << "seed " << seed;
    }
  }
}

}  // namespace
}  // namespace ar3d::testing
