#include "ar3d/bench/run_instance.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <new>
#include <vector>

#include "ar3d/model/error.h"

namespace ar3d {
namespace {

using ::testing::HasSubstr;

PlannedInstance cycle_of(std::uint64_t n, const std::vector<const Algorithm*>& algorithms,
                         std::uint32_t repetitions = 1) {
  PlannedInstance instance;
  instance.choice = {&find_family("cycle"), {}};
  instance.wanted_n = instance.n = n;
  for (const Algorithm* algorithm : algorithms) {
    for (std::uint32_t r = 0; r < repetitions; ++r) {
      const std::size_t row = instance.runs.size();
      instance.runs.push_back(
          {{algorithm, complete_options(*algorithm, {})}, "", r, "key" + std::to_string(row), row});
    }
  }
  return instance;
}

std::vector<ar3d::Run> rows_of(const PlannedInstance& instance) {
  std::vector<ar3d::Run> rows(instance.runs.size());
  run_instance(instance, {}, {},
               [&](std::size_t row, ar3d::Run run) { rows[row] = std::move(run); });
  return rows;
}

Algorithm diamond_drawn_by(Drawing (*draw)(const Graph&, const OptionValues&)) {
  Algorithm algorithm = find_algorithm("diamond");
  algorithm.draw = draw;
  return algorithm;
}

TEST(RunInstance, FillsARow) {
  const ar3d::Run run = rows_of(cycle_of(12, {&find_algorithm("diamond")}))[0];
  EXPECT_EQ(run.status, RunStatus::ok) << run.message;
  EXPECT_EQ(run.n, 12);
  EXPECT_EQ(run.m, 12);
  EXPECT_EQ(run.graph_hash, graph_hash(generate(find_family("cycle"), 12, 0)));
  EXPECT_EQ(run.violations, 0);
  double volume_log2 = 0;
  for (const std::int64_t extent : run.extents) {
    volume_log2 += std::log2(static_cast<double>(extent) + 1);
  }
  EXPECT_NEAR(run.log2_volume, volume_log2, 1e-12);
  std::int64_t edges = 0;
  for (const std::int64_t count : run.bends) edges += count;
  EXPECT_EQ(edges, 12);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_GT(run.theorem_bound[axis], 0);
    EXPECT_NEAR(run.slack[axis],
                1 - static_cast<double>(run.extents[axis]) / run.theorem_bound[axis], 1e-12);
  }
  for (const double time : {run.generate_s, run.wall_s, run.cpu_s, run.certify_s}) {
    EXPECT_GE(time, 0);
    EXPECT_LT(time, 10);
  }
  EXPECT_GT(run.peak_bytes, 1 << 20);
}

TEST(RunInstance, TellsTheTheoremsAndThePublishedBound) {
  const ar3d::Run grid = rows_of(cycle_of(12, {&find_algorithm("grid")}))[0];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(grid.published_bound[axis], 12 * 12 * 12) << "the paper: O(n^3) a side";
    EXPECT_EQ(grid.theorem_bound[axis], 1800 * 12 + 3700);
  }
  EXPECT_EQ(grid.published_bound_formula,
            "n^3, n^3, n^3 (paper; order only, constant 1 assumed, Theorem 3)");
  EXPECT_THAT(grid.theorem_bound_formula, ::testing::HasSubstr("1800 n + 3700"));
  const ar3d::Run two_bend = rows_of(cycle_of(12, {&find_algorithm("two-bend")}))[0];
  EXPECT_TRUE(std::isnan(two_bend.published_bound[0])) << "the paper has none";
  EXPECT_EQ(two_bend.published_bound_formula, "");
}

TEST(RunInstance, WhatGoesWrongIsARowAndTheOthersGoOn) {
  const Algorithm refusing = diamond_drawn_by(
      [](const Graph&, const OptionValues&) -> Drawing { throw InputError("no"); });
  const Algorithm greedy = diamond_drawn_by(
      [](const Graph&, const OptionValues&) -> Drawing { throw std::bad_alloc(); });
  const Algorithm broken = diamond_drawn_by(
      [](const Graph&, const OptionValues&) -> Drawing { throw InternalError("bug"); });
  const Algorithm wrong = diamond_drawn_by([](const Graph& graph, const OptionValues&) {
    auto straight = std::make_shared<StoredBends>();
    for (EdgeId e = 0; e < graph.num_edges(); ++e) straight->add_edge({});
    return Drawing("diamond", kCubeLattice, Coordinates(graph.num_vertices(), 1),
                   graph.shared_edges(), straight);
  });
  const auto rows =
      rows_of(cycle_of(5, {&refusing, &greedy, &broken, &wrong, &find_algorithm("diamond")}));
  EXPECT_EQ(rows[0].status, RunStatus::refused);
  EXPECT_EQ(rows[0].message, "no");
  EXPECT_EQ(rows[1].status, RunStatus::out_of_memory);
  EXPECT_EQ(rows[2].status, RunStatus::crashed);
  EXPECT_THAT(rows[2].message, HasSubstr("bug"));
  EXPECT_EQ(rows[2].violations, -1);
  EXPECT_TRUE(std::isnan(rows[2].wall_s));
  EXPECT_EQ(rows[3].status, RunStatus::violated);
  EXPECT_GT(rows[3].violations, 0);
  EXPECT_FALSE(rows[3].message.empty());
  EXPECT_EQ(rows[4].status, RunStatus::ok);
}

TEST(RunInstance, AGraphThatCannotBeMadeRefusesAllItsRows) {
  Family family = find_family("cycle");
  family.generate = [](std::uint64_t, std::uint64_t, const ParameterValues&) -> Graph {
    throw InputError("not today");
  };
  PlannedInstance instance = cycle_of(5, {&find_algorithm("diamond")}, 2);
  instance.choice.family = &family;
  for (const ar3d::Run& run : rows_of(instance)) {
    EXPECT_EQ(run.status, RunStatus::refused);
    EXPECT_EQ(run.message, "not today");
    EXPECT_EQ(run.n, -1);
  }
}

TEST(RunInstance, ARowThatNoFileCouldHoldIsAMarkedRow) {
  const Algorithm chatty = diamond_drawn_by([](const Graph& graph, const OptionValues& options) {
    Drawing drawing = find_algorithm("diamond").draw(graph, options);
    drawing.counters.push_back({std::string(1000, 'c'), 1});
    return drawing;
  });
  const ar3d::Run run = rows_of(cycle_of(5, {&chatty}))[0];
  EXPECT_EQ(run.status, RunStatus::crashed);
  EXPECT_THAT(run.message, HasSubstr("counters"));
}

TEST(RunInstance, MakesOnlyWhatIsWantedAndStops) {
  const PlannedInstance instance = cycle_of(5, {&find_algorithm("diamond")}, 4);
  std::vector<std::size_t> made;
  const auto note = [&](std::size_t row, const ar3d::Run&) { made.push_back(row); };
  run_instance(
      instance, [](const std::string& key) { return key != "key1"; }, {}, note);
  EXPECT_THAT(made, ::testing::ElementsAre(0, 2, 3));
  made.clear();
  run_instance(
      instance, {}, [&] { return made.size() == 2; }, note);
  EXPECT_EQ(made.size(), 2u);
}

}  // namespace
}  // namespace ar3d
