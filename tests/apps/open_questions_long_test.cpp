// What docs/open-questions.md says that longer computations say.
#include "support/program.h"

namespace ar3d::testing {
namespace {

const std::string kFolder = AR3D_SOURCE_DIR "/docs/open-questions/";

std::string answer(const std::string& graph6, const std::string& script,
                   const std::string& solver) {
  const ScratchDirectory scratch;
  const std::string formula = scratch.path("formula.smt2");
  run("/usr/bin/python3 " + kFolder + script + " '" + graph6 + "' > " + formula);
  return run(solver + " " + formula).out;
}

TEST(OpenQuestions, TheOctahedronHasNoLatticeDrawingByTheSecondFormula) {
  EXPECT_EQ(answer("E]~o", "lattice_lengths.py", "z3"), "unsat\n");  // 29 s of CPU time
}

TEST(OpenQuestions, ThreeGraphsHaveNoLatticeDrawingByASecondSolver) {
  for (const std::string graph : {"D~{", "E]~o", "FUzro"}) {
    EXPECT_EQ(answer(graph, "lattice_orders.py", "cvc5"), "unsat\n") << graph;
  }
}

TEST(OpenQuestions, TheComplementOfTheSevenCycleHasNoLatticeDrawing) {
  EXPECT_EQ(answer("FUzro", "lattice_orders.py", "z3"), "unsat\n");
}

TEST(OpenQuestions, OneGraphOfEightVerticesHasALatticeDrawingByBothFormulas) {
  EXPECT_EQ(answer("G?~vf_", "lattice_orders.py", "z3"), "sat\n");
  EXPECT_EQ(answer("G?~vf_", "lattice_lengths.py", "z3"), "sat\n");
}

TEST(OpenQuestions, TheSearchOfK5ReachesTheBendsStated) {
  const Outcome found = run("/usr/bin/python3 " + kFolder + "k5_one_bend.py 6 0.001");
  EXPECT_THAT(found.out, HasSubstr("66.67"));
}

// The page's table of arguments, all three.
TEST(OpenQuestions, TheSearchFindsTheCommittedDrawingsAgain) {
  const std::string page = read_file(AR3D_SOURCE_DIR "/docs/open-questions.md");
  std::string found;
  for (const std::string arguments : {"'D~{' 120 22 10 5000000 0.05", "'E]~o' 40 9 15 3000000 0.1",
                                      "FUzro 60 9 12 2000000 0.15"}) {
    EXPECT_THAT(page, HasSubstr("`" + arguments + "`"));
    found += run("/usr/bin/python3 " + kFolder + "small_drawings.py " + arguments).out;
  }
  EXPECT_EQ(found, read_file(kFolder + "small_drawings.jsonl"));
}

}  // namespace
}  // namespace ar3d::testing
