// LaTeX typesets what `ar3d draw -o x.tikz` writes.
#include "support/program.h"

namespace ar3d::testing {
namespace {

TEST(Export, TikzIsTypeset) {
  const ScratchDirectory scratch;
  scratch.write("page.tex",
                "\\documentclass{article}\\usepackage{tikz}\\begin{document}\\input{k5.tikz}"
                "\\end{document}\n");
  expect_exit(0, run("cd " + scratch.path("") +
                     " && printf 'D~{\\n' | {} draw - --algorithm diamond -o k5.tikz && "
                     "pdflatex -interaction=batchmode -halt-on-error page.tex"));
  EXPECT_GT(fs::file_size(scratch.path("page.pdf")), 5000u);
}

}  // namespace
}  // namespace ar3d::testing
