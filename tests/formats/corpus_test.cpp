#include <variant>

#include "ar3d/formats/drawings/drawing_jsonl.h"
#include "formats/format_helpers.h"

// The seeds of the fuzz targets, and every input that once went wrong, replayed without a fuzzer:
// each is refused with one line or read; the graphs read come back from every format's writer.

namespace ar3d::testing {
namespace {

const fs::path kCorpus = fs::path(AR3D_SOURCE_DIR) / "tests/formats/corpus";

std::vector<Graph> graphs_of(const fs::path& path, const std::string& format) {
  GraphReader reader(path.string(), {.format = format});
  std::vector<Graph> graphs;
  while (std::optional<Graph> graph = reader.next()) graphs.push_back(std::move(*graph));
  return graphs;
}

TEST(Corpus, EveryGraphFileIsReadOrRefusedWithOneLine) {
  int files = 0;
  int graphs = 0;
  for (const GraphFormat& format : graph_formats()) {
    for (const auto& entry : fs::directory_iterator(kCorpus / format.name)) {
      ++files;
      try {
        for (const Graph& graph : graphs_of(entry.path(), format.name)) {
          ++graphs;
          const auto back = read_text(written({graph}, format), {.format = format.name});
          ASSERT_EQ(back.size(), 1u) << entry.path();
          EXPECT_EQ(edge_set(back[0]), edge_set(graph)) << entry.path();
        }
      } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << entry.path();
        EXPECT_EQ(std::string(error.what()).find(entry.path().string()), 0u) << error.what();
      }
    }
  }
  EXPECT_GE(files, 18);
  EXPECT_GE(graphs, 25);
}

TEST(Corpus, EveryDrawingFileIsReadOrRefusedWithOneLine) {
  int drawings = 0;
  for (const auto& entry : fs::directory_iterator(kCorpus / "drawing")) {
    try {
      DrawingJsonlReader reader(entry.path().string());
      while (const auto line = reader.next())
        drawings += std::holds_alternative<Drawing>(*line) ? 1 : 0;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << entry.path();
    }
  }
  EXPECT_GE(drawings, 1);
}

}  // namespace
}  // namespace ar3d::testing
