#include "formats/format_helpers.h"
#include "formats/packing_helpers.h"
#include "support/graphs.h"

// Every format of the catalogue gives back every graph it wrote: one alone and many in one file,
// detected by content and forced, 0- and 1-based.

namespace ar3d::testing {
namespace {

std::vector<Graph> samples() {
  std::vector<Graph> graphs = {
      Graph(0, {}),
      Graph(1, {}),
      Graph(5, {}),
      path(2),
      Graph(4, {{0, 1}}),  // isolated vertices at the end
      Graph(4, {{2, 3}}),  // and at the beginning
      disjoint_union({Graph(1, {}), cycle(3), Graph(2, {}), path(4), Graph(1, {})}),
      cycle(4),
      complete(5),
      petersen(),
      octahedron(),
      disjoint_union({complete(4), complete(4), Graph(60, {})}),
      path(300),
  };
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    graphs.push_back(shuffled(disjoint_union({petersen(), path(5), Graph(3, {})}), seed));
  }
  for (Vertex n = 1; n <= 20; ++n) graphs.push_back(path(n));  // all paddings of the 6-bit formats
  return graphs;
}

class RoundTrip : public ::testing::TestWithParam<std::string> {
 protected:
  const GraphFormat& format() const { return find_graph_format(GetParam()); }
};

TEST_P(RoundTrip, OneGraphDetected) {
  for (const Graph& graph : samples()) {
    const std::string text = written({graph}, format());
    const std::vector<Graph> back = read_text(text);
    ASSERT_EQ(back.size(), 1u) << text;
    EXPECT_EQ(edge_set(back[0]), edge_set(graph)) << text;
  }
}

TEST_P(RoundTrip, ManyGraphsForcedAndDetected) {
  const std::vector<Graph> graphs = samples();
  for (const std::string& told : {GetParam(), std::string()}) {
    const std::vector<Graph> back = read_text(written(graphs, format()), {.format = told});
    ASSERT_EQ(back.size(), graphs.size());
    for (std::size_t i = 0; i < graphs.size(); ++i) {
      EXPECT_EQ(edge_set(back[i]), edge_set(graphs[i])) << "graph " << i;
    }
  }
}

TEST_P(RoundTrip, PackedAndInSeveralMembers) {
  const std::vector<Graph> graphs = samples();
  const std::string text = written(graphs, format());
  const std::string first = text.substr(0, text.size() / 2);  // a member may end within a graph
  const std::string second = text.substr(text.size() / 2);
  for (const std::string& bytes :
       {gzip(text), gzip(first) + gzip(second), xz(text), xz(first) + xz(second)}) {
    const ScratchDirectory folder = ScratchDirectory::in_memory();
    folder.write("packed", bytes);
    GraphReader reader(folder.path("packed"));
    for (const Graph& graph : graphs) {
      const std::optional<Graph> back = reader.next();
      ASSERT_TRUE(back.has_value()) << reader.where();
      EXPECT_EQ(edge_set(*back), edge_set(graph)) << reader.where();
    }
    EXPECT_FALSE(reader.next());
  }
}

TEST_P(RoundTrip, OneBased) {
  const Graph graph = disjoint_union({cycle(3), Graph(2, {})});
  const std::string text = written({graph}, format(), 1);
  const std::vector<Graph> back = read_text(text, {.base = 1});
  ASSERT_EQ(back.size(), 1u);
  EXPECT_EQ(edge_set(back[0]), edge_set(graph));
}

TEST_P(RoundTrip, WindowsLineEnds) {
  const std::string text = written({petersen(), Graph(3, {{0, 1}})}, format());
  std::string windows;
  for (const char c : text) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  const std::vector<Graph> back = read_text(windows);
  ASSERT_EQ(back.size(), 2u);
  EXPECT_EQ(edge_set(back[0]), edge_set(petersen()));
}

TEST_P(RoundTrip, EveryCutIsAnErrorOrShorter) {
  const std::vector<Graph> graphs = {petersen(), cycle(5)};
  const std::string text = written(graphs, format());
  for (std::size_t length = 0; length < text.size(); ++length) {
    try {
      EXPECT_LE(read_text(text.substr(0, length)).size(), graphs.size());
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
  }
}

std::vector<std::string> names() {
  std::vector<std::string> names;
  for (const GraphFormat& format : graph_formats()) names.push_back(format.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Formats, RoundTrip, ::testing::ValuesIn(names()),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace ar3d::testing
