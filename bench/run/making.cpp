#include "ar3d/bench/run/making.h"

#include <omp.h>

#include "ar3d/base/error.h"
#include "ar3d/bench/measure/interruption.h"
#include "ar3d/bench/plan/work_order.h"
#include "ar3d/bench/run/make_row.h"

namespace ar3d {
namespace {

// What is left to do, without the rows that may turn out not to be needed.
struct Remaining {
  std::size_t rows = 0;
  double work = 0;
};

Remaining remaining_rows(const StudyPlan& plan, const RowSink& sink) {
  Remaining remaining;
  if (!sink.has_any()) {  // without making a million instances for nothing
    for (const PlannedBlock& block : plan.instances.blocks()) {
      const std::size_t rows = block.count * required_runs(block.first);
      remaining.rows += rows;
      remaining.work += static_cast<double>(rows) * work_of_row(block.first);
    }
    return remaining;
  }
  for (const PlannedInstance& instance : plan.instances) {
    for (const PlannedRun& run : instance.runs) {
      if (run.optional || sink.has(run.row_key)) continue;
      ++remaining.rows;
      remaining.work += work_of_row(instance);
    }
  }
  return remaining;
}

Progress progress_of(const StudyPlan& plan, const MakingPolicy& policy, const RowSink& sink) {
  if (policy.progress == nullptr) return Progress(nullptr, policy.name, 0, 0);
  const Remaining remaining = remaining_rows(plan, sink);
  return Progress(policy.progress, policy.name, remaining.rows, remaining.work);
}

// Work of a row, which the plan knows by its place.
double work_at(const StudyPlan& plan, std::size_t place) {
  return work_of_row(plan.instances.block_of_row(place).first);
}

}  // namespace

int workers_for(int asked, int ranks) {
  if (asked > 0) return asked;
  return ranks > 1 ? 1 : omp_get_max_threads();
}

RunRecord RowSink::read(const std::string& row_key) const {
  throw InternalError("internal error: row " + row_key + " was never there");
}

Making::Making(const StudyPlan& plan, const MakingPolicy& policy, RowSink& sink)
    : plan_(plan),
      policy_(policy),
      sink_(sink),
      progress_(progress_of(plan, policy, sink)),
      has_any_(sink.has_any()),
      keeps_failures_(has_run(plan, [](RunPhase phase) { return phase != RunPhase::metrics; })) {}

void Making::add(const PlannedRun& run, const RunRecord& row) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (sink_failed_) return;
  if (keeps_failures_ && row.phase == RunPhase::metrics && !is_drawn(row)) {
    failed_.emplace(row.row_key, row);
  }
  try {
    sink_.add(run.row, row);
  } catch (...) {  // noted before the lock is given up, so that no other row goes there after it
    sink_failure_ = std::current_exception();
    sink_failed_ = true;
    return;
  }
  if (!run.optional && policy_.progress != nullptr) {
    progress_.row_done(work_at(plan_, run.row), row.status == RunStatus::ok);
  }
}

bool Making::is_budget_spent() const {
  return plan_.budget.study_s && time_.wall_s() >= *plan_.budget.study_s;
}

bool Making::stopped() const { return sink_failed_ || is_interrupted() || is_budget_spent(); }

std::optional<RunRecord> Making::failure(const PlannedInstance& instance, const PlannedRun& timed) {
  for (const PlannedRun& run : instance.runs) {
    if (run.phase != RunPhase::metrics || !is_same_drawing(run, timed)) continue;
    if (std::optional<RunRecord> row = failed_row_of(run)) return row;
  }
  return std::nullopt;
}

std::optional<RunRecord> Making::failed_row_of(const PlannedRun& run) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto at = failed_.find(run.row_key);
    if (at != failed_.end()) return at->second;
  }
  if (wants(run)) return std::nullopt;
  RunRecord before = known(run);
  if (is_drawn(before)) return std::nullopt;
  return before;
}

MakingEnd Making::end() {
  progress_.finish();
  if (sink_failure_) std::rethrow_exception(sink_failure_);
  if (is_interrupted()) return MakingEnd::stopped;
  return is_budget_spent() ? MakingEnd::budget_spent : MakingEnd::complete;
}

}  // namespace ar3d
