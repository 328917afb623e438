#include "formats/format_helpers.h"

namespace ar3d::testing {
namespace {

TEST(AdjacencyList, ReadsEdgesFromOneOrBothEnds) {
  const std::vector<Graph> graphs = read_text("# comment\n0: 1 2\n1 : 0\n2:\n5:0 \n");
  ASSERT_EQ(graphs.size(), 1u);
  EXPECT_EQ(edge_set(graphs[0]), edge_set(Graph(6, {{0, 1}, {0, 2}, {0, 5}})));
}

TEST(AdjacencyList, ReadsNetworkxLinesWhenForced) {
  const std::vector<Graph> graphs = read_text("#GMT\n0 1 3\n1 2\n2\n3\n", {.format = "adjlist"});
  ASSERT_EQ(graphs.size(), 1u);
  EXPECT_EQ(edge_set(graphs[0]), edge_set(Graph(4, {{0, 1}, {0, 3}, {1, 2}})));
}

TEST(AdjacencyList, RefusesWithPlaceAndValue) {
  EXPECT_EQ(refusal("0: 1\n1: x\n"), "f:2:4: expected a vertex id, found 'x'");
  EXPECT_EQ(refusal("0: 1\n1 2: 3\n"), "f:2:3: unexpected '2' after the vertex before the colon");
  EXPECT_EQ(refusal("0: 1\n1: 0\n1: 0\n"), "f:3: (1, 0) stands twice");
  EXPECT_EQ(refusal("0: 1 1\n"), "f:1: (0, 1) stands twice");
  EXPECT_EQ(refusal("0: 1 0\n"), "f:1:6: edge (0, 0) is a loop");
  EXPECT_EQ(refusal("# vertices 2\n0: 1 2\n"),
            "f:2:6: vertex id 2 is out of range, the graph has 2 vertices");
  EXPECT_EQ(refusal("1: 2 0\n", {.base = 1}), "f:1:6: vertex id 0 is below 1, the smallest here");
  EXPECT_EQ(refusal("0: 4000000000\n"),
            "f:1: 4000000001 vertices claimed by a graph of 0 bytes, which accounts for at most "
            "1048576; --trust-sizes believes it");
}

}  // namespace
}  // namespace ar3d::testing
