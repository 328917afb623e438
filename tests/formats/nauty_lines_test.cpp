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

TEST(NautyLines, EveryFirstCharacterIsReadWithoutASuffix) {
  for (Vertex n = 0; n <= 70; ++n) {  // 28 vertices begin with '[', 60 with '{', as JSON does
    std::vector<Edge> edges;
    for (Vertex v = 1; v < n; ++v) edges.push_back({v - 1, v});
    for (const Graph& graph : {Graph(n, edges), Graph(n, {})}) {
      for (const char* format : {"graph6", "sparse6"}) {
        const std::string line = written({graph}, find_graph_format(format));
        const std::vector<Graph> back = read_text(line);
        ASSERT_EQ(back.size(), 1u) << line;
        EXPECT_EQ(back[0].num_vertices(), n);
        EXPECT_EQ(edge_set(back[0]), edge_set(graph));
      }
    }
  }
}

TEST(NautyLines, AnUnfinishedLineIsNoJson) {
  EXPECT_THAT(refusal("[" + std::string(40, '?') + "\n"), HasSubstr("28 vertices take"));
  EXPECT_THAT(refusal("[true]\n"), HasSubstr("JSON"));
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

TEST(Graph6, RefusesToWriteGigabytes) {
  EXPECT_THROW(written({Graph(1u << 18, {})}, find_graph_format("graph6")), InputError);
}

}  // namespace
}  // namespace ar3d::testing
