// The tables of docs/performance.md: every row is measured, save where a peer is missing, and goals
// are judged at their own sizes only.
#include <fmt/format.h>

#include <map>
#include <sstream>

#include "support/program.h"

namespace ar3d::testing {
namespace {

const std::string kLimits = AR3D_LIMITS;

Outcome limits(const std::string& arguments) { return run(kLimits + " --memory 1 " + arguments); }

// The cells of the table's lines, without its head.
std::vector<std::vector<std::string>> lines_of(const std::string& table) {
  std::vector<std::vector<std::string>> lines;
  std::istringstream stream(table);
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with("| `")) continue;
    std::istringstream cells(line.substr(2));
    auto& parts = lines.emplace_back();
    for (std::string cell; std::getline(cells, cell, '|');) parts.push_back(cell);
  }
  return lines;
}

// Rows that need another program, a library or a right that a machine may lack; "layouts" never is.
bool may_be_unmeasured(const std::string& row) {
  for (const char* part : {"nauty-genrang", "crossings/cgal", "memory/", "layouts"}) {
    if (row.find(part) != std::string::npos) return true;
  }
  return false;
}

TEST(Limits, QuickMeasuresEveryRowAndJudgesNone) {
  const Outcome outcome = expect_exit(0, run(kLimits + " --quick"));
  EXPECT_THAT(outcome.out, HasSubstr("ns a dependent read at a random place"));
  std::map<std::string, int> rows;
  for (const auto& cells : lines_of(outcome.out)) {
    ASSERT_EQ(cells.size(), 8u) << cells[0];
    ++rows[cells[0]];
    if (may_be_unmeasured(cells[0]) && cells[4].starts_with(" –")) {
      EXPECT_EQ(cells[6], " – ") << cells[0];
      EXPECT_THAT(cells[7], StartsWith(" not measured")) << cells[0];
      continue;
    }
    EXPECT_GT(std::stod(cells[4]), 0) << cells[0] << cells[7];
    EXPECT_EQ(cells[3], " 1000 ") << cells[0];
    if (cells[0] != "`study/rows` ") {  // whose goal is for that size
      EXPECT_EQ(cells[6], " not judged at this n ") << cells[0];
      EXPECT_THAT(cells[7], Not(HasSubstr("missed"))) << cells[0];
    }
  }
  for (const char* name : {"draw/diamond/1000000",
                           "draw/diamond/10000000",
                           "draw/grid/1000000",
                           "draw/two-bend/1000000",
                           "draw/compact/1000000",
                           "draw/threads",
                           "certify/diamond/1000000",
                           "certify/diamond/10000000",
                           "certify/grid/1000000",
                           "certify/two-bend/1000000",
                           "certify/compact/1000000",
                           "certify/threads",
                           "memory/extents",
                           "memory/whole",
                           "memory/certify/diamond",
                           "read/graphml",
                           "crossings/cgal",
                           "generate/3/nauty-genrang",
                           "generate/4/igraph",
                           "generate/4/igraph_k_regular_game",
                           "generate/3/threads",
                           "study/rows",
                           "layouts"}) {
    EXPECT_GT(rows[fmt::format("`{}` ", name)], 0) << name;
  }
}

TEST(Limits, AGoalIsJudgedAtItsSize) {
  const Outcome outcome = expect_exit(0, limits("--only '^study/rows' --repetitions 1"));
  const auto lines = lines_of(outcome.out);
  ASSERT_EQ(lines.size(), 1u);
  const double measured = std::stod(lines[0][4]);  // rounded
  EXPECT_THAT(lines[0][6], AnyOf(" yes ", " no "));
  if (measured < 1.94) {
    EXPECT_EQ(lines[0][6], " no ");
    EXPECT_THAT(lines[0][7], HasSubstr("missed: ")) << "with the reason";
  }
  if (measured > 1.96) {
    EXPECT_EQ(lines[0][6], " yes ");
  }
}

// Every family that an algorithm draws has a line with a ratio for every size.
TEST(Limits, FamiliesHaveNanosecondsAndRatiosForEverySize) {
  const Outcome outcome = expect_exit(0, limits("--families --max-n 10000 --repetitions 1 --only "
                                                "'^(grid|diamond)/(cycle|random-4-regular|"
                                                "random-cubic)$'"));
  std::map<std::string, int> rows;
  for (const auto& cells : lines_of(outcome.out)) {
    ASSERT_EQ(cells.size(), 5u) << cells[0];
    ++rows[cells[0]];
    for (const std::size_t size : {1u, 2u}) {
      const std::size_t ratio = cells[size].find(';');
      ASSERT_NE(ratio, std::string::npos) << cells[0];
      EXPECT_GT(std::stod(cells[size]), 0) << cells[0];
      EXPECT_GT(std::stod(cells[size].substr(ratio + 1)), 0) << cells[0];
    }
    EXPECT_EQ(cells[3], " – ") << "no growth from one size";
  }
  EXPECT_EQ(rows.count("`grid/random-cubic` "), 1u);
  EXPECT_EQ(rows.count("`diamond/random-4-regular` "), 1u);
  EXPECT_EQ(rows.count("`grid/random-4-regular` "), 0u) << "its degree is too large";
  EXPECT_THAT(outcome.out, HasSubstr("Largest growth of `grid`: "));
}

TEST(Limits, BadArgumentsAreErrors) {
  expect_exit(2, limits("--only '('"));
  expect_exit(2, limits("--repetitions 0"));
  expect_exit(2, limits("--colour"));
}

}  // namespace
}  // namespace ar3d::testing
