#include "formats/format_helpers.h"

namespace ar3d::testing {
namespace {

TEST(Dimacs, ReadsEdgesColoursAndArcs) {
  const Graph expected(4, {{1, 0}, {2, 1}});
  const std::vector<Graph> graphs = read_text(
      "c\nc a comment\np edge 4 2\ne 1 2\ne 3 2\n"
      "p col 4 2\nc inside\ne 2 1\ne 2 3\n"
      "p sp 4 4\na 1 2 17\na 2 1 17\na 3 2\na 2 3\n");
  ASSERT_EQ(graphs.size(), 3u);
  for (const Graph& graph : graphs) EXPECT_EQ(edge_set(graph), edge_set(expected));
}

TEST(Dimacs, RefusesWithPlaceAndValue) {
  EXPECT_EQ(refusal("p max 4 5\n"),
            "f:1:3: only 'edge', 'col' and 'sp' are supported here, found 'max'");
  EXPECT_EQ(refusal("c x\ne 1 2\n"), "f:2:1: expected 'p', found 'e'");
  EXPECT_EQ(refusal("p edge 3 1\na 1 2\n"), "f:2:1: expected 'c' or 'e', found 'a'");
  EXPECT_EQ(refusal("p edge 3 x\n"), "f:1:10: expected a number of edges, found 'x'");
  EXPECT_EQ(refusal("p edge 3 2\ne 1 2\n"), "f:2: 2 edges announced, found 1");
  EXPECT_EQ(refusal("p edge 3 1\ne 1 4\n"),
            "f:2:5: vertex id 4 is out of range, the graph has 3 vertices");
  EXPECT_EQ(refusal("p edge 3 1\ne 0 1\n"), "f:2:3: vertex id 0 is below 1, the smallest here");
  EXPECT_EQ(refusal("p edge 3 1\ne 1 1\n"), "f:2:5: edge (1, 1) is a loop");
  EXPECT_EQ(refusal("p edge 3 2\ne 1 2\ne 2 1\n"),
            "f:3: edge (2, 1) is parallel to an earlier edge");
  EXPECT_EQ(refusal("p sp 3 1\na 1 2 5\n"), "f:2: (1, 2) stands without its counterpart");
  EXPECT_EQ(refusal("p sp 3 1\na 1 2 0.5\n"), "f:2:7: expected a weight, found '0.5'");
  EXPECT_EQ(refusal("p edge 4000000000 0\n"),
            "f:1: 4000000000 vertices claimed by a graph of 0 bytes, which accounts for at most "
            "1048576; --trust-sizes believes it");
}

}  // namespace
}  // namespace ar3d::testing
