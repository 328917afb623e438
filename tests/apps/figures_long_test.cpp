// The scripts beside the figures of `ar3d report --figures` draw them again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "support/program.h"

namespace ar3d::testing {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

TEST(Figures, AreDrawnAgainByTheirScripts) {
  const testing::ScratchDirectory scratch;
  const std::string results = scratch.path("smoke.h5"), figures = scratch.path("figures");
  ASSERT_EQ(run("{} study run smoke -q -o " + results).exit_code, 0);
  ASSERT_EQ(run("{} report " + results + " --figures " + figures).exit_code, 0);
  std::size_t drawn = 0;
  for (const auto& entry : fs::directory_iterator(figures)) {
    const std::string stem = figures + "/" + entry.path().stem().string();
    if (entry.path().extension() != ".py") continue;
    ++drawn;
    fs::remove(stem + ".pdf");  // that of the SVG
    const std::string in_folder = "cd " + figures + " && ";
    const Outcome matplotlib = run(in_folder + "/usr/bin/python3 " + stem + ".py");
    EXPECT_EQ(matplotlib.exit_code, 0) << stem << matplotlib.err;
    EXPECT_THAT(read_file(stem + ".pdf"), ::testing::StartsWith("%PDF-")) << stem;
    fs::remove(stem + ".pdf");
    const Outcome latex =
        run(in_folder + "pdflatex -halt-on-error -interaction=nonstopmode " + stem + ".tex");
    EXPECT_EQ(latex.exit_code, 0) << stem << latex.out;
    EXPECT_THAT(latex.out, ::testing::Not(HasSubstr("undefined"))) << stem;
    EXPECT_THAT(read_file(stem + ".pdf"), ::testing::StartsWith("%PDF-")) << stem;
  }
  EXPECT_GE(drawn, 10u);
}

}  // namespace
}  // namespace ar3d::testing
