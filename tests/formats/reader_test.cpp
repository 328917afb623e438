#include "formats/format_helpers.h"
#include "formats/packing_helpers.h"
#include "support/graphs.h"

// Files, packing and detection: what GraphReader does before any format.

namespace ar3d::testing {
namespace {

std::string file_refusal(const std::string& path) {
  return problem(
      [&] {
        GraphReader reader(path);
        while (reader.next()) {
        }
      },
      "accepted");
}

TEST(GraphReader, SaysWhatItReadsAndWhere) {
  const ScratchDirectory folder = ScratchDirectory::in_memory();
  GraphReader reader(folder.write("graphs", gzip("DQc\n") + gzip("DQc\n")));
  EXPECT_EQ(reader.format().name, "graph6");
  EXPECT_TRUE(reader.next() && reader.next() && !reader.next());
  EXPECT_EQ(reader.where(), folder.path("graphs") + ":2");
}

TEST(GraphReader, RefusesFilesThatCannotBeRead) {
  const ScratchDirectory folder = ScratchDirectory::in_memory();
  EXPECT_EQ(file_refusal(folder.path("none.g6")),
            "cannot read " + folder.path("none.g6") + ": No such file or directory");
  EXPECT_EQ(file_refusal(folder.path("")), "cannot read " + folder.path("") + ": Is a directory");
  folder.write("empty", "");
  EXPECT_EQ(file_refusal(folder.path("empty")),
            folder.path("empty") + ": empty file: no graph in it");
}

TEST(GraphReader, RefusesCutAndCorruptPacking) {
  const ScratchDirectory folder = ScratchDirectory::in_memory();
  const std::string text = written({path(200)}, find_graph_format("sparse6"));
  const auto refused = [&](const std::string& bytes) {
    folder.write("f", bytes);
    return file_refusal(folder.path("f")).substr(folder.path("f").size());
  };
  const std::string packed = gzip(text);
  EXPECT_EQ(refused(packed.substr(0, packed.size() - 9)), ": the gzip data end too early");
  EXPECT_EQ(refused(packed + "rubbish"), ": corrupt gzip data (incorrect header check)");
  std::string broken = packed;
  broken[broken.size() - 6] = static_cast<char>(broken[broken.size() - 6] ^ 1);
  EXPECT_EQ(refused(broken), ": corrupt gzip data (incorrect data check)");
  const std::string xz_packed = xz(text);
  EXPECT_EQ(refused(xz_packed.substr(0, xz_packed.size() - 9)), ": the xz data end too early");
  broken = xz_packed;
  broken[30] = static_cast<char>(broken[30] ^ 1);
  EXPECT_EQ(refused(broken).substr(0, 17), ": corrupt xz data");
}

TEST(GraphReader, FormatCanBeForced) {
  EXPECT_EQ(refusal("0 1\n", {.format = "graph6"}),
            "f:1:1: character '0' is not one of graph6 and sparse6 ('?' to '~')");
  EXPECT_EQ(refusal("DQc\n", {.format = "edgelist"}),
            "f:1: expected two ends of an edge, found the end of the line");
  EXPECT_EQ(refusal("", {.format = "edgelist"}), "f: empty file: no graph in it");
  EXPECT_NE(
      refusal("DQc\n", {.format = "gif"}).find("unknown graph format 'gif', known: matrixmarket"),
      std::string::npos);
}

TEST(GraphReader, LinesLongerThanABlock) {
  const Graph big = path(400000);  // one sparse6 line of about 1.4 MB
  const std::string line = written({big}, find_graph_format("sparse6"));
  const std::vector<Graph> graphs = read_text("DQc\n" + line + line + "DQc\n");
  ASSERT_EQ(graphs.size(), 4u);
  EXPECT_EQ(edge_set(graphs[1]), edge_set(big));
  EXPECT_EQ(edge_set(graphs[2]), edge_set(big));
  EXPECT_EQ(graphs[3].num_vertices(), 5u);
}

TEST(GraphReader, ReadsOneGraph) {
  const ScratchDirectory folder = ScratchDirectory::in_memory();
  folder.write("one", "DQc\n");
  folder.write("two", "DQc\nDQc\n");
  EXPECT_EQ(read_graph(folder.path("one")).num_edges(), 4u);
  EXPECT_THROW(read_graph(folder.path("two")), InputError);
}

TEST(GraphFormats, AreFoundByNameAndPath) {
  EXPECT_EQ(graph_format_of_path("a/b.s6.gz")->name, "sparse6");
  EXPECT_EQ(graph_format_of_path("b.g6.xz")->name, "graph6");
  EXPECT_EQ(graph_format_of_path("b.unknown"), nullptr);
  EXPECT_THROW(find_graph_format("g7"), InputError);
}

}  // namespace
}  // namespace ar3d::testing
