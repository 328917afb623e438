// What docs/open-questions.md says that computations say.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "support/program.h"

namespace ar3d {
namespace {

using ::testing::HasSubstr;
using testing::run;

const std::string kFolder = AR3D_SOURCE_DIR "/examples/open_questions/";

/// "sat" or "unsat": has the graph a drawing on the lattice?
std::string answer(const std::string& graph6, const std::string& options) {
  const testing::ScratchDirectory scratch;
  const std::string formula = scratch.path("formula.smt2");
  const auto made = run("/usr/bin/python3 " + kFolder + "lattice_model.py '" + graph6 + "' " +
                        options + " > " + formula);
  EXPECT_EQ(made.exit_code, 0) << made.err;
  std::string said = run("z3 " + formula).out;
  while (!said.empty() && said.back() == '\n') said.pop_back();
  return said;
}

const std::string kK5 = "D~{";
const std::string kOctahedron = "E]~o";
const std::string kDrawable = "FFzvO";  // the other one with 7 vertices

TEST(OpenQuestions, K5HasNoLatticeDrawingWithTwoBends) { EXPECT_EQ(answer(kK5, ""), "unsat"); }

TEST(OpenQuestions, K5HasNoLatticeDrawingWithOneBendByBothFormulas) {
  EXPECT_EQ(answer(kK5, "--bends 1 --formula orders"), "unsat");
  EXPECT_EQ(answer(kK5, "--bends 1 --formula lengths"), "unsat");
}

TEST(OpenQuestions, TheOctahedronHasNoLatticeDrawingWithTwoBends) {
  EXPECT_EQ(answer(kOctahedron, ""), "unsat");
}

TEST(OpenQuestions, OneGraphOfSevenVerticesHasALatticeDrawing) {
  EXPECT_EQ(answer(kDrawable, ""), "sat");
}

TEST(OpenQuestions, TheModelRefusesWhatIsNotFourRegular) {
  const auto made = run("/usr/bin/python3 " + kFolder + "lattice_model.py 'C~'");
  EXPECT_NE(made.exit_code, 0);
  EXPECT_THAT(made.err, HasSubstr("vertex 0 has not degree 4"));
}

TEST(OpenQuestions, K4HasADrawingWithOneBend) {
  const testing::ScratchDirectory scratch;
  const std::string file = scratch.path("k4.jsonl");
  run("/usr/bin/python3 " + kFolder + "k4_one_bend.py > " + file);
  const auto drawing = nlohmann::json::parse(run("head -1 " + file).out);
  EXPECT_EQ(drawing["edges"].size(), 6u);
  for (const auto& edge : drawing["edges"]) EXPECT_EQ(edge[2].size(), 1u) << "one bend";
  const auto verified = run("{} verify " + file + " --algorithm two-bend-109");
  EXPECT_EQ(verified.exit_code, 0) << verified.out << verified.err;
}

}  // namespace
}  // namespace ar3d
