// The benchmarks of docs/performance.md and the table that is made of them: every one is measured,
// save where a peer is missing, and goals are judged at their own sizes only.
#include <fmt/format.h>

#include <map>
#include <sstream>

#include "support/program.h"

namespace ar3d::testing {
namespace {

const std::string kLimits = AR3D_LIMITS;
const std::string kTable = "/usr/bin/python3 " AR3D_SOURCE_DIR "/bench/kernels/limits/table.py ";

// Algorithms, each with the family that it is measured on.
const std::pair<const char*, const char*> kDrawn[] = {
    {"diamond", "random-4-regular"}, {"compact", "random-4-regular"},
    {"grid", "random-cubic"},        {"two-bend", "random-cubic"},
    {"compact-120", "random-cubic"}, {"two-bend-109", "random-4-regular"}};

// Runs the benchmarks that the filter finds, once, into a file.
std::string report(const ScratchDirectory& scratch, const std::string& program,
                   const std::string& filter, const std::string& name = "report.json") {
  const std::string file = scratch.path(name);
  expect_exit(0, run(program + " --benchmark_repetitions=1 --benchmark_filter='" + filter +
                     "' --benchmark_out=" + file));
  return file;
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

// Rows that need another program, a library or a right that a machine may lack.
bool may_be_unmeasured(const std::string& row) {
  for (const char* part : {"nauty-genrang", "crossings/cgal", "memory/"}) {
    if (row.find(part) != std::string::npos) return true;
  }
  return false;
}

TEST(Limits, EveryRowIsMeasuredAndNoneIsJudgedAtSmallSizes) {
  const ScratchDirectory scratch;
  const std::string file = report(scratch, kLimits, "/(n:1000|mib:1|rows:20)/");
  const Outcome outcome = expect_exit(0, run(kTable + file));
  EXPECT_THAT(outcome.out, HasSubstr("load average before"));
  std::map<std::string, int> rows;
  for (const auto& cells : lines_of(outcome.out)) {
    ASSERT_EQ(cells.size(), 6u) << cells[0];
    ++rows[cells[0]];
    EXPECT_THAT(cells[5], Not(HasSubstr("missed"))) << cells[0];
    if (may_be_unmeasured(cells[0]) && cells[2].starts_with(" –")) {
      EXPECT_EQ(cells[4], " – ") << cells[0];
      EXPECT_THAT(cells[5], StartsWith(" not measured, missing")) << cells[0];
      continue;
    }
    EXPECT_GT(std::stod(cells[2]), 0) << cells[0] << cells[5];
    EXPECT_EQ(cells[4], "  ") << cells[0];
  }
  for (const auto& [algorithm, family] : kDrawn) {
    EXPECT_GT(rows[fmt::format("`draw/{}/{}/effort:1/n:1000` ", algorithm, family)], 0);
    for (const char* stage : {"certify", "measure", "memory/certify"}) {
      EXPECT_GT(rows[fmt::format("`{}/{}/n:1000` ", stage, algorithm)], 0) << stage << algorithm;
    }
  }
  for (const char* name :
       {"machine/chain/mib:1", "draw/boost_search/random-cubic/n:1000",
        "draw/diamond/random-4-regular/effort:0/n:1000",
        "threads/draw/diamond/effort:0/threads:2/n:1000",
        "at_once/draw/diamond/effort:0/n:1000/threads:2",
        "threads/certify/diamond/threads:2/n:1000", "memory/draw/diamond/n:1000",
        "memory/draw_and_measure/diamond/n:1000", "memory/whole/diamond/n:1000",
        "read/graphml/ours/n:1000", "crossings/cgal/n:1000", "generate/nauty-genrang/3/n:1000",
        "generate/igraph/4/n:1000", "generate/igraph_k_regular_game/4/n:1000",
        "threads/generate/3/threads:2/n:1000", "study/rows/workers:2/rows:20"}) {
    EXPECT_GT(rows[fmt::format("`{}` ", name)], 0) << name;
  }
}

// All algorithms are drawn at 10^5 and at 10^6.
TEST(Limits, EveryAlgorithmIsDrawnAtLargeSizes) {
  const std::string names = run(kLimits + " --benchmark_list_tests").out;
  for (const auto& [algorithm, family] : kDrawn) {
    for (const int n : {100000, 1000000}) {
      EXPECT_THAT(names, HasSubstr(fmt::format("draw/{}/{}/effort:1/n:{}/", algorithm, family, n)));
    }
  }
  EXPECT_THAT(names, Not(HasSubstr("n:10000000"))) << "large graphs are asked for";
  EXPECT_THAT(names, Not(HasSubstr("n:1000/")));
}

TEST(Limits, AGoalIsJudgedAtItsSize) {
  const ScratchDirectory scratch;
  const std::string file = report(scratch, kLimits, "^study/.*rows:2000/");
  const Outcome outcome = expect_exit(0, run(kTable + file));
  const auto lines = lines_of(outcome.out);
  ASSERT_EQ(lines.size(), 1u);
  const double measured = std::stod(lines[0][2]);  // rounded
  EXPECT_THAT(lines[0][4], AnyOf(" yes ", " no "));
  if (measured < 1.94) {
    EXPECT_EQ(lines[0][4], " no ");
    EXPECT_THAT(lines[0][5], HasSubstr("missed: ")) << "with the reason";
  }
  if (measured > 1.96) {
    EXPECT_EQ(lines[0][4], " yes ");
  }
}

// A report of benchmarks with these names and times, in seconds.
std::string made_up(const std::vector<std::pair<std::string, double>>& times,
                    const std::string& more = "") {
  std::string rows;
  for (const auto& [name, seconds] : times) {
    rows += fmt::format(
        "{}{{\"run_name\": \"{}\", \"run_type\": \"iteration\", \"cpu_time\": {}, \"real_time\": "
        "1, "
        "\"time_unit\": \"s\"{}}}",
        rows.empty() ? "" : ",\n", name, seconds, more);
  }
  return fmt::format(
      "{{\"context\": {{\"num_cpus\": 2, \"mhz_per_cpu\": 1, \"date\": \"2026-01-02\", "
      "\"load_avg\": [0.5]}},\n\"benchmarks\": [{}]}}",
      rows);
}

// Ratios of medians, goals on both sides of them, the last file counting.
TEST(Limits, RatiosAreThoseOfMediansAndTheLastFileCounts) {
  const ScratchDirectory scratch;
  const std::string draw = "draw/diamond/random-4-regular/effort:1/n:1000000/iterations:1";
  const std::string search = "draw/search/random-4-regular/n:1000000/iterations:1";
  const std::string slow = scratch.write(
      "slow.json", made_up({{draw, 2}, {draw, 99}, {draw, 3}, {search, 1}, {search, 1}}));
  const std::string good = scratch.write("good.json", made_up({{draw, 2}, {search, 1}}));
  EXPECT_THAT(run(kTable + slow).out, HasSubstr("| 3× | ≤ 2 | no |"));
  EXPECT_THAT(run(kTable + slow).out, HasSubstr("missed: some 14 random accesses"));
  const Outcome both = expect_exit(0, run(kTable + slow + " " + good));
  EXPECT_THAT(both.out, HasSubstr("| 2× | ≤ 2 | yes |"));
  EXPECT_THAT(both.out, Not(HasSubstr("3×")));
  const std::string alone = scratch.write("alone.json", made_up({{draw, 2}}));
  EXPECT_TRUE(lines_of(run(kTable + alone).out).empty()) << "its yardstick was not asked for";
}

TEST(Limits, WhatFailedAndWhatIsMissingAreToldApart) {
  const ScratchDirectory scratch;
  for (const auto& [message, code] :
       std::vector<std::pair<std::string, int>>{{"missing: a peer", 0}, {"not valid", 1}}) {
    const std::string file = scratch.write(
        "e.json",
        made_up({{"read/graphml/ours/n:300000", 1}},
                fmt::format(", \"error_occurred\": true, \"error_message\": \"{}\"", message)));
    const Outcome outcome = expect_exit(code, run(kTable + file));
    EXPECT_THAT(outcome.out, HasSubstr((code == 0 ? "not measured, " : "failed: ") + message));
  }
  for (const char* text : {"", "{}", "[1]", "{\"context\": {}, \"benchmarks\": [{}]}"}) {
    const Outcome outcome = run(kTable + scratch.write("bad.json", text));
    EXPECT_EQ(outcome.exit_code, 2);
    expect_one_line(outcome, "bad.json: not a report of Google Benchmark");
  }
}

// Every family that an algorithm draws has a line with a ratio for every size.
TEST(Limits, FamiliesHaveNanosecondsAndRatiosForEverySize) {
  const ScratchDirectory scratch;
  const std::string file =
      report(scratch, std::string(AR3D_KERNELS) + " --benchmark_min_time=0",
             "^(draw/(grid|diamond)|search)/(cycle|random-4-regular|random-cubic)/(1000|10000)/");
  const Outcome outcome = expect_exit(0, run(kTable + file));
  std::map<std::string, int> rows;
  for (const auto& cells : lines_of(outcome.out)) {
    ASSERT_EQ(cells.size(), 3u) << cells[0];
    ++rows[cells[0]];
    EXPECT_THAT(cells[1], ContainsRegex("1000: [1-9][0-9]*, [0-9.]+; 10000: [1-9][0-9]*, [0-9.]+"))
        << cells[0];
    EXPECT_EQ(cells[2], " – ") << "no growth from one size";
  }
  EXPECT_EQ(rows.count("`grid/random-cubic` "), 1u);
  EXPECT_EQ(rows.count("`diamond/random-4-regular` "), 1u);
  EXPECT_EQ(rows.count("`grid/random-4-regular` "), 0u) << "its degree is too large";
}

TEST(Limits, BadArgumentsAreErrors) {
  expect_exit(2, run(kLimits + " --colour"));
  expect_exit(2, run(kTable));
}

}  // namespace
}  // namespace ar3d::testing
