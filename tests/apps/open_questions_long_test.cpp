// What docs/open-questions.md says that longer computations say.
#include <gtest/gtest.h>

#include <string>

#include "support/program.h"

namespace ar3d {
namespace {

using testing::run;

std::string answer(const std::string& graph6, const std::string& options) {
  const testing::ScratchDirectory scratch;
  const std::string formula = scratch.path("formula.smt2");
  run("/usr/bin/python3 " AR3D_SOURCE_DIR "/examples/open_questions/lattice_model.py '" + graph6 +
      "' " + options + " > " + formula);
  return run("z3 " + formula).out;
}

TEST(OpenQuestions, K5HasNoLatticeDrawingByTheSecondFormula) {
  EXPECT_EQ(answer("D~{", "--formula lengths"), "unsat\n");
}

TEST(OpenQuestions, TheComplementOfTheSevenCycleHasNoLatticeDrawing) {
  EXPECT_EQ(answer("FUzro", ""), "unsat\n");
}

TEST(OpenQuestions, OneGraphOfEightVerticesHasALatticeDrawingByBothFormulas) {
  EXPECT_EQ(answer("G?~vf_", ""), "sat\n");
  EXPECT_EQ(answer("G?~vf_", "--formula lengths"), "sat\n");
}

}  // namespace
}  // namespace ar3d
