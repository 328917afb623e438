// Formats of numbers and words a line: adjacency lists, DIMACS, Matrix Market and METIS.
#include "formats/format_helpers.h"

namespace ar3d::testing {
namespace {

/// The text holds so many graphs, each with the edges of this one.
void expect_same_graphs(const std::string& text, std::size_t count, const Graph& expected,
                        const ReadOptions& options = {}) {
  const std::vector<Graph> graphs = read_text(text, options);
  EXPECT_EQ(graphs.size(), count);
  for (const Graph& graph : graphs) EXPECT_EQ(edge_set(graph), edge_set(expected));
}

TEST(AdjacencyList, ReadsEdgesFromOneOrBothEnds) {
  const Graph expected(4, {{0, 1}, {0, 2}, {0, 3}});
  expect_same_graphs("# comment\n0: 1 2\n1 :\n2:\n3:0 \n", 1, expected);
  expect_same_graphs("0: 1 2 3\n1 : 0\n2:0\n3:0 \n", 1, expected);
}

TEST(AdjacencyList, ReadsNetworkxLinesWhenForced) {
  expect_same_graphs("#GMT\n0 1 3\n1 2\n2\n3\n", 1, Graph(4, {{0, 1}, {0, 3}, {1, 2}}),
                     {.format = "adjlist"});
}

TEST(Dimacs, ReadsEdgesColoursAndArcs) {
  expect_same_graphs(
      "c\nc a comment\np edge 4 2\ne 1 2\ne 3 2\n"
      "p col 4 2\nc inside\ne 2 1\ne 2 3\n"
      "p sp 4 4\na 1 2 17\na 2 1 17\na 3 2\na 2 3\n",
      3, Graph(4, {{1, 0}, {2, 1}}));
}

const std::string kSymmetric = "%%MatrixMarket matrix coordinate pattern symmetric\n";

TEST(MatrixMarket, ReadsSymmetricAndGeneral) {
  const Graph expected(4, {{1, 0}, {2, 1}});
  const std::vector<Graph> graphs = read_text(kSymmetric + "% comment\n\n4 4 2\n2 1\n3 2\n" +
                                              "%%matrixmarket MATRIX Coordinate Pattern GENERAL\n" +
                                              "4 4 4\n2 1\n1 2\n2 3\n% inside\n3 2\n");
  ASSERT_EQ(graphs.size(), 2u);
  EXPECT_EQ(edge_set(graphs[0]), edge_set(expected));
  EXPECT_EQ(edge_set(graphs[1]), edge_set(expected));
}

TEST(Metis, ReadsTheManualsGraphInItsFourForms) {
  const Graph expected(
      7, {{0, 4}, {0, 2}, {0, 1}, {1, 2}, {1, 3}, {2, 4}, {2, 3}, {3, 5}, {3, 6}, {4, 5}, {5, 6}});
  expect_same_graphs(
      "7 11\n5 3 2\n1 3 4\n5 4 2 1\n2 3 6 7\n1 3 6\n5 4 7\n6 4\n"
      "7 11 001\n5 1 3 2 2 1\n1 1 3 2 4 1\n5 3 4 2 2 2 1 2\n2 1 3 2 6 2 7 5\n1 1 3 3 6 2\n5 2 4 2 "
      "7 6\n6 6 4 5\n"
      "7 11 011 1\n4 5 1 3 2 2 1\n2 1 1 3 2 4 1\n5 5 3 4 2 2 2 1 2\n3 2 1 3 2 6 2 7 5\n1 1 1 3 3 6 "
      "2\n6 5 2 4 2 7 6\n"
      "2 6 6 4 5\n"
      "7 11 10 3\n1 2 0 5 3 2\n0 2 2 1 3 4\n4 1 1 5 4 2 1\n2 2 3 2 3 6 7\n1 1 1 1 3 6\n2 2 1 5 4 "
      "7\n1 2 1 6 4\n",
      4, expected);
}

TEST(Metis, BlankLinesAreVerticesWithoutNeighbours) {
  const std::vector<Graph> graphs = read_text("% c\n3 1\n\n% c\n3\n2\n\n\n2 0\n\n\n");
  ASSERT_EQ(graphs.size(), 2u);
  EXPECT_EQ(edge_set(graphs[0]), edge_set(Graph(3, {{1, 2}})));
  EXPECT_EQ(edge_set(graphs[1]), edge_set(Graph(2, {})));
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
  EXPECT_EQ(refusal("c x\ne 1 2\n", {.format = "dimacs"}), "f:2:1: expected 'p', found 'e'");
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
