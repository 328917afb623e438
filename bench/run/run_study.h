#pragma once

#include <atomic>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <unordered_map>

#include "ar3d/bench/plan/plan.h"
#include "ar3d/bench/run/make_rows.h"
#include "ar3d/results/run_record.h"

namespace ar3d {

struct StudyOptions {
  int threads = 0;                ///< 0: as many as OpenMP takes
  std::FILE* progress = nullptr;  ///< where to tell how far it is; null: nowhere
  /// Once true, instances that have not begun do not begin and no further row is made.
  const std::atomic<bool>* stop = nullptr;
  /// isolate, force_timing, timed_phases, neighbours; the rest is taken from above and the plan.
  MakingRules making = {};
  /// Place in the plan of the next instance for the metrics phase; empty: all, the largest first.
  std::function<std::optional<std::size_t>()> next_instance = {};
};

/// Rows that exist already and are not made again. Both may be empty: there are none.
struct ExistingRows {
  std::function<bool(const std::string& row_key)> contains;
  std::function<RunRecord(const std::string& row_key)> read;  ///< a row that is contained
};

/// Takes a new row and its place in the plan, one call at a time.
using RowListener = std::function<void(std::size_t row, const RunRecord& run)>;

/// Makes the rows of a plan (make_rows) that do not exist, and keeps none of them.
/// @param on_row  what it throws ends the study and is thrown again here.
/// @param name  for the progress.
MakingEnd make_plan(const StudyPlan& plan, const StudyOptions& options,
                    const ExistingRows& existing, const RowListener& on_row,
                    const std::string& name);

/// Rows that exist already, by key; they are taken over instead of made again.
using FinishedRuns = std::unordered_map<std::string, RunRecord>;

/// make_plan in memory. The rows stand in the plan's order; on any number of threads all columns
/// but the measured ones are equal.
/// @param on_row  called with every new row as soon as it is made. May be empty.
/// @return as many rows as planned, but for optional ones that were not needed; fewer after a stop
/// or when the budget is spent.
std::vector<RunRecord> run_plan(const StudyPlan& plan, const StudyOptions& options,
                                const FinishedRuns& finished = {},
                                const std::function<void(const RunRecord&)>& on_row = {},
                                const std::string& name = "");

/// "2026-01-02T03:04:05.678901+00:00".
std::string now_with_zone();

/// Everything about a study's results but its rows: name, specification, source, environment, time.
Results describe_study(const StudySpec& spec, int threads);

/// Plans and runs a study in memory. @throws InputError as plan_study.
Results run_study(const StudySpec& spec, const StudyOptions& options = {});

}  // namespace ar3d
