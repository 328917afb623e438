// Files that networkx and igraph have written (tests/formats/foreign/write_foreign_files.py): each
// is the graph that they wrote, or is refused in one clear line.
#include <map>
#include <set>

#include "formats/format_helpers.h"

namespace ar3d::testing {
namespace {

const fs::path kForeign = fs::path(AR3D_SOURCE_DIR) / "tests/formats/foreign";

std::string path_of(const std::string& name) { return (kForeign / name).string(); }

const std::vector<Edge> kPetersen = {{0, 1}, {0, 4}, {0, 5}, {1, 2}, {1, 6}, {2, 3}, {2, 7}, {3, 4},
                                     {3, 8}, {4, 9}, {5, 7}, {5, 8}, {6, 8}, {6, 9}, {7, 9}};

struct Written {
  std::vector<const char*> files;
  std::uint64_t n;
  std::vector<Edge> edges;
};

/// What is read as the graph that was written; a list of edges has no vertices alone.
std::vector<Written> graphs() {
  return {{{"networkx.g6",
            "networkx-no-header.g6",
            "networkx.s6",
            "networkx-attributes.edgelist",
            "networkx-plain.edgelist",
            "networkx-rich.edgelist",
            "networkx-weighted.edgelist",
            "networkx-commas.edgelist",
            "networkx.graphml",
            "networkx-rich.graphml",
            "networkx-utf16.graphml",
            "networkx-latin1.graphml",
            "networkx-prefixed.graphml",
            "igraph.edgelist",
            "igraph.graphml",
            "igraph-rich.graphml",
            "networkx.adjlist",
            "networkx.gml",
            "igraph.gml",
            "igraph.dot"},
           10,
           kPetersen},
          {{"networkx-lonely.s6", "networkx-lonely.graphml", "igraph-lonely.graphml"},
           4,
           {{0, 1}, {1, 2}}},
          {{"networkx-lonely.edgelist", "igraph-lonely.edgelist"}, 3, {{0, 1}, {1, 2}}}};
}

constexpr const char* kPajek =
    ":1: this is Pajek, which is not read; examples/convert.py makes GraphML of it: "
    "networkx.write_graphml(networkx.Graph(networkx.read_pajek(FILE)), OUTPUT)";

/// What is refused, and with which words behind the file's name.
const std::map<std::string, std::string> kRefused = {
    {"networkx-directed.graphml",
     ":9:3: edgedefault is 'directed': only undirected graphs are read (--undirected drops "
     "directions)"},
    {"igraph-directed.graphml",
     ":7:3: edgedefault is 'directed': only undirected graphs are read (--undirected drops "
     "directions)"},
    {"networkx-multiline.adjlist", ":5:3: '{}' is no name of a list of networkx"},
    {"networkx.gexf",
     ":1: this is GEXF, which is not read; examples/convert.py makes GraphML of it: "
     "networkx.write_graphml(networkx.Graph(networkx.read_gexf(FILE)), OUTPUT)"},
    {"networkx.net", kPajek},
    {"igraph.net", kPajek},
    {"igraph.lgr",
     ":1: this is LEDA, which is not read; networkx reads it: read_leda(FILE), then write_graphml"},
    {"igraph.lgl",
     ":1: this is LGL by its ending, which is not read; igraph reads it: "
     "Graph.Read_Lgl(FILE).write_graphml(OUTPUT)"},
    {"igraph-matrix.adjacency", ":1:5: unexpected '0' after the edge"},
    {"igraph.dimacs", ":2:3: only 'edge', 'col' and 'sp' are supported here, found 'max'"},
};

TEST(ForeignFiles, AreTheGraphsThatTheyHold) {
  for (const auto& [files, n, edges] : graphs()) {
    for (const char* file : files) {
      const Graph graph = read_graph(path_of(file));
      EXPECT_EQ(graph.num_vertices(), n) << file;
      EXPECT_TRUE(std::ranges::equal(graph.edges(), edges)) << file;
    }
  }
  GraphReader named(path_of("igraph.ncol"));
  named.next();
  GraphReader numbers(path_of("igraph-plain.ncol"));
  EXPECT_EQ(numbers.next()->num_edges(), 15u);
  EXPECT_THAT(numbers.names(), ElementsAre("0", "1", "4", "5", "2", "6", "3", "7", "8", "9"))
      << "igraph's ids are names even where they are numbers";
  EXPECT_THAT(named.names(),
              ElementsAre("v0", "v1", "v4", "v5", "v2", "v6", "v3", "v7", "v8", "v9"));
}

TEST(ForeignFiles, AreRefusedInOneClearLine) {
  for (const auto& [file, words] : kRefused) {
    const std::string path = path_of(file);  // clang 14 captures no structured binding
    EXPECT_EQ(problem([&] { read_graph(path); }), path + words) << file << " is read";
  }
}

TEST(ForeignFiles, AreAllLookedAt) {
  std::set<std::string> expected = {"igraph.ncol", "igraph-plain.ncol"};
  for (const Written& written : graphs())
    expected.insert(written.files.begin(), written.files.end());
  for (const auto& refused : kRefused) expected.insert(refused.first);
  std::set<std::string> found;
  for (const auto& entry : fs::directory_iterator(kForeign)) {
    if (entry.path().extension() != ".py") found.insert(entry.path().filename().string());
  }
  EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace ar3d::testing
