#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ar3d/bench/run/make_row.h"
#include "ar3d/bench/run/ranks.h"

namespace ar3d {

/// A batch as it came out: its rows without verdict, in the order asked for.
struct MadeBatch {
  double wall_s = 0;
  std::vector<RunRecord> rows;
};

/// Batches of equal drawings that ranks share. Of r ranks, rank i draws the i-th row and every r-th
/// after it; every one has generated the graph and drawn its warm-ups before all begin. Nothing is
/// sent while they draw.
class RankBatches {
 public:
  /// @param plan  the same on every rank; outlives this.
  /// @param stop  asked before every drawing of this rank; once it is true, a batch has rows that
  /// were not drawn.
  RankBatches(const StudyPlan& plan, const TimingRules& rules, int rank,
              std::function<bool()> stop);

  /// On rank 0, whose clock wall_s is taken from (DoneAtOnce).
  /// @param place  of the instance in the plan.
  /// @param rows  places in the instance's runs; of one algorithm with the same options.
  /// @throws InternalError what went wrong on a rank.
  MadeBatch make(Ranks& ranks, int count, std::size_t place, const std::vector<std::size_t>& rows);

  /// This rank's part of a batch.
  Work make_ready(const std::string& job);

 private:
  struct Job;
  struct Share;
  void draw(Share& share);

  const StudyPlan& plan_;
  const TimingRules rules_;
  const int rank_;
  const std::function<bool()> stop_;
  std::size_t place_ = 0;
  std::optional<PlannedInstance> instance_;  // at place_
  RowMaker maker_;
  HardwareCounters counters_;
};

}  // namespace ar3d
