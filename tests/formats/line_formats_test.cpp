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

TEST(AdjacencyList, RefusesWithPlaceAndValue) {
  expect_refusals({{"0: 1\n1: x\n", "f:2:4: expected a vertex id, found 'x'"},
                   {"0: 1\n1 2: 3\n", "f:2:3: unexpected '2' after the vertex before the colon"},
                   {"0: 1\n1: 0\n1: 0\n",
                    "f:3:1: a second line of this vertex, after line 2: a file of several graphs "
                    "has '# vertices "
                    "N' before each"},
                   {"0: 1 1\n1:\n", "f:1: (0, 1) stands twice"},
                   {"0: 1 0\n", "f:1:6: edge (0, 0) is a loop"},
                   {"# vertices 2\n0: 1 2\n1:\n2:\n",
                    "f:1: 2 vertices stated, 3 have a line: is the list cut "
                    "short?"}});
  EXPECT_EQ(refusal("0: 1\n1:\n", {.base = 1}), "f:2: the lines are not those of vertices 1 to 2");
  EXPECT_EQ(refusal("4000000000: 1\n"),
            "f:1:1: 4000000001 vertices claimed by a graph of 14 bytes, which accounts for at most "
            "1048800; --trust-sizes believes it");
}

TEST(Dimacs, ReadsEdgesColoursAndArcs) {
  expect_same_graphs(
      "c\nc a comment\np edge 4 2\ne 1 2\ne 3 2\n"
      "p col 4 2\nc inside\ne 2 1\ne 2 3\n"
      "p sp 4 4\na 1 2 17\na 2 1 17\na 3 2\na 2 3\n",
      3, Graph(4, {{1, 0}, {2, 1}}));
}

TEST(Dimacs, RefusesWithPlaceAndValue) {
  expect_refusals(
      {{"p max 4 5\n", "f:1:3: only 'edge', 'col' and 'sp' are supported here, found 'max'"},
       {"p edge 3 1\na 1 2\n", "f:2:1: expected 'c' or 'e', found 'a'"},
       {"p edge 3 x\n", "f:1:10: expected a number of edges, found 'x'"},
       {"p edge 3 2\ne 1 2\n", "f:2: 2 edges announced, found 1"},
       {"p edge 3 1\ne 1 4\n", "f:2:5: vertex id 4 is out of range, the graph has 3 vertices"},
       {"p edge 3 1\ne 0 1\n", "f:2:3: vertex id 0 is below 1, the smallest here"},
       {"p edge 3 1\ne 1 1\n", "f:2:5: edge (1, 1) is a loop"},
       {"p edge 3 2\ne 1 2\ne 2 1\n", "f:3: edge (2, 1) is parallel to an earlier edge"},
       {"p sp 3 1\na 1 2 5\n", "f:2: (1, 2) stands without its counterpart"},
       {"p sp 3 1\na 1 2 0.5\n", "f:2:7: expected a weight, found '0.5'"},
       {"p edge 4000000000 0\n",
        "f:1: 4000000000 vertices claimed by a graph of 0 bytes, which accounts for at most "
        "1048576; --trust-sizes believes it"}});
}

const std::string kSymmetric = "%%MatrixMarket matrix coordinate pattern symmetric\n";
const std::string kGeneral = "%%MatrixMarket matrix coordinate pattern general\n";

TEST(MatrixMarket, ReadsSymmetricAndGeneral) {
  const Graph expected(4, {{1, 0}, {2, 1}});
  const std::vector<Graph> graphs = read_text(kSymmetric + "% comment\n\n4 4 2\n2 1\n3 2\n" +
                                              "%%matrixmarket MATRIX Coordinate Pattern GENERAL\n" +
                                              "4 4 4\n2 1\n1 2\n2 3\n% inside\n3 2\n");
  ASSERT_EQ(graphs.size(), 2u);
  EXPECT_EQ(edge_set(graphs[0]), edge_set(expected));
  EXPECT_EQ(edge_set(graphs[1]), edge_set(expected));
}

TEST(MatrixMarket, RefusesOtherMatrices) {
  expect_refusals(
      {{"%%MatrixMarket matrix array real general\n",
        "f:1:23: only 'coordinate' is supported here, found 'array'"},
       {"%%MatrixMarket matrix coordinate real symmetric\n",
        "f:1:34: only 'pattern' is supported here, found 'real'"},
       {"%%MatrixMarket matrix coordinate pattern skew-symmetric\n",
        "f:1:42: only 'symmetric' and 'general' are supported here, found 'skew-symmetric'"},
       {kSymmetric + "3 4 0\n", "f:2:3: a graph's matrix is square, this one is 3 by 4"},
       {kGeneral + "3 3 3\n2 1\n1 2\n3 1\n", "f:5: (3, 1) stands without its counterpart"},
       {kGeneral + "3 3 3\n1 3\n2 1\n1 2\n", "f:3: (1, 3) stands without its counterpart"}});
}

TEST(MatrixMarket, RefusesWithPlaceAndValue) {
  expect_refusals(
      {{kSymmetric, "f:1: the text ends before the line with the sizes"},
       {kSymmetric + "3 3\n", "f:2:4: expected a number of entries, found the end of the line"},
       {kSymmetric + "3 3 2\n2 1\n", "f:3: the text ends after 1 of 2 announced entries"},
       {kSymmetric + "3 3 1\n2 1\n3 1\n", "f:4:1: expected '%%MatrixMarket', found '3 1'"},
       {kSymmetric + "3 3 1\n4 1\n",
        "f:3:1: vertex id 4 is out of range, the graph has 3 vertices"},
       {kSymmetric + "3 3 1\n1 0\n", "f:3:3: vertex id 0 is below 1, the smallest here"},
       {kSymmetric + "3 3 1\n2 2\n", "f:3:3: edge (2, 2) is a loop"},
       {kSymmetric + "3 3 2\n2 1\n1 2\n", "f:4: edge (1, 2) is parallel to an earlier edge"},
       {kSymmetric + "3 3 1\n2 1 0.5\n", "f:3:5: unexpected '0.5' after the entry"},
       {kGeneral + "3 3 4\n2 1\n1 2\n2 1\n1 2\n", "f:6: (1, 2) stands twice"}});
}

TEST(MatrixMarket, RefusesAbsurdSizesWithoutAllocating) {
  EXPECT_EQ(refusal(kSymmetric + "4000000000 4000000000 0\n"),
            "f:2: 4000000000 vertices claimed by a graph of 0 bytes, which accounts for at most "
            "1048576; --trust-sizes believes it");
  EXPECT_EQ(refusal(kSymmetric + "3 3 18446744073709551615\n2 1\n"),
            "f:3: the text ends after 1 of 18446744073709551615 announced entries");
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

TEST(Metis, RefusesWithPlaceAndValue) {
  expect_refusals(
      {{"3 2\n2\n1 3\n", "f:3: the text ends after 2 of 3 vertices"},
       {"3 1\n2\n1 3\n2\n", "f:1: 1 edges announced, found 2"},
       {"3 2\n2\n3\n2\n", "f:2: (1, 2) stands without its counterpart"},
       {"3 2\n2 2\n1 1\n\n", "f:2: (1, 2) stands twice"},
       {"3 2\n2 4\n", "f:2:3: vertex id 4 is out of range 1 to 3"},
       {"3 2\n0\n", "f:2:1: vertex id 0 is out of range 1 to 3"},
       {"3 2\n2 1\n", "f:2:3: edge (1, 1) is a loop"},
       {"3 2\n2 x\n", "f:2:3: expected a vertex id, found 'x'"},
       {"3 2 2\n", "f:1:5: expected a format of up to three digits 0 and 1, found '2'"},
       {"3 2 1\n2\n", "f:2:2: expected the weight of an edge, found the end of the line"},
       {"4000000000 0\n", "f:1: the text ends after 0 of 4000000000 vertices"},
       {"99999999999 0\n", "f:1:1: 99999999999 vertices are too many, the limit is 4294967294"}},
      {.format = "metis"});
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
