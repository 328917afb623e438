#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "ar3d/bench/plan/plan.h"
#include "ar3d/bench/run/make_row.h"
#include "ar3d/bench/run/making.h"
#include "ar3d/store/columns/run_record.h"

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
  explicit RowSource(Making& making) : making_(making) {}
  virtual ~RowSource() = default;
  /// Whose rows these are.
  Making& making() const { return making_; }
  /// The next row for the worker of that number; nothing: there is no more for it.
  virtual std::optional<RowJob> next(int worker) = 0;
  /// Takes a row that was handed out. What it throws ends the phase and is passed on.
  virtual void done(const RowJob& job, RunRecord row) = 0;

 private:
  Making& making_;
};

/// Who makes the rows of a phase: threads of this process, or processes of their own.
struct WorkerPool {
  int workers = 1;
  int elsewhere = 0;            ///< workers of other processes of the study at the same time
  std::vector<int> cores = {};  ///< core of each; empty: none is pinned
};

/// Makes all rows of a source in threads of this process, the calling one among them.
void make_rows_in_threads(RowSource& source, const WorkerPool& pool);

/// Makes all rows of a source in processes of their own, so that a crash, a timeout or too much
/// memory costs one row: it gets the status, the process is replaced, the others go on. Rows have
/// the limits of the plan's budget. Those in flight are given up when the making is stopped. No
/// process outlives the call, nor the caller's process. To be called while no other thread runs.
void make_rows_in_workers(RowSource& source, const WorkerPool& pool);

}  // namespace ar3d
