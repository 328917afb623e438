#pragma once

#include <atomic>
#include <cstdio>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "ar3d/bench/measure/instruments.h"
#include "ar3d/bench/plan/plan.h"
#include "ar3d/bench/run/ranks.h"
#include "ar3d/bench/run/row_maker.h"
#include "ar3d/store/columns/run_record.h"
#include "ar3d/store/study_identity.h"

namespace ar3d {

/// Holds how the rows of a plan are made: what the user and the other processes decide. What the
/// study itself decides, timing rules and budget, is in its plan.
struct SessionPolicy {
  int workers = 1;            ///< rows made at the same time in the metrics phase (workers_for)
  int workers_elsewhere = 0;  ///< workers of the study's other processes in the metrics phase
  bool isolate = false;       ///< each row in a worker process; so it is too where rows have limits
  bool force_timing = false;  ///< time even in a build whose times are worth little
  bool metrics_phase = true;  ///< false: another process makes it, and so for the other phases
  bool timed_phases = true;
  Ranks* ranks = nullptr;     ///< that batches are shared by; null: this process is alone
  std::FILE* progress = nullptr;  ///< where to tell how far it is; null: nowhere
  std::string name = {};          ///< of the study, for the progress
};

/// Returns the workers of one process: as many as asked for; if 0 was, one for each core, or one
/// for each of several ranks. The only place where that is decided.
int workers_for(int asked, int ranks = 1);

/// Holds where the rows of a plan go, and which are there already.
struct RowSink {
  /// Takes a new row and its place in the plan, one call at a time. What it throws ends the session
  /// and is thrown again there.
  std::function<void(std::size_t place, const RunRecord& row)> add;
  /// Takes what is to be known of the session, for its environment; empty: nobody wants to know.
  std::function<void(const EnvironmentEntry&)> note = {};
  /// Gives true for a row that is not to be made; empty: there is none. Called by several threads
  /// at once, as `read` is.
  std::function<bool(const std::string& row_key)> has = {};
  /// Returns a row that is there.
  std::function<RunRecord(const std::string& row_key)> read = {};
};

/// Holds what all phases of one session share: which rows are wanted, where they go, when to stop.
/// All references outlive it; its functions are called by several threads at once.
class StudySession {
 public:
  StudySession(const StudyPlan& plan, const SessionPolicy& policy, const RowSink& sink);
  ~StudySession();

  const StudyPlan& plan() const { return plan_; }
  const SessionPolicy& policy() const { return policy_; }

  bool wants(const PlannedRun& run) const { return !sink_.has || !sink_.has(run.row_key); }
  /// Returns the row of a run that is not wanted, since it is there.
  RunRecord known(const PlannedRun& run) const { return sink_.read(run.row_key); }

  /// Hands a row on. Once that has failed, rows are lost: the session stops.
  void add(const PlannedRun& run, const RunRecord& row);

  /// Returns true once no further row is to begin: a signal asked for it (is_interrupted), the
  /// study's budget is spent, or a row could not be handed on. Asked before every row and every
  /// drawing of a batch.
  bool stopped() const;

  /// Returns how a drawing failed in the metrics phase, now or before; nothing if it can be drawn.
  /// Its rows of the other phases need not be tried.
  std::optional<RunRecord> failure(const PlannedInstance& instance, const PlannedRun& timed);

  /// Ends the session. @throws what the sink threw.
  void end();

 private:
  class Progress;
  bool is_budget_spent() const;

  const StudyPlan& plan_;
  const SessionPolicy& policy_;
  const RowSink& sink_;
  const std::unique_ptr<Progress> progress_;
  Stopwatch time_;
  const bool keeps_failures_;  // only where there are phases that ask
  std::mutex mutex_;
  std::unordered_map<std::string, RunRecord> failed_;  // by row key
  std::exception_ptr sink_failure_;
  std::atomic<bool> sink_failed_ = false;
};

/// Describes one row to make. Two jobs of one instance in a row have the same `instance`.
struct RowJob {
  std::size_t place = 0;  ///< of the instance in the plan
  std::shared_ptr<const PlannedInstance> instance;
  const PlannedRun* run = nullptr;  ///< one of instance->runs
  RowRequest request;
  std::size_t number = 0;  ///< for the source, whose own it is
};

/// Hands out the rows of a phase and takes them back. Called from several threads at once.
class RowSource {
 public:
  explicit RowSource(StudySession& session) : session_(session) {}
  virtual ~RowSource() = default;
  /// Returns the session whose rows these are.
  StudySession& session() const { return session_; }
  /// Returns the next row for the worker of that number; nothing: there is no more for it.
  virtual std::optional<RowJob> next(int worker) = 0;
  /// Takes a row that was handed out. What it throws ends the phase and is passed on.
  virtual void done(const RowJob& job, RunRecord row) = 0;
  /// Returns what is to be known of the phase when it is over, for the environment.
  virtual std::vector<EnvironmentEntry> ending() const { return {}; }

 private:
  StudySession& session_;
};

/// Says who makes the rows of a phase: threads of this process, or processes of their own.
struct WorkerPool {
  int workers = 1;
  int elsewhere = 0;            ///< workers of other processes of the study at the same time
  std::vector<int> cores = {};  ///< core of each; empty: none is pinned
};

/// Makes all rows of a source in processes of their own, so that a crash, a timeout or too much
/// memory costs one row: it gets the status, the process is replaced, the others go on. Rows have
/// the limits of the plan's budget. Those in flight are given up when the session is stopped. No
/// process outlives the call, nor a worker the caller's process; what a worker that has ended
/// leaves in its group ends at once, and what its programs leave in any. To be called while no
/// other thread runs.
void work_in_processes(RowSource& source, const WorkerPool& pool);

/// @throws InputError if the plan has timed rows and this build's times are worth little, if a
/// memory limit is asked of a sanitised build, or if there are fewer cores than timed drawings at
/// the same time, or fewer ranks than are to share a batch.
void require_possible(const StudyPlan& plan, const SessionPolicy& policy);

/// Makes the rows of a plan that the sink does not have, phase after phase: metrics, timing, strong
/// and weak scaling; keeps none of them. What goes wrong with a row is its status. In strong and
/// weak batches rows are not isolated; they are only made of drawings that came out before.
/// @throws InputError as require_possible; whatever the sink throws.
void run_session(const StudyPlan& plan, const SessionPolicy& policy, const RowSink& sink);

/// Returns whether there are rounds enough: how far the median of the first half of the values is
/// from that of the second (of an even number the upper one). Infinite for fewer than two.
double halves_difference(std::span<const double> values);

/// Makes the first phase of a study: every instance in one worker, its drawings certified,
/// repetitions in the outer loop.
std::unique_ptr<RowSource> metrics_source(StudySession& session);

/// Makes the second phase of a study: round after round over all drawings, one repetition of each a
/// round, so that what disturbs the machine for a while disturbs all alike: of a row of this phase
/// `repetition` is the round. Optional rounds are made until in 95 % of the drawings that have some
/// left halves_difference() of their times (log_corrected_time) is at most the precision. The first
/// row of a drawing is certified, the others must be the same drawing (its hash) and take over the
/// certificate.
std::unique_ptr<RowSource> timing_source(StudySession& session);

}  // namespace ar3d
