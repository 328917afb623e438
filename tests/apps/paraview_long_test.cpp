// ParaView renders what `ar3d draw -o x.vtp` writes.
#include "support/program.h"

namespace ar3d::testing {
namespace {

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

}  // namespace
}  // namespace ar3d::testing
