#include <cstdio>

#include "formats/format_helpers.h"
#include "support/graphs.h"

namespace ar3d::testing {
namespace {

/// What a shell command prints.
std::string output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string text;
  char block[4096];
  for (std::size_t got = 1; got > 0;) {
    got = std::fread(block, 1, sizeof block, pipe.get());
    text.append(block, got);
  }
  return text;
}

TEST(Graph6, ReadsTheExampleOfItsDescription) {
  const std::vector<Graph> graphs = read_text("DQc\n");
  ASSERT_EQ(graphs.size(), 1u);
  EXPECT_EQ(edge_set(graphs[0]), edge_set(Graph(5, {{0, 2}, {0, 4}, {1, 3}, {3, 4}})));
}

TEST(Sparse6, ReadsTheExampleOfItsDescription) {
  const std::vector<Graph> graphs = read_text(":Fa@x^\n");
  ASSERT_EQ(graphs.size(), 1u);
  EXPECT_EQ(edge_set(graphs[0]), edge_set(Graph(7, {{0, 1}, {0, 2}, {1, 2}, {5, 6}})));
}

TEST(NautyLines, AgreeWithNautyByteForByte) {
  const std::string graph6 = output_of("nauty-geng -q 6");
  const std::string sparse6 = output_of("nauty-geng -q 6 | nauty-copyg -q -s");
  const std::vector<Graph> graphs = geng("6");
  ASSERT_EQ(graphs.size(), 156u);
  EXPECT_EQ(written(graphs, find_graph_format("graph6")), graph6);
  EXPECT_EQ(written(graphs, find_graph_format("sparse6")), sparse6);
  for (const std::string& text :
       {graph6, sparse6, ">>graph6<<" + graph6, ">>sparse6<<" + sparse6}) {
    const std::vector<Graph> back = read_text(text);
    ASSERT_EQ(back.size(), graphs.size());
    for (std::size_t i = 0; i < back.size(); ++i) EXPECT_EQ(edge_set(back[i]), edge_set(graphs[i]));
  }
}

TEST(NautyLines, AgreeWithNautyOnEveryPaddingOfPowersOfTwo) {
  for (const char* n : {"1", "2", "3", "4", "5", "7", "8"}) {
    const std::string size = n;
    const std::string range = size == "8" ? " 0:9" : "";  // 12346 graphs are more than needed
    const std::string sparse6 = output_of("nauty-geng -q " + size + range + " | nauty-copyg -q -s");
    EXPECT_EQ(written(geng(size + range), find_graph_format("sparse6")), sparse6);
    EXPECT_EQ(written(read_text(sparse6), find_graph_format("sparse6")), sparse6);
  }
}

TEST(IncrementalSparse6, AgreesWithNautyByteForByte) {
  const std::vector<Graph> graphs = geng("6");
  const std::string lines = output_of("nauty-geng -q 6 | nauty-copyg -q -i");
  EXPECT_EQ(written(graphs, find_graph_format("isparse6")), lines);
  const std::vector<Graph> back = read_text(lines);
  ASSERT_EQ(back.size(), graphs.size());
  for (std::size_t i = 0; i < back.size(); ++i) EXPECT_EQ(edge_set(back[i]), edge_set(graphs[i]));
}

TEST(IncrementalSparse6, FollowsAnyKindOfLine) {
  const std::string two = written({Graph(5, {{0, 2}, {0, 4}, {1, 3}, {3, 4}}), Graph(5, {{0, 2}})},
                                  find_graph_format("isparse6"));
  const std::vector<Graph> graphs = read_text("DQc\n" + two.substr(two.find(';')));
  ASSERT_EQ(graphs.size(), 2u);
  EXPECT_EQ(edge_set(graphs[1]), edge_set(Graph(5, {{0, 2}})));
}

TEST(IncrementalSparse6, Refuses) {
  EXPECT_EQ(refusal(";\n"), "f:1:1: an incremental line without a graph before it");
  EXPECT_EQ(refusal(":An\n;b\n"), "f:2: edge (0, 1) is changed twice");
}

TEST(NautyLines, MixAndSkipBlankLines) {
  EXPECT_EQ(read_text("DQc\n\n:Fa@x^\n?\n").size(), 3u);
  EXPECT_EQ(read_text("?\n")[0].num_vertices(), 0u);
  EXPECT_EQ(read_text("DQc").size(), 1u);  // no newline at the end
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
  EXPECT_EQ(refusal("DQc\nDQ\n"), "f:2:2: 5 vertices take 2 characters after the size, found 1");
  EXPECT_EQ(refusal("DQcc\n"), "f:1:2: 5 vertices take 2 characters after the size, found 3");
  EXPECT_EQ(refusal("DQ\x80\n"),
            "f:1:3: character '\\x80' is not one of graph6 and sparse6 ('?' to '~')");
  EXPECT_EQ(refusal("DQc\nD c\n"),
            "f:2:2: character ' ' is not one of graph6 and sparse6 ('?' to '~')");
  EXPECT_EQ(refusal("DQ~\n"), "f:1:3: the padding bits are not zero");
  EXPECT_EQ(refusal("~?\n"), "f:1:3: the line ends too early");
  EXPECT_EQ(refusal("&DQc\n"),
            "f:1:1: this is digraph6: only undirected graphs are read (--undirected drops "
            "directions)");
  EXPECT_EQ(refusal(">>planar_code<<\n"),
            "f:1:1: unknown header '>>planar_code<<', expected '>>graph6<<' or '>>sparse6<<'");
}

TEST(Graph6, RefusesAbsurdSizesWithoutAllocating) {
  EXPECT_EQ(refusal("~~~~~~~~\n"),
            "f:1:1: 68719476735 vertices are too many, the limit is 4294967294");
  EXPECT_EQ(refusal("~~?}????\n"),
            "f:1:1: 1040187392 vertices claimed by a graph of 0 bytes, which accounts for at most "
            "1048576; --trust-sizes believes it");
  EXPECT_EQ(refusal(":~~?}????\n"),
            "f:1:1: 1040187392 vertices claimed by a graph of 0 bytes, which accounts for at most "
            "1048576; --trust-sizes believes it");
  EXPECT_EQ(refusal("~~??B????\n"),
            "f:1:9: 786432 vertices take 51539542016 characters after the size, found 1");
}

TEST(Sparse6, RefusesWithPlaceAndValue) {
  EXPECT_EQ(refusal(":Fa@x\\\n"), "f:1:6: wrong padding behind the last edge");
  EXPECT_EQ(refusal(":Fa@x^~\n"), "f:1:6: wrong padding behind the last edge");
  EXPECT_EQ(refusal(":Fa@x\n"), "f:1:5: wrong padding behind the last edge");
  EXPECT_EQ(refusal(":Fa@\x7f^\n"),
            "f:1:5: character '\\x7f' is not one of graph6 and sparse6 ('?' to '~')");
  EXPECT_EQ(refusal(":A~\n"), "f:1:3: edge (1, 1) is a loop");
  EXPECT_EQ(refusal(":Ab\n"), "f:1: edge 1 (0, 1) is parallel to an earlier edge");
  EXPECT_EQ(refusal(":\n"), "f:1:2: the line ends too early");
}

TEST(Graph6, RefusesToWriteGigabytes) {
  EXPECT_THROW(written({Graph(1u << 18, {})}, find_graph_format("graph6")), InputError);
}

}  // namespace
}  // namespace ar3d::testing
