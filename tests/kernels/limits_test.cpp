// The table of docs/performance.md: every row comes, measured where something can be, and goals are
// judged at their own sizes only.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "support/program.h"

namespace ar3d {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;
using testing::Outcome;
using testing::run;
using ::testing::StartsWith;

Outcome limits(const std::string& arguments) {
  return run(std::string(AR3D_LIMITS) + " --memory 1 " + arguments);
}

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

TEST(Limits, EveryRowComesAndIsJudgedAtItsOwnSizeOnly) {
  const Outcome outcome = limits("--max-n 300 --repetitions 1");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("ns a dependent read at a random place"));
  std::map<std::string, int> rows;
  for (const auto& cells : lines_of(outcome.out)) {
    ASSERT_EQ(cells.size(), 8u) << cells[0];
    ++rows[cells[0]];
    const bool measured = !cells[4].starts_with(" –");
    if (measured) {
      EXPECT_GT(std::stod(cells[4]), 0) << cells[0];
      EXPECT_EQ(cells[3], " 300 ") << cells[0];
      EXPECT_EQ(cells[6], " not judged at this n ") << cells[0];
    } else {
      EXPECT_EQ(cells[6], " – ") << cells[0];
      EXPECT_THAT(cells[7], StartsWith(" not measured")) << cells[0];
    }
  }
  for (const char* name : {"draw/diamond/1000000", "draw/diamond/10000000", "draw/grid/1000000",
                           "draw/two-bend/1000000", "draw/compact/1000000", "draw/threads",
                           "certify/diamond", "certify/grid", "certify/two-bend", "certify/compact",
                           "crossings/cgal", "generate/3/nauty-genrang", "generate/4/igraph",
                           "generate/3/threads", "study/rows", "layouts"}) {
    EXPECT_GT(rows[fmt::format("`{}` ", name)], 0) << name;
  }
}

TEST(Limits, AGoalIsJudgedAtItsSize) {
  const Outcome outcome = limits("--only '^study/rows' --repetitions 1");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto lines = lines_of(outcome.out);
  ASSERT_EQ(lines.size(), 1u);
  const double measured = std::stod(lines[0][4]);  // rounded
  EXPECT_THAT(lines[0][6], AnyOf(" yes ", " no "));
  if (measured < 1.94) {
    EXPECT_EQ(lines[0][6], " no ");
  }
  if (measured > 1.96) {
    EXPECT_EQ(lines[0][6], " yes ");
  }
}

TEST(Limits, BadArgumentsAreErrors) {
  EXPECT_EQ(limits("--only '('").exit_code, 2);
  EXPECT_EQ(limits("--repetitions 0").exit_code, 2);
  EXPECT_EQ(limits("--colour").exit_code, 2);
}

}  // namespace
}  // namespace ar3d
