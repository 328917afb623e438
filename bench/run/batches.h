#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ar3d/bench/run/ranks.h"
#include "ar3d/bench/run/row_maker.h"
#include "ar3d/bench/run/session.h"

namespace ar3d {

/// Describes a batch as it came out: its rows without verdict, in the order asked for.
struct MadeBatch {
  double wall_s = 0;
  std::vector<RunRecord> rows;
};

/// Draws batches of equal drawings, shared by threads of this process or by ranks. Whoever shares
/// one draws its warm-ups first, then all begin at the same time; rows are hashed once the clock
/// has stopped.
class BatchDrawer {
 public:
  /// @param plan  the same on every rank; outlives this.
  /// @param stop  asked before every drawing of this process; once it is true, a batch has rows
  /// that were not drawn. Called by several threads at once.
  BatchDrawer(const StudyPlan& plan, int rank, std::function<bool()> stop);

  /// Returns the maker of the rows of an instance, whose graph is there.
  /// @param place  of the instance in the plan.
  RowMaker& maker_for(std::size_t place);

  /// Returns threads take the rows one by one, each thread on a core of its own if there are so
  /// many. The wall time is from the first thread's start to the last one's end.
  /// @param rows  places in the instance's runs; of one algorithm with the same options.
  /// @throws InputError if the system starts fewer threads.
  MadeBatch shared_by_threads(int threads, std::size_t place, const std::vector<std::size_t>& rows);

  /// Of r ranks, rank i draws the i-th row and every r-th after it; ranks stay where mpirun has put
  /// them. Nothing is sent while they draw. Called on rank 0, whose clock wall_s is taken from
  /// (DoneAtOnce). @throws InternalError what went wrong on a rank.
  MadeBatch shared_by_ranks(Ranks& ranks, int count, std::size_t place,
                            const std::vector<std::size_t>& rows);
  /// Makes this rank's part of a batch.
  Work make_ready(const std::string& job);

 private:
  const StudyPlan& plan_;
  const int rank_;
  const std::function<bool()> stop_;
  std::optional<std::size_t> place_;
  PlannedInstance instance_;  // at place_
  RowMaker maker_;            // prepared for it
};

/// Makes the last phase of a study, strong and weak scaling. The ideal of a batch is the one on a
/// single thread or rank of the same round: its time divided by how many share (strong) or its time
/// (weak).
void run_batches(StudySession& session);

}  // namespace ar3d
