// Exports and figures through the programs that they are for.
#include "support/program.h"

namespace ar3d::testing {
namespace {

// LaTeX typesets what `ar3d draw -o x.tikz` writes.

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

// ParaView renders what `ar3d draw -o x.vtp` writes.

constexpr const char* kRender = R"(
import sys
from paraview.simple import *
reader = XMLPolyDataReader(FileName=[sys.argv[1]])
reader.UpdatePipeline()
info = reader.GetDataInformation()
print("points", info.GetNumberOfPoints(), "cells", info.GetNumberOfCells())
view = CreateView("RenderView")
view.ViewSize = [320, 240]
shown = Show(reader, view)
ColorBy(shown, ("CELLS", "role"))
ResetCamera(view)
SaveScreenshot(sys.argv[2], view)
)";

TEST(ParaView, RendersADrawing) {
  const ScratchDirectory scratch;
  const std::string script = scratch.write("render.py", kRender);
  const Outcome outcome =
      expect_exit(0, run("{} generate random-4-regular -n 30 | {} draw - --algorithm diamond -o " +
                         scratch.path("d.vtp") + " && xvfb-run -a pvpython " + script + " " +
                         scratch.path("d.vtp") + " " + scratch.path("d.png")));
  // 30 vertices and 3 bends on each of 60 edges; a cell for each vertex and each edge.
  EXPECT_THAT(outcome.out, HasSubstr("points 210 cells 90"));
  EXPECT_GT(fs::file_size(scratch.path("d.png")), 3000u) << "not one colour only";
}

TEST(Figures, PgfIsWhatLatexReads) {
  const ScratchDirectory scratch;
  const std::string results = scratch.path("smoke.h5"), figures = scratch.path("figures");
  must("{} study run smoke -q -o " + results);
  must("{} figures " + results + " -o " + figures + " --quantity volume --format pgf");
  scratch.write(
      "page.tex",
      "\\documentclass{article}\\usepackage{pgf}\\begin{document}\\input{figures/volume.pgf}"
      "\\end{document}\n");
  expect_exit(0, run("cd " + scratch.path("") +
                     " && pdflatex -halt-on-error -interaction=nonstopmode page.tex"));
  EXPECT_THAT(read_file(scratch.path("page.pdf")), StartsWith("%PDF-"));
}

}  // namespace
}  // namespace ar3d::testing
