// GML, DOT, lists of names and marks of bytes: what is read, with which names, and what is refused.
#include "formats/format_helpers.h"
#include "support/graphs.h"

namespace ar3d::testing {
namespace {

struct NamedRead {
  Graph graph;
  std::vector<std::string> names;
};

NamedRead read_named(const std::string& text, const ReadOptions& options = {}) {
  GraphReader reader(TextInput("f", bytes_of(text)), options);
  const std::optional<Graph> graph = reader.next();
  return {*graph, reader.names()};
}

std::string corpus_text(const std::string& name) {
  return read_file(AR3D_SOURCE_DIR "/tests/formats/corpus/" + name);
}

TEST(Gml, ReadsNodesInTheirOrderWithLabels) {
  const std::vector<Graph> graphs = read_text(corpus_text("gml/attributes.gml"));
  ASSERT_EQ(graphs.size(), 2u);
  EXPECT_EQ(edge_set(graphs[0]), edge_set(Graph(2, {{0, 1}})));
  EXPECT_THAT(read_named(corpus_text("gml/attributes.gml")).names, ElementsAre("seven", "-2"));
  EXPECT_THAT(read_named("graph [ node [ id 0 ] node [ id 1 label \"1\" ] ]").names, ElementsAre())
      << "numbers are no names";
  EXPECT_EQ(
      edge_set(
          read_named("graph\n[\nedge [ source 1 target 5 ] node [ id 5 ] node [ id 1 ] ]").graph),
      edge_set(Graph(2, {{0, 1}})))
      << "nodes may stand behind their edges";
}

TEST(Gml, NestingCostsNoStack) {
  EXPECT_EQ(refusal("x " + std::string(300000, '['), {.format = "gml"}),
            "f:1:300003: a [ is never closed");
}

TEST(Dot, ReadsChainsSubgraphsPortsAndAttributes) {
  const NamedRead read = read_named(corpus_text("dot/attributes.gv"));
  EXPECT_EQ(edge_set(read.graph), edge_set(Graph(7, {{0, 1}, {1, 2}, {1, 3}, {1, 4}})));
  EXPECT_THAT(read.names, ElementsAre("a", "b", "c", "d", "e", "a <b>b</b>", "two words"));
  EXPECT_EQ(read_text(corpus_text("dot/attributes.gv")).size(), 2u);
  EXPECT_EQ(edge_set(read_named("GRAPH{a--b--c--a}").graph), edge_set(cycle(3)));
}

TEST(Dot, AFewBytesClaimNoGigabytes) {
  EXPECT_THAT(refusal("graph " + std::string(300000, '{')), HasSubstr("more than 200 subgraphs"));
  std::string many = "graph { {";
  for (int v = 0; v < 3000; ++v) many += fmt::format("{} ", v);
  EXPECT_THAT(refusal(many + "} -- {" + many.substr(9) + "} }"),
              HasSubstr("9000000 edges claimed by "));
}

TEST(ListsOfNames, GiveTheirVerticesNames) {
  const std::string text = "# friends\nalice bob\nbob 7 {'weight': 2}\n7 alice 0.5\n";
  const NamedRead read = read_named(text, {.format = "edgelist"});
  EXPECT_EQ(edge_set(read.graph), edge_set(cycle(3)));
  EXPECT_THAT(read.names, ElementsAre("alice", "bob", "7"));
  const NamedRead rows = read_named("alice bob carol\nbob carol\ncarol\n", {.format = "adjlist"});
  EXPECT_EQ(edge_set(rows.graph), edge_set(cycle(3)));
  EXPECT_THAT(rows.names, ElementsAre("alice", "bob", "carol"));
  const ScratchDirectory folder = ScratchDirectory::in_memory();
  for (const char* name : {"a.edges", "a.ncol"}) {
    folder.write(name, text.substr(name == std::string("a.ncol") ? text.find('\n') + 1 : 0));
    EXPECT_EQ(read_graph(folder.path(name)).num_vertices(), 3u) << name;
  }
  EXPECT_EQ(refusal(text),
            "f:2: this is no graph format known here: 'alice bob'; --from says which one is meant")
      << "only where an option says that it is an edge list";
  expect_refusals(
      {
          {"a b\nc\n", "f:2: expected two ends of an edge, found the end of the line"},
          {"a c\nc c\n", "f:2: edge ('c', 'c') is a loop"},
          {"a b\nb a\n", "f:2: edge ('b', 'a') is parallel to an earlier edge"},
          {"a b c\n", "f:1:5: unexpected 'c' after the edge"},
      },
      {.format = "edgelist"});
}

TEST(NetworkxAdjacencyLists, AreKnownByTheirHead) {
  const std::string head = "#write.py\n# GMT Mon Nov 23 05:03:29 2026\n# \n";
  EXPECT_EQ(edge_set(read_named(head + "0 1 2\n1 2\n2\n").graph), edge_set(cycle(3)));
  EXPECT_EQ(refusal(head + "0 1\n1 {}\n1 0\n"),
            "f:5:3: '{}' is attributes, no end of an edge (in quotes it is a name)")
      << "those of several lines a vertex are others";
}

TEST(EdgeLists, ALonePairOfZerosIsALoop) {
  EXPECT_EQ(refusal("0 0\n"), "f:1:3: edge (0, 0) is a loop");
  EXPECT_EQ(read_text("0 0\n", {.first_line = FirstLine::header}).at(0).num_vertices(), 0u);
  EXPECT_EQ(read_text("0 0\n", {.simplify = true}).at(0).num_vertices(), 1u);
}

TEST(Marks, AreReadInEveryFormatOfText) {
  for (const char* text :
       {"0 1\n1 2\n", "graph { 0 -- 1 -- 2 }\n", "Bg\n", ":Bc\n",
        "<graphml><graph edgedefault=\"undirected\"><node id=\"a\"/></graph></graphml>\n"}) {
    const Graph plain = read_text(text).at(0);
    EXPECT_EQ(edge_set(read_text("\xef\xbb\xbf" + std::string(text)).at(0)), edge_set(plain));
    for (const bool is_little : {true, false}) {
      std::string wide = is_little ? "\xff\xfe" : "\xfe\xff";
      for (const char* c = text; *c != 0; ++c) {
        wide += is_little ? std::string{*c, '\0'} : std::string{'\0', *c};
      }
      EXPECT_EQ(edge_set(read_text(wide).at(0)), edge_set(plain)) << text << is_little;
      EXPECT_EQ(refusal(wide + "x"), "f: the text is no UTF-16, as its first bytes say");
    }
  }
  EXPECT_EQ(refusal("\xef\xbb\xbf"), "f: empty file: no graph in it");
}

TEST(Graphml, HasTheNamesOfItsIdsOrLabels) {
  const std::string head =
      "<graphml><key id=\"k\" for=\"node\" attr.name=\"label\"/>"
      "<graph edgedefault=\"undirected\">";
  EXPECT_THAT(read_named(head + "<node id=\"a\"/><node id=\"b\"><data key=\"k\">B &amp; C</data>"
                                "</node></graph></graphml>")
                  .names,
              ElementsAre("a", "B & C"));
  EXPECT_THAT(read_named(head + "<node id=\"n0\"/><node id=\"n1\"/></graph></graphml>").names,
              ElementsAre());
}

}  // namespace
}  // namespace ar3d::testing
