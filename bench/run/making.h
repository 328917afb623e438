#pragma once

#include <atomic>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>

#include "ar3d/bench/measure/stopwatch.h"
#include "ar3d/bench/plan/plan.h"
#include "ar3d/bench/run/progress.h"
#include "ar3d/bench/run/ranks.h"
#include "ar3d/store/columns/run_record.h"

namespace ar3d {

/// How the rows of a plan are made: what the user and the other processes decide. What the study
/// itself decides, timing rules and budget, is in its plan.
struct MakingPolicy {
  int workers = 1;            ///< rows made at the same time in the metrics phase (workers_for)
  int workers_elsewhere = 0;  ///< workers of the study's other processes in the metrics phase
  bool isolate = false;       ///< each row in a worker process; so it is too where rows have limits
  bool force_timing = false;  ///< time even in a build whose times are worth little
  bool timed_phases = true;   ///< false: only the metrics phase (another process does the others)
  Ranks* ranks = nullptr;     ///< that batches are shared by; null: this process is alone
  std::FILE* progress = nullptr;  ///< where to tell how far it is; null: nowhere
  std::string name = {};          ///< of the study, for the progress
  /// Place in the plan of the next instance for the metrics phase; empty: all, the largest first.
  std::function<std::optional<std::size_t>()> next_instance = {};
};

/// Workers of one process: as many as asked for; if 0 was, one for each core, or one for each of
/// several ranks. The only place where that is decided.
int workers_for(int asked, int ranks = 1);

/// Where the rows of a plan go, and which are there already.
class RowSink {
 public:
  virtual ~RowSink() = default;
  /// False: it has no rows, and is not asked for one.
  virtual bool has_any() const { return false; }
  /// True for a row that is not to be made. Called by several threads at once, as read() is.
  virtual bool has(const std::string& row_key) const {
    (void)row_key;
    return false;
  }
  /// A row that it has.
  virtual RunRecord read(const std::string& row_key) const;
  /// Takes a new row and its place in the plan, one call at a time. What it throws ends the making
  /// and is thrown again there.
  virtual void add(std::size_t place, const RunRecord& row) = 0;
};

/// Why make_rows came back.
enum class MakingEnd { complete, stopped, budget_spent };

/// What all phases of one making share: which rows are wanted, where they go, when to stop. All
/// references outlive it; its functions are called by several threads at once.
class Making {
 public:
  Making(const StudyPlan& plan, const MakingPolicy& policy, RowSink& sink);

  const StudyPlan& plan() const { return plan_; }
  const MakingPolicy& policy() const { return policy_; }

  bool wants(const PlannedRun& run) const { return !has_any_ || !sink_.has(run.row_key); }
  /// The row of a run that is not wanted, since it is there.
  RunRecord known(const PlannedRun& run) const { return sink_.read(run.row_key); }

  /// Hands a row on. Once that has failed, rows are lost: the making stops.
  void add(const PlannedRun& run, const RunRecord& row);

  /// True once no further row is to begin: a signal asked for it (is_interrupted), the study's
  /// budget is spent, or a row could not be handed on. Asked before every row and every drawing of
  /// a batch.
  bool stopped() const;

  /// How a drawing failed in the metrics phase, now or before; nothing if it can be drawn. Its rows
  /// of the other phases need not be tried.
  std::optional<RunRecord> failure(const PlannedInstance& instance, const PlannedRun& timed);

  /// To be asked last. @throws what the sink threw.
  MakingEnd end();

 private:
  bool is_budget_spent() const;
  std::optional<RunRecord> failed_row_of(const PlannedRun& run);

  const StudyPlan& plan_;
  const MakingPolicy& policy_;
  RowSink& sink_;
  Progress progress_;
  Stopwatch time_;
  const bool has_any_;
  const bool keeps_failures_;  // only where there are phases that ask
  std::mutex mutex_;
  std::unordered_map<std::string, RunRecord> failed_;  // by row key
  std::exception_ptr sink_failure_;
  std::atomic<bool> sink_failed_ = false;
};

}  // namespace ar3d
