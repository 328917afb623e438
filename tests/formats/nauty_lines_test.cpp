#include "formats/format_helpers.h"
#include "support/graphs.h"

namespace ar3d::testing {
namespace {

TEST(NautyLines, ReadTheExamplesOfTheirDescription) {
  const std::vector<Graph> graphs = read_text("DQc\n\n:Fa@x^\n?\nDQc");  // blanks, no last end
  ASSERT_EQ(graphs.size(), 4u);
  EXPECT_EQ(edge_set(graphs[0]), edge_set(Graph(5, {{0, 2}, {0, 4}, {1, 3}, {3, 4}})));
  EXPECT_EQ(edge_set(graphs[1]), edge_set(Graph(7, {{0, 1}, {0, 2}, {1, 2}, {5, 6}})));
  EXPECT_EQ(graphs[2].num_vertices(), 0u);
  EXPECT_EQ(edge_set(graphs[3]), edge_set(graphs[0]));
}

TEST(NautyLines, AgreeWithNautyByteForByte) {
  const std::vector<Graph> graphs = geng("6");
  ASSERT_EQ(graphs.size(), 156u);
  for (const auto& [format, command] : {std::pair("graph6", "nauty-geng -q 6"),
                                        {"sparse6", "nauty-geng -q 6 | nauty-copyg -q -s"},
                                        {"isparse6", "nauty-geng -q 6 | nauty-copyg -q -i"}}) {
    const std::string lines = run(command).out;
    EXPECT_EQ(written(graphs, find_graph_format(format)), lines);
    for (const std::string& head : {std::string(), fmt::format(">>{}<<", format)}) {
      if (head == ">>isparse6<<") continue;  // there is none
      const std::vector<Graph> back = read_text(head + lines);
      ASSERT_EQ(back.size(), graphs.size());
      for (std::size_t i = 0; i < back.size(); ++i) {
        EXPECT_EQ(edge_set(back[i]), edge_set(graphs[i]));
      }
    }
  }
}

TEST(NautyLines, AgreeWithNautyOnEveryPaddingOfPowersOfTwo) {
  for (const char* n : {"1", "2", "3", "4", "5", "7", "8"}) {
    const std::string size = n;
    const std::string range = size == "8" ? " 0:9" : "";  // 12346 graphs are more than needed
    const std::string sparse6 = run("nauty-geng -q " + size + range + " | nauty-copyg -q -s").out;
    EXPECT_EQ(written(geng(size + range), find_graph_format("sparse6")), sparse6);
    EXPECT_EQ(written(read_text(sparse6), find_graph_format("sparse6")), sparse6);
  }
}

TEST(IncrementalSparse6, FollowsAnyKindOfLine) {
  const std::string two = written({Graph(5, {{0, 2}, {0, 4}, {1, 3}, {3, 4}}), Graph(5, {{0, 2}})},
                                  find_graph_format("isparse6"));
  const std::vector<Graph> graphs = read_text("DQc\n" + two.substr(two.find(';')));
  ASSERT_EQ(graphs.size(), 2u);
  EXPECT_EQ(edge_set(graphs[1]), edge_set(Graph(5, {{0, 2}})));
}

TEST(Digraph6, IsReadUndirected) {
  const Graph cycle(3, {{0, 1}, {1, 2}, {0, 2}});
  for (const char* text : {"&BP_\n", ">>digraph6<<&BP_\n", "&B\\o\n"}) {  // round, both ways
    const Graph graph = read_text(text, {.simplify = true, .undirected = true}).at(0);
    EXPECT_EQ(edge_set(graph), edge_set(cycle)) << text;
  }
  EXPECT_EQ(refusal("&BP\n", {.undirected = true}),
            "f:1:3: 3 vertices take 2 characters after the size, found 1");
}

TEST(Graph6, LongSizes) {
  EXPECT_EQ(read_text(":~?@c\n")[0].num_vertices(), 100u);         // 18 bits
  EXPECT_EQ(read_text(":~~???~??\n")[0].num_vertices(), 258048u);  // 36 bits
}

TEST(Graph6, RefusesWithPlaceAndValue) {
  expect_refusals(
      {{"DQc\nDQ\n", "f:2:2: 5 vertices take 2 characters after the size, found 1"},
       {"DQcc\n", "f:1:2: 5 vertices take 2 characters after the size, found 3"},
       {"DQ\x80\n", "f:1:3: character '\\x80' is not one of graph6 and sparse6 ('?' to '~')"},
       {"DQc\nD c\n", "f:2:2: character ' ' is not one of graph6 and sparse6 ('?' to '~')"},
       {"DQ~\n", "f:1:3: the padding bits are not zero"},
       {"~?\n", "f:1:3: the line ends too early"},
       {"&DQc\n",
        "f:1:1: this is digraph6: only undirected graphs are read (--undirected drops "
        "directions)"},
       {">>planar_code<<\n",
        "f:1:1: unknown header '>>planar_code<<', expected '>>graph6<<' or '>>sparse6<<'"}});
}

TEST(Graph6, RefusesAbsurdSizesWithoutAllocating) {
  expect_refusals(
      {{"~~~~~~~~\n", "f:1:1: 68719476735 vertices are too many, the limit is 4294967294"},
       {"~~?}????\n",
        "f:1:1: 1040187392 vertices claimed by a graph of 0 bytes, which accounts for at most "
        "1048576; --trust-sizes believes it"},
       {":~~?}????\n",
        "f:1:1: 1040187392 vertices claimed by a graph of 0 bytes, which accounts for at most "
        "1048576; --trust-sizes believes it"},
       {"~~??B????\n",
        "f:1:9: 786432 vertices take 51539542016 characters after the size, found 1"}});
}

TEST(Sparse6, RefusesWithPlaceAndValue) {
  expect_refusals(
      {{":Fa@x\\\n", "f:1:6: wrong padding behind the last edge"},
       {":Fa@x^~\n", "f:1:6: wrong padding behind the last edge"},
       {":Fa@x\n", "f:1:5: wrong padding behind the last edge"},
       {":Fa@\x7f^\n", "f:1:5: character '\\x7f' is not one of graph6 and sparse6 ('?' to '~')"},
       {":A~\n", "f:1:3: edge (1, 1) is a loop"},
       {":Ab\n", "f:1: edge 1 (0, 1) is parallel to an earlier edge"},
       {":\n", "f:1:2: the line ends too early"},
       {";\n", "f:1:1: an incremental line without a graph before it"},
       {":An\n;b\n", "f:2: edge (0, 1) is changed twice"}});
}

TEST(Graph6, RefusesToWriteGigabytes) {
  EXPECT_THROW(written({Graph(1u << 18, {})}, find_graph_format("graph6")), InputError);
}

}  // namespace
}  // namespace ar3d::testing
