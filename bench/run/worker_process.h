#pragma once

#include <string>

#include "ar3d/base/system_calls.h"
#include "ar3d/bench/run/session.h"

namespace ar3d {

/// Holds how a worker process ended: "killed by signal 11 (Segmentation fault)", …
struct WorkerEnd {
  RunStatus status = RunStatus::crashed;
  std::string message;
};

/// Represents a forked process that makes rows for its parent. It ends with this object.
class WorkerProcess {
 public:
  /// @param plan  whose rows it will make, within its budget.
  /// @param core  the core it is pinned to, or -1.
  /// @throws InputError if the system has no process or descriptor left.
  WorkerProcess(const StudyPlan& plan, const WorkerPool& pool, int core);

  /// Hands out a row. False if the process is gone.
  bool send(const RowJob& job);

  /// Says what a worker tells of the row it has.
  enum class News {
    none,     ///< nothing yet
    begun,    ///< the graph is there, the row itself begins; row() is what is known of it
    made,     ///< row() is the row
    garbage,  ///< what has come is no message of a worker
    is_gone,  ///< the process has ended: end()
  };
  /// Reads the next thing that has come; never waits.
  News read_news();
  const RunRecord& row() const { return row_; }

  /// Returns CPU time of the process so far; the largest double once it has ended.
  double cpu_s() const;

  /// Returns the descriptor that becomes readable with news.
  int descriptor() const { return child_.socket(); }

  /// Returns how it ended, after is_gone.
  WorkerEnd end();

 private:
  Child child_;
  long long oom_kills_before_ = 0;
  std::string received_;
  bool hung_up_ = false;
  RunRecord row_;
};

/// Makes all rows of a source in processes of their own, so that a crash, a timeout or too much
/// memory costs one row: it gets the status, the process is replaced, the others go on. Rows have
/// the limits of the plan's budget. Those in flight are given up when the session is stopped. No
/// process outlives the call, nor a worker the caller's process; what a worker that has ended
/// leaves in its group ends at once, and what its programs leave in any. To be called while no other
/// thread runs.
void work_in_processes(RowSource& source, const WorkerPool& pool);

}  // namespace ar3d
