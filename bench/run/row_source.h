#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "ar3d/bench/plan/plan.h"
#include "ar3d/bench/run/make_row.h"
#include "ar3d/bench/spec/measures.h"
#include "ar3d/results/run_record.h"

namespace ar3d {

/// One row to make. Two jobs of one instance in a row have the same `instance`.
struct RowJob {
  std::size_t place = 0;  ///< of the instance in the plan
  std::shared_ptr<const PlannedInstance> instance;
  const PlannedRun* run = nullptr;  ///< one of instance->runs
  RowRequest request;
};

/// Hands out the rows of a phase and takes them back. Called from several threads at once.
class RowSource {
 public:
  explicit RowSource(const PlannedInstances& instances) : instances_(instances) {}
  virtual ~RowSource() = default;
  /// Of the plan whose rows these are.
  const PlannedInstances& instances() const { return instances_; }
  /// The next row for the thread or process number `slot`; nothing: there is no more for it.
  virtual std::optional<RowJob> next(int slot) = 0;
  /// Takes a row that was handed out. What it throws ends the phase and is passed on.
  virtual void done(const RowJob& job, RunRecord row) = 0;

 private:
  const PlannedInstances& instances_;
};

/// Who makes the rows of a phase.
struct Crew {
  int size = 1;                 ///< threads or processes
  int neighbours = 0;           ///< rows that other processes of the study make at the same time
  std::vector<int> cores = {};  ///< core of each; empty: none is pinned
  Budget budget = {};           ///< limits of a row; only processes keep them
  std::function<bool()> stop = {};  ///< asked before every row; may be empty
};

/// Makes all rows of a source in threads of this process, the calling one among them.
void make_rows_in_threads(RowSource& source, const Crew& crew);

/// Makes all rows of a source in processes of their own, so that a crash, a timeout or too much
/// memory costs one row: it gets the status, the process is replaced, the others go on. Rows in
/// flight are given up when stop says so. No process outlives the call, nor the caller's process.
/// To be called while no other thread runs.
void make_rows_in_workers(RowSource& source, const Crew& crew);

}  // namespace ar3d
