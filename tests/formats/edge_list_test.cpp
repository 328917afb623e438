#include "formats/format_helpers.h"
#include "support/graphs.h"

namespace ar3d::testing {
namespace {

TEST(EdgeList, ReadsCommentsBlanksAndCountsVertices) {
  const std::vector<Graph> graphs = read_text("# SNAP style\n% another\n0 1\n\n  2\t1\r\n 4 0 \n");
  ASSERT_EQ(graphs.size(), 1u);
  EXPECT_EQ(edge_set(graphs[0]), edge_set(Graph(5, {{0, 1}, {1, 2}, {0, 4}})));
}

TEST(EdgeList, HeadersGiveTheNumberOfVerticesAndBeginGraphs) {
  const std::vector<Graph> graphs =
      read_text("# vertices 4\n0 1\nn 3\n% vertices 0\n# vertices 2\n1 0");
  ASSERT_EQ(graphs.size(), 4u);
  EXPECT_EQ(edge_set(graphs[0]), edge_set(Graph(4, {{0, 1}})));
  EXPECT_EQ(edge_set(graphs[1]), edge_set(Graph(3, {})));
  EXPECT_EQ(edge_set(graphs[2]), edge_set(Graph(0, {})));
  EXPECT_EQ(edge_set(graphs[3]), edge_set(Graph(2, {{0, 1}})));
}

TEST(EdgeList, OneBased) {
  const std::vector<Graph> graphs = read_text("1 2\n3 1\n", {.base = 1});
  EXPECT_EQ(edge_set(graphs[0]), edge_set(Graph(3, {{0, 1}, {0, 2}})));
  expect_refusals({{"1 2\n3 0\n", "f:2:3: vertex id 0 is below 1, the smallest here"},
                   {"n 2\n1 3\n", "f:2:3: vertex id 3 is out of range, the graph has 2 vertices"},
                   {"1 2\n2 1\n", "f:2: edge (2, 1) is parallel to an earlier edge"}},
                  {.base = 1});
  EXPECT_EQ(refusal("1 2\n", {.base = 2}), "vertex ids start at 0 or 1, not at 2");
}

TEST(EdgeList, RefusesWithPlaceAndValue) {
  expect_refusals(
      {{"0 1\n1 two\n", "f:2:3: expected a vertex id, found 'two'"},
       {"0 1\n1\n", "f:2:2: expected a vertex id, found the end of the line"},
       {"0 1 5\n", "f:1:5: unexpected '5' after the edge"},
       {"0 -1\n", "f:1:3: expected a vertex id, found '-1'"},
       {"0 1.5\n", "f:1:3: expected a vertex id, found '1.5'"},
       {"# vertices 2\n\n0 2\n", "f:3:3: vertex id 2 is out of range, the graph has 2 vertices"},
       {"0 1\n7 7\n", "f:2:3: edge (7, 7) is a loop"},
       {"0 1\n# comment\n2 3\n\n1 0\n", "f:5: edge (1, 0) is parallel to an earlier edge"},
       {"# vertices many\n", "f:1:12: expected a number of vertices, found 'many'"},
       {"n 5 6\n", "f:1:5: unexpected '6' after the number of vertices"}});
}

TEST(EdgeList, RefusesAbsurdNumbersWithoutAllocating) {
  expect_refusals(
      {{"0 99999999999999999999\n",
        "f:1:3: a vertex id '99999999999999999999' does not fit 64 bits"},
       {"0 18446744073709551615\n",
        "f:1:3: vertex id 18446744073709551615 is too large, ids fit 32 bits"},
       {"0 1\n0 4000000000\n1 2\n",
        "f:2: 4000000001 vertices claimed by a graph of 17 bytes, which accounts for at most "
        "1048848; --trust-sizes believes it"},
       {"# vertices 4000000000\n0 1\n",
        "f:1: 4000000000 vertices claimed by a graph of 4 bytes, which accounts for at most "
        "1048640; --trust-sizes believes it"},
       {"n 9999999999\n", "f:1: 9999999999 vertices are too many, the limit is 4294967294"}});
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
        "source,target,weight\na,b,1\nb,c,2\n", "0;1\n1;2;0.5\n", "\"0\";\"1\"\n\"1\";\"2\"\n",
        "\"a\",\"b\"\r\n\"b\",\"c\"\r\n",
        "\"Source\";\"Target\";\"Weight\"\n\"a\";\"b\";0.5\nb;\"c\";1\n",
        "source,target\n2,1\n0,1\n", "source;target\n0;1\n2;1\n",
        "\"12 Elm\",\"b, c\"\n\"b, c\",\"d\"\n", "\"ä\t1\",\"ö\"\n\"ö\",\"ü\"\n"}) {
    EXPECT_EQ(edge_set(read_text(text).at(0)), edge_set(graphs[0])) << text;
  }
  expect_refusals(
      {{"0,1\n1,x\n", "f:2:3: expected a vertex id, found 'x'"},
       {"0;1\n1;-2\n", "f:2:3: expected a vertex id, found '-2'"},
       {"\"a\",\"b\"\n\"b\",\"c\n", "f:2:5: no quote ends '\"c'"},
       {"\"a\",\"b\"\n\"b\"\n", "f:2:2: expected a second name, the other end of the edge"},
       {"\"a\",\"b\",heavy\n", "f:1:9: unexpected 'heavy' after the edge"},
       {"0 1 2.5 7\n", "f:1:5: unexpected '2.5' after the edge"},
       {"0 1 {}\n1 0 {}\n", "f:2: edge (1, 0) is parallel to an earlier edge"}});
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
  for (const char* text : {"5 3\n1 2\n2 3\n4 5\n", "4 4\n1 2\n2 3\n3 4\n4 1\n"}) {
    const std::string told = refusal(text, {.format = "edgelist"});
    EXPECT_NE(told.find("--base 1 --first-line header"), std::string::npos) << text << told;
    EXPECT_NE(told.find("base and first_line"), std::string::npos) << told;
    EXPECT_EQ(std::count(told.begin(), told.end(), '\n'), 0);
  }
  const ReadOptions from_one{.format = "edgelist", .base = 1, .first_line = FirstLine::header};
  EXPECT_EQ(edge_set(read_text("5 3\n1 2\n2 3\n4 5\n", from_one).at(0)),
            edge_set(Graph(5, {{0, 1}, {1, 2}, {3, 4}})));
  EXPECT_EQ(read_text("4 4\n1 2\n2 3\n3 4\n4 1\n", from_one).at(0).num_edges(), 4u);
  const ReadOptions edge{.first_line = FirstLine::edge};
  EXPECT_EQ(read_text("5 3\n1 2\n2 3\n4 5\n", edge).at(0).num_edges(), 4u);
  EXPECT_EQ(read_text("5 3\n1 2\n2 3\n4 0\n", edge).at(0).num_edges(), 4u);
  EXPECT_EQ(read_text("5 2\n1 2\n2 3\n4 5\n").at(0).num_edges(), 4u) << "3 edges, not 2";
}

TEST(EdgeList, TheEndingTellsItFromMetis) {
  const std::string text = "4 4\n1 2\n2 3\n3 4\n4 1\n";
  const auto refused = [&](const char* name) {
    return problem([&] { GraphReader(TextInput(name, bytes_of(text)), {}).next(); });
  };
  for (const char* name : {"a.edges", "a.el", "a.edgelist.gz"}) {
    EXPECT_NE(refused(name).find("--base 1 --first-line header"), std::string::npos)
        << name << refused(name);
  }
  EXPECT_EQ(refused("a.graph").find("--base"), std::string::npos);
}

}  // namespace
}  // namespace ar3d::testing
