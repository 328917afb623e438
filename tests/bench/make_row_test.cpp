#include <cmath>
#include <new>

#include "ar3d/base/error.h"
#include "ar3d/bench/measure/environment.h"
#include "ar3d/bench/measure/instruments.h"
#include "ar3d/bench/run/row_maker.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/store/columns/run_columns.h"
#include "bench/seeded.h"

namespace ar3d::testing {
namespace {

std::vector<RunRecord> rows_of(const PlannedInstance& instance) {
  RowMaker maker;
  maker.prepare(instance);
  std::vector<RunRecord> rows;
  for (const PlannedRun& run : instance.runs) rows.push_back(maker.make_row(run));
  return rows;
}

TEST(MakeRow, FillsARow) {
  const RunRecord run = rows_of(cycle_of(12, {&find_algorithm("diamond")}))[0];
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
    EXPECT_LE(static_cast<double>(run.extents[axis]), run.theorem_bound[axis]);
  }
  for (const double time : {run.generate_s, run.wall_s, run.cpu_s, run.certify_s, run.metrics_s}) {
    EXPECT_GE(time, 0);
    EXPECT_LT(time, 10);
  }
  EXPECT_GT(run.peak_bytes, 1 << 20);
}

TEST(MakeRow, TellsTheTheoremsAndThePublishedBound) {
  const RunRecord grid = rows_of(cycle_of(12, {&find_algorithm("grid")}))[0];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(grid.published_bound[axis], 12 * 12 * 12) << "the paper: O(n^3) per side";
    EXPECT_EQ(grid.theorem_bound[axis], 5600 * 12 + 3700);
  }
  const RunRecord two_bend = rows_of(cycle_of(12, {&find_algorithm("two-bend")}))[0];
  EXPECT_TRUE(std::isnan(two_bend.published_bound[0])) << "the paper has none";
}

TEST(MakeRow, WhatGoesWrongIsARowAndTheOthersGoOn) {
  const Algorithm refusing =
      diamond_drawn_by([](const Graph&, const Settings&) -> Drawing { throw InputError("no"); });
  const Algorithm greedy =
      diamond_drawn_by([](const Graph&, const Settings&) -> Drawing { throw std::bad_alloc(); });
  const Algorithm broken = diamond_drawn_by(
      [](const Graph&, const Settings&) -> Drawing { throw InternalError("bug"); });
  const Algorithm wrong = diamond_drawn_by([](const Graph& graph, const Settings&) {
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

TEST(MakeRow, AGraphThatCannotBeMadeRefusesAllItsRows) {
  Family family = find_family("cycle");
  family.generate = [](std::uint64_t, std::uint64_t, const Settings&) -> Graph {
    throw InputError("not today");
  };
  PlannedInstance instance = cycle_of(5, {&find_algorithm("diamond")}, 2);
  instance.choice.family = &family;
  for (const RunRecord& run : rows_of(instance)) {
    EXPECT_EQ(run.status, RunStatus::refused);
    EXPECT_EQ(run.message, "not today");
    EXPECT_EQ(run.n, -1);
  }
}

TEST(MakeRow, ARowThatNoFileCouldHoldIsAMarkedRow) {
  const Algorithm chatty = diamond_drawn_by([](const Graph& graph, const Settings& options) {
    Drawing drawing = find_algorithm("diamond").draw(graph, options);
    drawing.counters.push_back({std::string(1000, 'c'), 1});
    return drawing;
  });
  const RunRecord run = rows_of(cycle_of(5, {&chatty}))[0];
  EXPECT_EQ(run.status, RunStatus::crashed);
  EXPECT_THAT(run.message, HasSubstr("counters"));
}

// Warm-ups are drawn, not recorded; the hash is the drawing's.
TEST(MakeRow, WarmsUpAndHashesTheDrawing) {
  static int drawings = 0;
  const Algorithm counted = diamond_drawn_by([](const Graph& graph, const Settings& options) {
    ++drawings;
    return find_algorithm("diamond").draw(graph, options);
  });
  const PlannedInstance instance = cycle_of(12, {&counted});
  RowMaker maker(MemoryScope::process, 3, 1);
  maker.prepare(instance);
  const RunRecord run = maker.make_row(instance.runs[0], {.warm_ups = 2, .write = true});
  EXPECT_EQ(drawings, 3);
  EXPECT_EQ(run.warm_ups, 2);
  EXPECT_EQ(run.concurrency, 3);
  EXPECT_EQ(run.core, 1);
  EXPECT_EQ(run.drawing_hash, drawing_hash(draw(counted, generate(find_family("cycle"), 12, 0))));
  EXPECT_GT(run.write_s, 0);
  EXPECT_TRUE(std::isnan(maker.make_row(instance.runs[0]).write_s)) << "only when asked for";
}

// A row that is not certified takes over the verdict of one that is, if it is the same drawing.
TEST(MakeRow, TakesOverTheCertificateOfTheSameDrawingOnly) {
  const PlannedInstance instance = cycle_of(12, {&find_algorithm("diamond")}, 2);
  RowMaker maker;
  maker.prepare(instance);
  const RunRecord certified = maker.make_row(instance.runs[0]);
  RunRecord run = maker.make_row(instance.runs[1], {.certify = false});
  EXPECT_EQ(run.violations, -1);
  EXPECT_TRUE(std::isnan(run.certify_s));
  RunRecord other = run;
  take_over_certificate(certified, run);
  EXPECT_THAT(differing_columns(certified, run), ElementsAre("row_key", "repetition"));
  EXPECT_TRUE(std::isnan(run.certify_s)) << "it was not certified";
  other.drawing_hash[0] = other.drawing_hash[0] == '0' ? '1' : '0';
  take_over_certificate(certified, other);
  EXPECT_EQ(other.status, RunStatus::crashed);
  EXPECT_THAT(other.message, HasSubstr("another drawing"));
}

TEST(MakeRow, TheBisectionOfFirstInstancesIsSoughtUnlessTheRequestSaysNo) {
  const auto bound = [](std::uint32_t index, bool bisect) {
    PlannedInstance instance = cycle_of(1024, {&find_algorithm("compact")});
    instance.choice.family = &find_family("random-4-regular");
    instance.index = index;
    RowMaker maker;
    maker.prepare(instance);
    const RunRecord row = maker.make_row(instance.runs[0], {.bisect = bisect});
    return metric_of(row, "volume_at_least");
  };
  EXPECT_GT(bound(0, true), bound(1, true)) << "of the same graph";
  EXPECT_EQ(bound(0, false), bound(1, true));
}

// 64 MiB that the drawing takes and gives back stand in its peak, and not in the next row's.
TEST(MakeRow, PeakMemoryIsTheRowsOwn) {
  const Algorithm large = diamond_drawn_by([](const Graph& graph, const Settings& options) {
    std::vector<char> bytes(std::size_t{64} << 20, 1);
    asm volatile("" : : "r"(bytes.data()) : "memory");
    return find_algorithm("diamond").draw(graph, options);
  });
  const PlannedInstance instance = cycle_of(12, {&large, &find_algorithm("diamond")});
  RowMaker maker(MemoryScope::row);
  maker.prepare(instance);
  const RunRecord first = maker.make_row(instance.runs[0]);
  const RunRecord second = maker.make_row(instance.runs[1]);
  EXPECT_EQ(first.peak_scope, "row");
  EXPECT_GE(first.draw_peak_bytes, first.base_bytes + (60 << 20));
  EXPECT_GE(first.peak_bytes, first.draw_peak_bytes);
  if (std::string(build_kind()) != "sanitised") {  // AddressSanitizer keeps what is freed
    EXPECT_LT(second.peak_bytes, second.base_bytes + (16 << 20));
  }
  RowMaker among_others({});
  among_others.prepare(instance);
  const RunRecord third = among_others.make_row(instance.runs[1]);
  EXPECT_EQ(third.peak_scope, "process");
  EXPECT_EQ(third.draw_peak_bytes, -1) << "unknown, not zero";
  EXPECT_EQ(third.base_bytes, -1);
}

// What the kernel counts is positive; what it does not count is missing, never zero.
TEST(MakeRow, CountersAreThereOrMissing) {
  const PlannedInstance instance = cycle_of(1000, {&find_algorithm("diamond")});
  RowMaker maker;
  maker.prepare(instance);
  const RunRecord run = maker.make_row(instance.runs[0]);
  const std::string availability = HardwareCounters().availability();
  if (availability == "available") {
    EXPECT_GT(run.instructions, 1000);
    EXPECT_GT(run.cycles, 1000);
    EXPECT_GE(run.cache_misses, 0);
  } else {
    EXPECT_THAT(availability, HasSubstr("absent: "));
    EXPECT_TRUE(run.instructions == -1 || run.cycles == -1 || run.cache_misses == -1);
    EXPECT_NE(run.instructions, 0);
    EXPECT_NE(run.cycles, 0);
  }
}

}  // namespace
}  // namespace ar3d::testing
