#include "ar3d/bench/run/make_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <string_view>
#include <unordered_map>

#include "ar3d/bench/measure/environment.h"
#include "ar3d/bench/measure/pinning.h"
#include "ar3d/bench/measure/stopwatch.h"
#include "ar3d/model/error.h"

namespace ar3d {
namespace {

bool has_phase(const StudyPlan& plan, const std::function<bool(RunPhase)>& is_meant) {
  const std::vector<PlannedBlock>& blocks = plan.instances.blocks();
  return std::any_of(blocks.begin(), blocks.end(),
                     [&](const PlannedBlock& block) { return has_run(block.first, is_meant); });
}

bool is_timed(RunPhase phase) { return phase != RunPhase::metrics; }

// The drawings that failed in the metrics phase, now or before, for the phases that come later.
class Failures {
 public:
  Failures(const RowHooks& hooks, bool are_needed) : hooks_(hooks), are_needed_(are_needed) {}

  void note(const RunRecord& run) {
    if (!are_needed_ || run.phase != RunPhase::metrics || is_drawn(run)) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    failed_.emplace(run.row_key, run);
  }

  std::optional<RunRecord> find(const PlannedInstance& instance, const PlannedRun& timed) {
    for (const PlannedRun& run : instance.runs) {
      if (run.phase != RunPhase::metrics || run.options != timed.options ||
          run.choice.algorithm != timed.choice.algorithm) {
        continue;
      }
      if (const auto row = row_of(run.row_key); row && !is_drawn(*row)) return row;
    }
    return std::nullopt;
  }

 private:
  std::optional<RunRecord> row_of(const std::string& key) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      const auto at = failed_.find(key);
      if (at != failed_.end()) return at->second;
    }
    const bool made_before = hooks_.wanted && hooks_.known && !hooks_.wanted(key);
    return made_before ? hooks_.known(key) : std::nullopt;
  }

  const RowHooks& hooks_;
  bool are_needed_;
  std::mutex mutex_;
  std::unordered_map<std::string, RunRecord> failed_;
};

void make(RowSource& source, const Crew& crew, bool isolate) {
  if (isolate) {
    make_rows_in_workers(source, crew);
  } else {
    make_rows_in_threads(source, crew);
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

bool has_run(const PlannedInstance& instance, const std::function<bool(RunPhase)>& is_meant) {
  return std::any_of(instance.runs.begin(), instance.runs.end(),
                     [&](const PlannedRun& run) { return is_meant(run.phase); });
}

void require_makeable(const StudyPlan& plan, const MakingRules& rules) {
  const std::string_view mark = timing_mark();
  if (mark == "sanitised" && rules.budget.row_memory_bytes) {
    throw InputError("budget.row_memory cannot be kept in a sanitised build");
  }
  if (!rules.timed_phases) return;
  if (!mark.empty() && !rules.force_timing && has_phase(plan, is_timed)) {
    throw InputError(fmt::format("a {} build is not timed unless it is forced to", mark));
  }
  const auto is_timing = [](RunPhase phase) { return phase == RunPhase::timing; };
  if (has_phase(plan, is_timing) && rules.timing.concurrency > allowed_cores().size()) {
    throw InputError(fmt::format("timing.concurrency = {} but there are {} cores",
                                 rules.timing.concurrency, allowed_cores().size()));
  }
  require_ranks(plan, rules.ranks != nullptr ? rules.ranks->size() : 1);
}

MakingEnd make_rows(const StudyPlan& plan, const MakingRules& rules, const RowHooks& hooks) {
  require_makeable(plan, rules);
  const Stopwatch time;
  const auto spent = [&] { return rules.budget.study_s && time.wall_s() >= *rules.budget.study_s; };
  const auto stop = [&] { return (hooks.stop && hooks.stop()) || spent(); };
  const bool isolate = rules.isolate || rules.budget.limits_rows();

  Failures failures(hooks, has_phase(plan, is_timed));
  RowHooks noting = hooks;
  noting.stop = stop;
  noting.emit = [&](std::size_t row, const RunRecord& run) {
    failures.note(run);
    hooks.emit(row, run);
  };
  const KnownFailure failure = [&](const PlannedInstance& instance, const PlannedRun& run) {
    return failures.find(instance, run);
  };

  make(
      *metrics_source(plan, noting),
      {.size = rules.threads, .neighbours = rules.neighbours, .budget = rules.budget, .stop = stop},
      isolate);
  if (rules.timed_phases && !stop() &&
      has_phase(plan, [](RunPhase phase) { return phase == RunPhase::timing; })) {
    make(*timing_source(plan, rules.timing, noting, failure),
         {.size = static_cast<int>(rules.timing.concurrency),
          .cores = cores_for(rules.timing.concurrency),
          .budget = rules.budget,
          .stop = stop},
         isolate);
  }
  if (rules.timed_phases && !stop()) run_batches(plan, rules, noting, failure);
  if (hooks.stop && hooks.stop()) return MakingEnd::stopped;
  return spent() ? MakingEnd::budget_spent : MakingEnd::complete;
}

}  // namespace ar3d
