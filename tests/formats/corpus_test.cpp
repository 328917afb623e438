#include "formats/format_helpers.h"
#include "fuzz/checks.h"

// The seeds of the fuzz targets, and every input that once went wrong, replayed without a fuzzer:
// each is refused with one line or read; what is read comes back from its writer.

namespace ar3d::testing {
namespace {

TEST(Corpus, EveryFileIsReadOrRefusedWithOneLine) {
  std::size_t files = 0, graphs = 0;
  for (const auto& folder : fs::directory_iterator(AR3D_SOURCE_DIR "/tests/formats/corpus")) {
    const std::string format = folder.path().filename().string();
    for (const auto& file : fs::directory_iterator(folder)) {
      const std::string text = read_file(file.path().string());
      if (format == "drawing") {
        EXPECT_NO_THROW(fuzz::check_drawings(text)) << file.path();
        EXPECT_THAT(fuzz::rewritten(text), Not(IsEmpty()));
        continue;
      }
      EXPECT_NO_THROW(fuzz::check_graphs(format, text)) << file.path();
      ++files;
      if (refusal(text, {.format = format}) == "accepted") {
        graphs += read_text(text, {.format = format}).size();
      }
    }
  }
  EXPECT_GE(files, 18u);
  EXPECT_GE(graphs, 25u);
}

}  // namespace
}  // namespace ar3d::testing
