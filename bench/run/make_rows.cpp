#include "ar3d/bench/run/make_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "ar3d/base/error.h"
#include "ar3d/bench/measure/environment.h"
#include "ar3d/bench/measure/pinning.h"
#include "ar3d/bench/plan/work_order.h"
#include "ar3d/bench/run/metrics_phase.h"
#include "ar3d/bench/run/row_source.h"
#include "ar3d/bench/run/scaling_phase.h"
#include "ar3d/bench/run/timing_phase.h"

namespace ar3d {
namespace {

bool is_timed(RunPhase phase) { return phase != RunPhase::metrics; }
bool is_timing(RunPhase phase) { return phase == RunPhase::timing; }

void make(RowSource& source, const WorkerPool& pool) {
  const Making& making = source.making();
  if (making.policy().isolate || making.plan().budget.limits_rows()) {
    make_rows_in_workers(source, pool);
  } else {
    make_rows_in_threads(source, pool);
  }
}

void require_ranks(const StudyPlan& plan, int ranks) {
  for (const PlannedBlock& block : plan.instances.blocks()) {
    for (const PlannedRun& run : block.first.runs) {
      if (!is_over_ranks(run.phase) || run.scale <= ranks) continue;
      throw InputError(fmt::format("batches are to be shared by {} ranks of mpirun but there {} {}",
                                   run.scale, ranks == 1 ? "is" : "are", ranks));
    }
  }
}

// The last of the allowed cores: systems like to do their own work on the first.
std::vector<int> cores_for(std::uint32_t count) {
  const std::vector<int> allowed = allowed_cores();
  return {allowed.rbegin(), allowed.rbegin() + count};
}

}  // namespace

void require_makeable(const StudyPlan& plan, const MakingPolicy& policy) {
  const std::string_view mark = build_kind();
  if (mark == "sanitised" && plan.budget.row_memory_bytes) {
    throw InputError("budget.row_memory cannot be kept in a sanitised build");
  }
  if (!policy.timed_phases) return;
  if (!mark.empty() && !policy.force_timing && has_run(plan, is_timed)) {
    throw InputError(fmt::format("a {} build is not timed unless it is forced to", mark));
  }
  if (has_run(plan, is_timing) && plan.timing.concurrency > allowed_cores().size()) {
    throw InputError(fmt::format("timing.concurrency = {} but there are {} cores",
                                 plan.timing.concurrency, allowed_cores().size()));
  }
  require_ranks(plan, policy.ranks != nullptr ? policy.ranks->size() : 1);
}

MakingEnd make_rows(const StudyPlan& plan, const MakingPolicy& policy, RowSink& sink) {
  require_makeable(plan, policy);
  Making making(plan, policy, sink);
  make(*metrics_source(making),
       {.workers = policy.workers, .elsewhere = policy.workers_elsewhere, .cores = {}});
  if (policy.timed_phases && !making.stopped() && has_run(plan, is_timing)) {
    const std::uint32_t workers = plan.timing.concurrency;
    make(*timing_source(making),
         {.workers = static_cast<int>(workers), .elsewhere = 0, .cores = cores_for(workers)});
  }
  if (policy.timed_phases && !making.stopped()) run_batches(making);
  return making.end();
}

}  // namespace ar3d
