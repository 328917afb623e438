#pragma once

#include "ar3d/bench/run/phases.h"
#include "ar3d/bench/run/ranks.h"

namespace ar3d {

/// How the rows of a study are made.
struct MakingRules {
  int threads = 1;            ///< rows at the same time in the metrics phase
  bool isolate = false;       ///< each row in a worker process; so it is too where rows have limits
  bool force_timing = false;  ///< time even in a build whose times are worth little
  bool timed_phases = true;   ///< false: only the metrics phase (another process does the others)
  int neighbours = 0;         ///< rows that other processes make meanwhile in the metrics phase
  Ranks* ranks = nullptr;     ///< that batches are shared by; null: this process is alone
  TimingRules timing;
  Budget budget;
};

/// @throws InputError if the plan has timed rows and this build's times are worth little, if a
/// memory limit is asked of a sanitised build, or if there are fewer cores than timed drawings at
/// the same time, or fewer ranks than are to share a batch.
void require_makeable(const StudyPlan& plan, const MakingRules& rules);

/// Why make_rows came back.
enum class MakingEnd { complete, stopped, budget_spent };

/// Makes the rows of a plan, phase after phase: metrics, timing, strong and weak scaling. What goes
/// wrong with a row is its status. In strong and weak batches rows are not isolated; they are only
/// made of drawings that came out before.
/// @throws InputError as require_makeable; whatever a hook throws.
MakingEnd make_rows(const StudyPlan& plan, const MakingRules& rules, const RowHooks& hooks);

}  // namespace ar3d
