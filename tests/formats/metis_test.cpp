#include "formats/format_helpers.h"
#include "support/graphs.h"

namespace ar3d::testing {
namespace {

TEST(Metis, ReadsTheManualsGraphInItsFourForms) {
  const Graph expected(
      7, {{0, 4}, {0, 2}, {0, 1}, {1, 2}, {1, 3}, {2, 4}, {2, 3}, {3, 5}, {3, 6}, {4, 5}, {5, 6}});
  const std::vector<Graph> graphs = read_text(
      "7 11\n5 3 2\n1 3 4\n5 4 2 1\n2 3 6 7\n1 3 6\n5 4 7\n6 4\n"
      "7 11 001\n5 1 3 2 2 1\n1 1 3 2 4 1\n5 3 4 2 2 2 1 2\n2 1 3 2 6 2 7 5\n1 1 3 3 6 2\n5 2 4 2 "
      "7 6\n6 6 4 5\n"
      "7 11 011 1\n4 5 1 3 2 2 1\n2 1 1 3 2 4 1\n5 5 3 4 2 2 2 1 2\n3 2 1 3 2 6 2 7 5\n1 1 1 3 3 6 "
      "2\n6 5 2 4 2 7 6\n"
      "2 6 6 4 5\n"
      "7 11 10 3\n1 2 0 5 3 2\n0 2 2 1 3 4\n4 1 1 5 4 2 1\n2 2 3 2 3 6 7\n1 1 1 1 3 6\n2 2 1 5 4 "
      "7\n1 2 1 6 4\n");
  ASSERT_EQ(graphs.size(), 4u);
  for (const Graph& graph : graphs) EXPECT_EQ(edge_set(graph), edge_set(expected));
}

TEST(Metis, BlankLinesAreVerticesWithoutNeighbours) {
  const std::vector<Graph> graphs = read_text("% c\n3 1\n\n% c\n3\n2\n\n\n2 0\n\n\n");
  ASSERT_EQ(graphs.size(), 2u);
  EXPECT_EQ(edge_set(graphs[0]), edge_set(Graph(3, {{1, 2}})));
  EXPECT_EQ(edge_set(graphs[1]), edge_set(Graph(2, {})));
}

TEST(Metis, RefusesWithPlaceAndValue) {
  const ReadOptions metis{.format = "metis"};
  EXPECT_EQ(refusal("3 2\n2\n1 3\n", metis), "f:3: the text ends after 2 of 3 vertices");
  EXPECT_EQ(refusal("3 1\n2\n1 3\n2\n", metis), "f:1: 1 edges announced, found 2");
  EXPECT_EQ(refusal("3 2\n2\n3\n2\n", metis), "f:2: (1, 2) stands without its counterpart");
  EXPECT_EQ(refusal("3 2\n2 2\n1 1\n\n", metis), "f:2: (1, 2) stands twice");
  EXPECT_EQ(refusal("3 2\n2 4\n", metis), "f:2:3: vertex id 4 is out of range 1 to 3");
  EXPECT_EQ(refusal("3 2\n0\n", metis), "f:2:1: vertex id 0 is out of range 1 to 3");
  EXPECT_EQ(refusal("3 2\n2 1\n", metis), "f:2:3: edge (1, 1) is a loop");
  EXPECT_EQ(refusal("3 2\n2 x\n", metis), "f:2:3: expected a vertex id, found 'x'");
  EXPECT_EQ(refusal("3 2 2\n", metis),
            "f:1:5: expected a format of up to three digits 0 and 1, found '2'");
  EXPECT_EQ(refusal("3 2 1\n2\n", metis),
            "f:2:2: expected the weight of an edge, found the end of the line");
  EXPECT_EQ(refusal("4000000000 0\n", metis), "f:1: the text ends after 0 of 4000000000 vertices");
  EXPECT_EQ(refusal("99999999999 0\n", metis),
            "f:1:1: 99999999999 vertices are too many, the limit is 4294967294");
}

TEST(Metis, IsToldFromEdgeLists) {
  const auto detected = [](const std::string& text) {
    return find_graph_format("metis").detect({text, true});
  };
  EXPECT_TRUE(detected("3 2\n2\n1 3\n2\n"));           // rows of other lengths than two
  EXPECT_TRUE(detected("4 4\n2 4\n1 3\n2 4\n1 3\n"));  // all two, but (4, 4) would be a loop
  EXPECT_FALSE(detected("2 0\n\n\n"));
  EXPECT_TRUE(detected("3 2\n2\n1 3\n"));       // cut
  EXPECT_TRUE(detected("3 2 001\n2 9 3 9\n"));  // weights
  EXPECT_FALSE(detected("2 0\n"));              // one edge
  EXPECT_FALSE(detected("3 5\n"));
  EXPECT_FALSE(detected("0 1\n1 2\n"));
  EXPECT_FALSE(detected("5 1\n1 2\n\n3 4\n"));
  EXPECT_FALSE(detected("3 2\n2\n1 7\n2\n"));  // 7 is no vertex
  EXPECT_FALSE(detected("3 2\n2\n1 x\n"));
  EXPECT_FALSE(detected(""));
  EXPECT_TRUE(find_graph_format("metis").detect(
      {"30000 45000\n2 3 4\n1 7", false}));  // the cut line is left out
}

}  // namespace
}  // namespace ar3d::testing
