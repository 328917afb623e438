// LaTeX typesets what `ar3d draw -o x.tikz` writes.
#include <gtest/gtest.h>

#include <filesystem>

#include "support/program.h"

namespace ar3d::testing {
namespace {

TEST(Export, TikzIsTypeset) {
  const ScratchDirectory scratch;
  scratch.write("page.tex",
                "\\documentclass{article}\\usepackage{tikz}\\begin{document}\\input{k5.tikz}"
                "\\end{document}\n");
  const Outcome outcome = run("cd " + scratch.path("") +
                              " && printf 'D~{\\n' | {} draw - --algorithm diamond -o k5.tikz && "
                              "pdflatex -interaction=batchmode -halt-on-error page.tex");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << testing::read_file(scratch.path("page.log"));
  EXPECT_GT(std::filesystem::file_size(scratch.path("page.pdf")), 5000u);
}

}  // namespace
}  // namespace ar3d::testing
