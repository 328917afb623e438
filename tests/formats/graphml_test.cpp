#include "ar3d/formats/graphs/graphml.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ar3d/formats/text/xml_tags.h"
#include "formats/format_helpers.h"

namespace ar3d {
namespace {

using testing::edge_set;
using ::testing::HasSubstr;
using testing::read_text;
using testing::refusal;
using ::testing::StartsWith;

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
  EXPECT_EQ(
      refusal(document(nodes +
                       "<edge source=\"a\" target=\"c\"/>\n  <edge source=\"b\" target=\"b\"/>\n")),
      "f:10:3: edge 1 (0, 0) is a loop");
  EXPECT_EQ(refusal(document(
                nodes + "<edge source=\"a\" target=\"c\"/><edge source=\"c\" target=\"a\"/>\n")),
            "f:9:30: edge 1 (2, 1) is parallel to an earlier edge");
  EXPECT_EQ(refusal(document(nodes + "<edge source=\"a\" target=\"nobody\"/>\n")),
            "f:9:1: target 'nobody' is no node of this graph");
  EXPECT_THAT(refusal(document(nodes + "<edge source=\"a\" target=\"c\" directed=\"true\"/>\n")),
              StartsWith("f:5: graph 1: "));
  EXPECT_THAT(refusal(document(nodes + "<edge source=\"a\"/>\n")), StartsWith("f:5: graph 1: "));
  EXPECT_EQ(refusal(document("<node id=\"a\"/><node id=\"a\"/>\n")),
            "f:6:15: node 'a' stands twice");
  EXPECT_EQ(refusal("<svg></svg>"), "f:1: no <graph> element inside a <graphml> element");
  EXPECT_EQ(refusal("<graphml>\n<graph edgedefault=\"undirected\">\n<node id="),
            "f:3: the text ends inside an element");
  EXPECT_THAT(refusal("<graphml>\n<graph><node id=\"a\"/></graph></graphml>"),
              StartsWith("f:2: graph 1: "));
}

TEST(Graphml, RefusesDeepNesting) {
  std::string deep = "<graphml>\n";
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  EXPECT_EQ(refusal(deep), "f:2: elements nested deeper than 100");
}

TEST(XmlTags, PassOverCommentsAndQuotes) {
  const std::string text =
      "<?xml?><!DOCTYPE x><!-- <a> --><b c='>' d=\"/>\"><![CDATA[<e>]]></b><f/> <g";
  XmlTags tags(text);
  std::string names;
  while (const auto tag = tags.next()) {
    names += std::string(tag->name) + static_cast<char>('0' + static_cast<int>(tag->kind)) + " ";
  }
  EXPECT_EQ(names, "b0 b1 f2 ");
  EXPECT_EQ(attribute_of("<b c='>' d = \"/>\">", "d"), "/>");
  EXPECT_EQ(attribute_of("<b c='>'>", "d"), std::nullopt);
}

}  // namespace
}  // namespace ar3d
