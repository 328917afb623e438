// What docs/open-questions.md says that computations say.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <nlohmann/json.hpp>

#include "support/program.h"

namespace ar3d::testing {
namespace {

using nlohmann::json;

const std::string kQuestions = AR3D_SOURCE_DIR "/docs/open-questions/";

/// "sat" or "unsat": has the graph a drawing on the lattice?
std::string answer(const std::string& graph6, const std::string& options,
                   const std::string& script = "lattice_orders.py",
                   const std::string& solver = "z3") {
  const ScratchDirectory scratch;
  const std::string formula = scratch.path("formula.smt2");
  expect_exit(0, run("/usr/bin/python3 " + kQuestions + script + " '" + graph6 + "' " + options +
                     " > " + formula));
  std::string said = run(solver + " " + formula).out;
  while (!said.empty() && said.back() == '\n') said.pop_back();
  return said;
}

const std::string kK5 = "D~{";
const std::string kOctahedron = "E]~o";
const std::string kDrawable = "FFzvO";  // the other one with 7 vertices

TEST(OpenQuestions, K5HasNoLatticeDrawingWithTwoBends) { EXPECT_EQ(answer(kK5, ""), "unsat"); }

TEST(OpenQuestions, K5HasNoLatticeDrawingWithTwoBendsByTheSecondFormula) {
  EXPECT_EQ(answer(kK5, "", "lattice_lengths.py"), "unsat");
}

TEST(OpenQuestions, K5HasNoLatticeDrawingWithOneBendByBothFormulas) {
  EXPECT_EQ(answer(kK5, "--bends 1"), "unsat");
  EXPECT_EQ(answer(kK5, "--bends 1", "lattice_lengths.py"), "unsat");
}

TEST(OpenQuestions, TheOctahedronHasNoLatticeDrawingWithTwoBends) {
  EXPECT_EQ(answer(kOctahedron, ""), "unsat");
}

TEST(OpenQuestions, OneGraphOfSevenVerticesHasALatticeDrawing) {
  EXPECT_EQ(answer(kDrawable, ""), "sat");
}

TEST(OpenQuestions, TheModelRefusesWhatIsNotFourRegular) {
  for (const std::string script : {"lattice_orders.py", "lattice_lengths.py"}) {
    const auto made = run("/usr/bin/python3 " + kQuestions + script + " 'C~'");
    EXPECT_NE(made.exit_code, 0);
    EXPECT_THAT(made.err, HasSubstr("vertex 0 has not degree 4"));
  }
}

using Vector3 = std::array<std::int64_t, 3>;

/// On the cube grid, where p = (x, y, z) is (x + y - 2z, x - y, 2(x + y + z)) in the file, as
/// docs/open-questions.md names it.
std::string cube_box(const json& drawing) {
  std::array<std::array<std::int64_t, 2>, 3> range;
  range.fill({std::int64_t{1} << 60, -(std::int64_t{1} << 60)});
  const auto add = [&](const json& point) {
    const auto [x, y, z] = point.get<Vector3>();
    const Vector3 p = {(x + 3 * y + z) / 6, (x - 3 * y + z) / 6, (z - 2 * x) / 6};
    for (std::size_t k = 0; k < 3; ++k) {
      range[k] = {std::min(range[k][0], p[k]), std::max(range[k][1], p[k])};
    }
  };
  for (const auto& point : drawing["vertices"]) add(point);
  for (const auto& edge : drawing["edges"]) {
    for (const auto& bend : edge[2]) add(bend);
  }
  return fmt::format("{} x {} x {}", range[0][1] - range[0][0], range[1][1] - range[1][0],
                     range[2][1] - range[2][0]);
}

Vector3 between(const json& from, const json& to) {
  const auto a = from.get<Vector3>();
  const auto b = to.get<Vector3>();
  return {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
}

/// Whether the cosine is exactly -1/3, for squared length 2x^2 + 6y^2 + z^2.
bool make_the_optimal_angle(Vector3 a, Vector3 b) {
  const auto dot = [](Vector3 u, Vector3 v) {
    return 2 * u[0] * v[0] + 6 * u[1] * v[1] + u[2] * v[2];
  };
  return dot(a, b) < 0 && 9 * dot(a, b) * dot(a, b) == dot(a, a) * dot(b, b);
}

TEST(OpenQuestions, K4HasADrawingWithOneBend) {
  const ScratchDirectory scratch;
  const std::string file = scratch.path("k4.jsonl");
  run("/usr/bin/python3 " + kQuestions + "k4_one_bend.py > " + file);
  expect_output(run("{} verify " + file + " --algorithm two-bend-109"), "4 certified, 0 violated");
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    const json drawing = json::parse(line);
    EXPECT_EQ(cube_box(drawing), "4 x 4 x 4");
    EXPECT_EQ(drawing["edges"].size(), 6u);
    std::array<std::vector<Vector3>, 4> leaving;
    for (const auto& edge : drawing["edges"]) {
      ASSERT_EQ(edge[2].size(), 1u) << "one bend";
      for (const std::size_t end : {0u, 1u}) {
        const auto v = edge[end].get<std::size_t>();
        leaving.at(v).push_back(between(drawing["vertices"][v], edge[2][0]));
      }
      const auto back = [&](std::size_t end) {
        return between(edge[2][0], drawing["vertices"][edge[end].get<std::size_t>()]);
      };
      EXPECT_TRUE(make_the_optimal_angle(back(0), back(1))) << "at the bend";
    }
    for (const auto& three : leaving) {
      ASSERT_EQ(three.size(), 3u);
      for (const std::size_t i : {0u, 1u, 2u}) {
        EXPECT_TRUE(make_the_optimal_angle(three[i], three[(i + 1) % 3])) << "at a vertex";
      }
    }
  }
}

TEST(OpenQuestions, K5WithOneBendIsMadeAgain) {
  const Outcome made = run("/usr/bin/python3 " + kQuestions + "k5_one_bend.py --exact");
  EXPECT_EQ(made.out, read_file(kQuestions + "k5_one_bend.jsonl"));
  EXPECT_THAT(made.err, HasSubstr("58.668 degrees"));
}

TEST(OpenQuestions, TheSumExcludesOneBendForK5Alone) {
  const std::string sums = run("for n in 5 6 7 8 9; do nauty-geng -cq -d4 -D4 $n; done | "
                               "/usr/bin/python3 " +
                               kQuestions + "one_bend_sums.py")
                               .out;
  EXPECT_EQ(std::ranges::count(sums, '\n'), 26);
  EXPECT_THAT(sums, HasSubstr("D~{ n=5 at least 13.33, at most 12.25: excluded\n"));
  EXPECT_EQ(sums.find(": excluded"), sums.rfind(": excluded")) << sums;
}

TEST(OpenQuestions, SmallDrawingsAreCertified) {
  const std::string file = kQuestions + "small_drawings.jsonl";
  expect_output(run("{} verify " + file + " --algorithm two-bend-109"), "3 certified, 0 violated");
  EXPECT_THAT(read_file(file), Not(HasSubstr("two-bend-109"))) << "no algorithm of ours drew them";
}

TEST(OpenQuestions, SmallDrawingsHaveTheBoxesStated) {
  std::ifstream file(kQuestions + "small_drawings.jsonl");
  std::vector<std::string> boxes;
  for (std::string line; std::getline(file, line);) boxes.push_back(cube_box(json::parse(line)));
  EXPECT_THAT(boxes, ElementsAre("29 x 41 x 38", "14 x 14 x 14", "12 x 12 x 14"));
  const std::string page = read_file(AR3D_SOURCE_DIR "/docs/open-questions.md");
  for (const std::string& box : boxes) EXPECT_THAT(page, HasSubstr(box));
}

TEST(OpenQuestions, TheSearchFindsADrawingOrSaysThatItFindsNone) {
  const std::string search = "/usr/bin/python3 " + kQuestions + "small_drawings.py ";
  const Outcome made = run(search + "C~ 40 9 1 100000 0.1 | {} verify - --algorithm two-bend-109");
  expect_output(made, "1 certified, 0 violated");
  EXPECT_THAT(made.err, HasSubstr("box 9 x 7 x 7"));
  expect_exit(1, run(search + "'D~{' 2 1 1 1000 0.1"));
  for (const char* bad : {"'D~{' 2 1 1 1000", "'D~' 9 9 1 1000 0.1", "'E~~w' 9 9 1 1000 0.1",
                          "'D~{' 0 9 1 1000 0.1", "'D~{' 9 200 1 1000 0.1"}) {
    expect_error(run(search + bad), "usage: small_drawings");
  }
}

}  // namespace
}  // namespace ar3d::testing
