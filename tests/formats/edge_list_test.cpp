#include "formats/format_helpers.h"
#include "support/graphs.h"

namespace ar3d::testing {
namespace {

TEST(EdgeList, ReadsCommentsBlanksAndCountsVertices) {
  const std::vector<Graph> graphs =
      read_text("# SNAP style\n% another one, too\n0 1\n\n  2\t1\r\n 4 0 \n");
  ASSERT_EQ(graphs.size(), 1u);
  EXPECT_EQ(edge_set(graphs[0]), edge_set(Graph(5, {{0, 1}, {1, 2}, {0, 4}})));
}

TEST(EdgeList, HeadersGiveTheNumberOfVerticesAndBeginGraphs) {
  const std::vector<Graph> graphs =
      read_text("# vertices 4\n0 1\n# vertices 3\n% vertices 0\n# vertices 2\n1 0");
  ASSERT_EQ(graphs.size(), 4u);
  EXPECT_EQ(edge_set(graphs[0]), edge_set(Graph(4, {{0, 1}})));
  EXPECT_EQ(edge_set(graphs[1]), edge_set(Graph(3, {})));
  EXPECT_EQ(edge_set(graphs[2]), edge_set(Graph(0, {})));
  EXPECT_EQ(edge_set(graphs[3]), edge_set(Graph(2, {{0, 1}})));
}

TEST(EdgeList, OneBased) {
  const std::vector<Graph> graphs = read_text("1 2\n3 1\n", {.base = 1});
  EXPECT_EQ(edge_set(graphs[0]), edge_set(Graph(3, {{0, 1}, {0, 2}})));
  expect_refusals(
      {{"1 2\n3 0\n", "f:2:3: vertex id 0 is below 1, the smallest here"},
       {"# vertices 2\n1 3\n", "f:2:3: vertex id 3 is out of range, the graph has 2 vertices"},
       {"1 2\n2 1\n", "f:2: edge (2, 1) is parallel to an earlier edge"}},
      {.base = 1});
  EXPECT_EQ(refusal("1 2\n", {.base = 2}), "vertex ids start at 0 or 1, not at 2");
}

TEST(EdgeList, LineOfAParallelEdgeIsFoundThroughGaps) {
  std::string text;
  for (int v = 1; v < 50; ++v) {
    text += "0 " + std::to_string(v) + "\n";
    if (v % 3 == 0) text += "# gap\n";
  }
  EXPECT_EQ(refusal(text + "7 0\n0 60\n"), "f:66: edge (7, 0) is parallel to an earlier edge");
}

TEST(EdgeList, ReadsOverAttributesOfNetworkx) {
  const std::vector<Graph> graphs = read_text("0 1 {}\n1 2 {'weight': 2.5}\n");
  ASSERT_EQ(graphs.size(), 1u);
  EXPECT_EQ(edge_set(graphs[0]), edge_set(Graph(3, {{0, 1}, {1, 2}})));
  EXPECT_EQ(edge_set(read_text("0 1 2.5\n1 2 -1e-3\n").at(0)), edge_set(graphs[0]));
  EXPECT_EQ(refusal("0 1 3\n"), "f:1:5: unexpected '3' after the edge") << "three ids or a weight?";
  EXPECT_EQ(edge_set(read_text("0 1 3\n1 2 4\n", {.format = "edgelist"}).at(0)),
            edge_set(graphs[0]));
  for (const char* text :
       {"0,1\n1,2\n", "0,1,0.5\n1,2,7\n", "source,target\n0,1\n1,2\n",
        "source,target,weight\na,b,1\nb,c,2\n", "0;1;3\n1;2;0.5\n", "\"0\";\"1\"\n\"1\";\"2\"\n",
        "\"a\",\"b\"\r\n\"b\",\"c\"\r\n",
        "\"Source\";\"Target\";\"Weight\"\n\"a\";\"b\";0.5\nb;\"c\";1\n",
        "source,target\n2,1\n0,1\n", "source;target\n0;1\n2;1\n",
        "\"12 Elm\",\"b, c\"\n\"b, c\",\"d\"\n", "\"ä\t1\",\"ö\"\n\"ö\",\"ü\"\n"}) {
    EXPECT_EQ(edge_set(read_text(text).at(0)), edge_set(graphs[0])) << text;
  }
  GraphReader reader(TextInput("f", bytes_of("\"a \"\"b\"\"\",\"c, d\"\n")), {});
  EXPECT_EQ(reader.next()->num_edges(), 1u);
  EXPECT_THAT(reader.names(), ::testing::ElementsAre("a \"b\"", "c, d"));
}

TEST(EdgeList, AHeaderThatCanBeNothingElseIsRead) {
  EXPECT_EQ(edge_set(read_text("3 3\n0 1\n1 2\n2 0\n").at(0)),
            edge_set(Graph(3, {{0, 1}, {1, 2}, {0, 2}})));
}

TEST(EdgeList, AFirstLineThatCanBeBothIsAskedAbout) {
  for (const char* text : {"1 0\n", "1 0\n\n", "2 1\n0 1\n", "9 2\n0 1\n1 2\n"}) {
    EXPECT_NE(refusal(text).find("--first-line edge or --first-line header"), std::string::npos)
        << text << refusal(text);
  }
  const ReadOptions header{.first_line = FirstLine::header};
  EXPECT_EQ(read_text("9 2\n0 1\n1 2\n", header).at(0).num_vertices(), 9u);
  EXPECT_EQ(read_text("9 2\n0 1\n1 2\n", header).at(0).num_edges(), 2u);
  EXPECT_EQ(read_text("9 2\n0 1\n1 2\n", {.first_line = FirstLine::edge}).at(0).num_edges(), 3u);
  EXPECT_EQ(read_text("0 1\n1 2\n").at(0).num_edges(), 2u) << "no header: ids are not below 0";
  EXPECT_NE(refusal("9 3\n0 1\n", header).find("announced"), std::string::npos);
}

TEST(EdgeList, AHeaderOfIdsFromOneIsNeverReadAsAnEdge) {
  EXPECT_EQ(
      refusal("5 3\n1 2\n2 3\n4 5\n", {.format = "edgelist"}),
      "f:1: '5 3' may be an edge, or the header of a graph with 5 vertices and 3 edges: --base 1 "
      "--first-line edge or --base 1 --first-line header says which (in a study the keys base and "
      "first_line)");
  EXPECT_EQ(edge_set(read_text("4 4\n1 2\n2 3\n3 4\n4 1\n", {.format = "edgelist"}).at(0)),
            edge_set(cycle(4)))
      << "it is no edge, so that ids are from 1";
  const ReadOptions from_one{.format = "edgelist", .base = 1, .first_line = FirstLine::header};
  EXPECT_EQ(edge_set(read_text("5 3\n1 2\n2 3\n4 5\n", from_one).at(0)),
            edge_set(Graph(5, {{0, 1}, {1, 2}, {3, 4}})));
  EXPECT_EQ(read_text("4 4\n1 2\n2 3\n3 4\n4 1\n", from_one).at(0).num_edges(), 4u);
  const ReadOptions edge{.base = 0, .first_line = FirstLine::edge};
  EXPECT_EQ(read_text("5 3\n1 2\n2 3\n4 5\n", edge).at(0).num_edges(), 4u);
  EXPECT_EQ(read_text("5 3\n1 2\n2 3\n4 0\n", edge).at(0).num_edges(), 4u);
  EXPECT_EQ(read_text("5 2\n1 2\n2 3\n4 5\n", {.base = 1}).at(0).num_edges(), 4u)
      << "3 edges, not 2";
}

TEST(EdgeList, TheEndingTellsItFromMetis) {
  const std::string text = "6 6\n2 6\n1 3\n2 4\n3 5\n4 6\n1 5\n";
  const auto read = [&](const char* name) {
    return edge_set(*GraphReader(TextInput(name, bytes_of(text)), {}).next());
  };
  const Graph triangles(6, {{1, 5}, {0, 2}, {1, 3}, {2, 4}, {3, 5}, {0, 4}});
  for (const char* name : {"a.edges", "a.el", "a.edgelist.gz"}) {
    EXPECT_EQ(read(name), edge_set(triangles)) << name;
  }
  EXPECT_EQ(read("a.graph"), edge_set(cycle(6)));
  EXPECT_EQ(refusal(text),
            "f:1: this may be METIS or an edge list: --from metis or --from edgelist says which");
}

}  // namespace
}  // namespace ar3d::testing
