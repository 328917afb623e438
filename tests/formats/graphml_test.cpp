#include "formats/format_helpers.h"

namespace ar3d::testing {
namespace {

/// A document as networkx writes it, with attributes; one graph's content.
std::string document(const std::string& content) {
  return "<?xml version='1.0' encoding='utf-8'?>\n"
         "<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n"
         "<key id=\"d0\" for=\"edge\" attr.name=\"weight\" attr.type=\"double\"/>\n"
         "<!-- <graph> in a comment > -->\n"
         "<graph edgedefault=\"undirected\">\n" +
         content + "</graph>\n</graphml>\n";
}
constexpr const char* kNodes = "<node id=\"b\"/>\n<node id=\"a\"/>\n<node id=\"c\"/>\n";

TEST(Graphml, ReadsNodesInOrderAndAttributesOver) {
  const std::vector<Graph> graphs =
      read_text(document(std::string(kNodes) +
                         "<edge source=\"a\" target=\"c\"><data key=\"d0\">2.5</data></edge>\n"));
  ASSERT_EQ(graphs.size(), 1u);
  EXPECT_EQ(edge_set(graphs[0]), edge_set(Graph(3, {{1, 2}})));
}

TEST(Graphml, ReadsSeveralGraphsAndEmptyOnes) {
  const std::vector<Graph> graphs = read_text(
      "<graphml><graph edgedefault=\"undirected\"/>\n"
      "<graph edgedefault=\"undirected\"><node id=\"x>y\"/></graph></graphml>");
  ASSERT_EQ(graphs.size(), 2u);
  EXPECT_EQ(graphs[0].num_vertices(), 0u);
  EXPECT_EQ(graphs[1].num_vertices(), 1u);
}

TEST(Graphml, RefusesWithPlaceAndValue) {
  const std::string nodes = kNodes;
  EXPECT_THAT(refusal(document(nodes + "<edge source=\"a\" target=\"c\" directed=\"true\"/>\n")),
              StartsWith("f:9:1: directed edges"));
  EXPECT_THAT(refusal("<graphml>\n<graph edgedefault=\"undirected\">\n<node id="),
              StartsWith("f:3:"));
  EXPECT_THAT(refusal("<graphml>\n<graph><node id=\"a\"/></graph></graphml>"),
              StartsWith("f:2:1: edgedefault is ''"));
}

TEST(Graphml, DeepNestingIsNoTrouble) {
  std::string deep = "<graphml>\n";
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  EXPECT_THAT(refusal(deep), StartsWith("f:2:"));
}

// As libraries write it that name the namespace.
TEST(Graphml, ReadsPrefixedNamesAndEntities) {
  const Graph graph = read_text(
                          "<g:graphml xmlns:g=\"http://graphml.graphdrawing.org/xmlns\"><g:graph "
                          "edgedefault=\"undirected\"><g:node id=\"&#65;&amp;\"/><g:node id=\"b\"/>"
                          "<g:edge source=\"b\" target=\"A&amp;\"/></g:graph></g:graphml>")
                          .at(0);
  EXPECT_EQ(edge_set(graph), edge_set(Graph(2, {{0, 1}})));
}

TEST(Graphml, EntitiesOfTheDocumentAreNotExpanded) {
  std::string bomb = "<!DOCTYPE graphml [<!ENTITY a \"aaaaaaaaaa\">";
  for (char c = 'b'; c <= 'p'; ++c) {
    bomb += "<!ENTITY " + std::string(1, c) + " \"";
    for (int i = 0; i < 10; ++i) bomb += "&" + std::string(1, static_cast<char>(c - 1)) + ";";
    bomb += "\">";
  }
  bomb += "]><graphml><graph edgedefault=\"undirected\"><node id=\"&p;\"/></graph></graphml>";
  EXPECT_EQ(read_text(bomb).at(0).num_vertices(), 1u);
}

}  // namespace
}  // namespace ar3d::testing
