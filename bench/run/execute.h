#pragma once

#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "ar3d/bench/measure/instruments.h"
#include "ar3d/bench/run/row_maker.h"
#include "ar3d/bench/run/session.h"

namespace ar3d {

/// Holds what all phases of one session share: which rows are wanted, where they go, when to stop.
/// All references outlive it; its functions are called by several threads at once.
class StudySession {
 public:
  StudySession(const StudyPlan& plan, const SessionPolicy& policy, const RowSink& sink);
  ~StudySession();

  const StudyPlan& plan() const { return plan_; }
  const SessionPolicy& policy() const { return policy_; }

  bool wants(const PlannedRun& run) const;
  /// Returns the row of a run that is not wanted, since it is there.
  RunRecord known(const PlannedRun& run) const;

  /// Hands a row on. Once that has failed, rows are lost: the session stops.
  void add(const PlannedRun& run, const RunRecord& row);
  /// Tells what is to be known of the session.
  void note(const EnvironmentEntry& entry) const {
    if (sink_.note) sink_.note(entry);
  }

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
  std::shared_ptr<const PlannedInstance> instance;
  RowRequest request;
  std::size_t number = 0;  ///< for the source, whose own it is
  const PlannedRun& run() const { return instance->runs[request.run]; }
};

/// Hands out the rows of a phase and takes them back. Its functions are called by several threads
/// at once.
struct RowSource {
  StudySession& session;        ///< whose rows these are
  int workers = 1;              ///< that make its rows
  int elsewhere = 0;            ///< workers of other processes of the study at the same time
  std::vector<int> cores = {};  ///< of each worker; empty: none is pinned
  /// Returns the next row for the worker of that number; nothing: there is no more for it.
  std::function<std::optional<RowJob>(int worker)> next;
  /// Takes a row that was handed out. What it throws ends the phase and is passed on.
  std::function<void(const RowJob& job, RunRecord row)> done;

  /// Returns the core of that worker; -1: it has none to itself.
  int core_of(int worker) const {
    return cores.empty() ? -1 : cores.at(static_cast<std::size_t>(worker));
  }
  /// Returns the maker of that worker's rows.
  RowMaker maker(int worker, MemoryScope memory) const {
    return RowMaker(memory, workers + elsewhere, core_of(worker),
                    session.plan().budget.certify_memory_bytes);
  }
};

/// Makes all rows of a source: in threads of this process, the calling one among them, or by
/// work_in_processes if the policy asks for it or rows have limits.
void execute(const RowSource& source);

/// Makes all rows of a source in processes of their own, so that a crash, a timeout or too much
/// memory costs one row: it gets the status, the process is replaced, the others go on. Rows have
/// the limits of the plan's budget. Those in flight are given up when the session is stopped. No
/// process outlives the call, nor a worker the caller's process; what a worker that has ended
/// leaves in its group ends at once, and what its programs leave in any. To be called while no
/// other thread runs.
void work_in_processes(const RowSource& source);

/// Returns whether there are rounds enough: how far the median of the first half of the values is
/// from that of the second (of an even number the upper one). Infinite for fewer than two.
double halves_difference(std::span<const double> values);

/// Makes the first phase of a study: every instance in one worker, its drawings certified,
/// repetitions in the outer loop.
void make_metrics(StudySession& session);

/// Makes the second phase of a study: round after round over all drawings, one repetition of each a
/// round, so that what disturbs the machine for a while disturbs all alike: of a row of this phase
/// `repetition` is the round. Optional rounds are made until in 95 % of the drawings that have some
/// left halves_difference() of their times (log_corrected_time) is at most the precision. The first
/// row of a drawing is certified, the others must be the same drawing (its hash) and take over the
/// certificate. Each worker has one of the last of the allowed cores to itself.
void make_timing(StudySession& session);

/// Makes the last phase of a study, strong and weak scaling. The workers that share a batch draw its
/// warm-ups first, then all begin at the same time; rows are hashed once the clock has stopped. The
/// ideal of a batch is the one on a single thread or rank of the same round: its time divided by
/// how many share (strong) or its time (weak).
void make_batches(StudySession& session);

}  // namespace ar3d
