// The scripts beside the figures of `ar3d report --figures` draw them again.
#include "support/program.h"

namespace ar3d::testing {
namespace {

TEST(Figures, AreDrawnAgainByTheirScripts) {
  const ScratchDirectory scratch;
  const std::string results = scratch.path("smoke.h5"), figures = scratch.path("figures");
  must("{} study run smoke -q -o " + results);
  must("{} report " + results + " --figures " + figures);
  std::size_t drawn = 0;
  for (const auto& entry : fs::directory_iterator(figures)) {
    const std::string stem = figures + "/" + entry.path().stem().string();
    if (entry.path().extension() != ".py") continue;
    ++drawn;
    fs::remove(stem + ".pdf");  // that of the SVG
    const std::string in_folder = "cd " + figures + " && ";
    expect_exit(0, run(in_folder + "/usr/bin/python3 " + stem + ".py"));
    EXPECT_THAT(read_file(stem + ".pdf"), StartsWith("%PDF-")) << stem;
    fs::remove(stem + ".pdf");
    const Outcome latex = expect_exit(
        0, run(in_folder + "pdflatex -halt-on-error -interaction=nonstopmode " + stem + ".tex"));
    EXPECT_THAT(latex.out, Not(HasSubstr("undefined"))) << stem;
    EXPECT_THAT(read_file(stem + ".pdf"), StartsWith("%PDF-")) << stem;
  }
  EXPECT_GE(drawn, 10u);
}

}  // namespace
}  // namespace ar3d::testing
