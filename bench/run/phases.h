#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ar3d/bench/plan/plan.h"
#include "ar3d/bench/run/row_source.h"

namespace ar3d {

/// How the phases of a study talk with whoever keeps its rows. Each may be empty but emit; all are
/// called by several threads at once.
struct RowHooks {
  std::function<bool(const std::string& row_key)> wanted;  ///< whether to make a row; empty: all
  /// A row that exists already; asked for some that are not wanted.
  std::function<std::optional<RunRecord>(const std::string& row_key)> known;
  std::function<void(std::size_t row, const RunRecord& run)>
      emit;  ///< with its place in the results
  std::function<bool()> stop;
  /// Place in plan.instances of the next one for the metrics phase; empty: the largest first.
  std::function<std::optional<std::size_t>()> next_instance;
};

/// True if a run of the instance is of a phase that is meant.
bool has_run(const PlannedInstance& instance, const std::function<bool(RunPhase)>& is_meant);

/// The places of plan.instances, the most costly first; equally costly ones in the plan's order.
/// The plan outlives it.
class LargestFirst {
 public:
  explicit LargestFirst(const StudyPlan& plan);
  std::size_t size() const { return size_; }
  std::size_t operator[](std::size_t i) const;

 private:
  struct Part {
    const PlannedBlock* block = nullptr;
    std::size_t first = 0;  // of its instances, in this order
  };
  std::vector<Part> blocks_;
  std::size_t size_ = 0;
};

/// Work that a row is, in a unit that is roughly proportional to time.
double work_of_row(const PlannedInstance& instance);
/// Work of all its rows.
double work_of_instance(const PlannedInstance& instance);

/// How a drawing came out whose rows need not all be tried: nothing if it can be drawn.
using KnownFailure =
    std::function<std::optional<RunRecord>(const PlannedInstance& instance, const PlannedRun& run)>;

/// Metrics: every instance in one slot, its drawings certified, repetitions in the outer loop.
std::unique_ptr<RowSource> metrics_source(const StudyPlan& plan, const RowHooks& hooks);

/// Timing: round after round over all drawings, one repetition of each a round, so that what
/// disturbs the machine for a while disturbs all alike. The first row of a drawing is certified,
/// the others must be the same drawing (its hash) and take over the certificate.
std::unique_ptr<RowSource> timing_source(const StudyPlan& plan, const TimingRules& rules,
                                         const RowHooks& hooks, KnownFailure failure);

struct MakingRules;

/// Strong and weak scaling: batches of the same drawing shared by 1, ... threads or ranks. The
/// ideal of a batch is the one on a single thread or rank of the same round: its time divided by
/// how many share (strong) or its time (weak). Threads are pinned, each to a core of its own, if
/// there are so many; ranks stay where mpirun has put them.
void run_batches(const StudyPlan& plan, const MakingRules& rules, const RowHooks& hooks,
                 const KnownFailure& failure);

}  // namespace ar3d
