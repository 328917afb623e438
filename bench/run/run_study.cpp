#include "ar3d/bench/run/run_study.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <omp.h>

#include <atomic>
#include <chrono>
#include <ctime>
#include <exception>
#include <mutex>
#include <optional>

#include "ar3d/bench/measure/environment.h"
#include "ar3d/bench/run/progress.h"
#include "ar3d/results/sha256.h"

namespace ar3d {
namespace {

// What is left to do, without the rows that may turn out not to be needed.
struct Remaining {
  std::size_t rows = 0;
  double work = 0;
};

Remaining remaining_rows(const StudyPlan& plan, const ExistingRows& existing) {
  Remaining remaining;
  const auto add = [&](const PlannedInstance& instance, std::size_t rows) {
    remaining.rows += rows;
    remaining.work += static_cast<double>(rows) * work_of_row(instance);
  };
  if (!existing.contains) {
    for (const PlannedBlock& block : plan.instances.blocks()) {
      add(block.first, block.count * required_runs(block.first));
    }
    return remaining;
  }
  for (const PlannedInstance& instance : plan.instances) {
    for (const PlannedRun& run : instance.runs) {
      if (!run.optional && !existing.contains(run.row_key)) add(instance, 1);
    }
  }
  return remaining;
}

// Work of a row, 0 if the study is complete without it.
double work_of(const StudyPlan& plan, std::size_t row) {
  const PlannedBlock& block = plan.instances.block_of_row(row);
  const PlannedInstance& instance = block.first;
  const bool optional = instance.runs[(row - block.first_row) % instance.runs.size()].optional;
  return optional ? 0 : work_of_row(instance);
}

// Tells new rows to the listener and the progress, one at a time; shared by all threads.
class Teller {
 public:
  Teller(const StudyPlan& plan, const RowListener& on_row, Progress& progress)
      : plan_(plan), on_row_(on_row), progress_(progress) {}

  void tell(std::size_t row, const RunRecord& run) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (failure_) return;
    try {
      on_row_(row, run);
    } catch (...) {  // noted before the lock is given up, so that no other row is told after it
      failure_ = std::current_exception();
      failed_ = true;
      return;
    }
    const double work = work_of(plan_, row);
    if (work > 0) progress_.row_done(work, run.status == RunStatus::ok);
  }
  bool failed() const { return failed_; }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::mutex mutex_;
  const StudyPlan& plan_;
  const RowListener& on_row_;
  Progress& progress_;
  std::exception_ptr failure_;
  std::atomic<bool> failed_ = false;
};

}  // namespace

MakingEnd make_plan(const StudyPlan& plan, const StudyOptions& options,
                    const ExistingRows& existing, const RowListener& on_row,
                    const std::string& name) {
  const Remaining remaining = remaining_rows(plan, existing);
  Progress progress(options.progress, name, remaining.rows, remaining.work);
  Teller teller(plan, on_row, progress);
  RowHooks hooks;
  hooks.stop = [&] { return teller.failed() || (options.stop && options.stop->load()); };
  hooks.wanted = [&](const std::string& key) {
    return !existing.contains || !existing.contains(key);
  };
  hooks.known = [&](const std::string& key) { return std::optional(existing.read(key)); };
  hooks.emit = [&](std::size_t row, const RunRecord& run) { teller.tell(row, run); };
  hooks.next_instance = options.next_instance;
  MakingRules rules = options.making;
  rules.threads = options.threads > 0 ? options.threads : omp_get_max_threads();
  rules.timing = plan.timing;
  rules.budget = plan.budget;
  const MakingEnd end = make_rows(plan, rules, hooks);
  progress.finish();
  teller.rethrow();
  return end;
}

std::vector<RunRecord> run_plan(const StudyPlan& plan, const StudyOptions& options,
                                const FinishedRuns& finished,
                                const std::function<void(const RunRecord&)>& on_row,
                                const std::string& name) {
  std::vector<std::optional<RunRecord>> rows(plan.rows());
  for (std::size_t place = 0; !finished.empty() && place < plan.instances.size(); ++place) {
    for (const PlannedRun& run : plan.instances[place].runs) {
      const auto known = finished.find(run.row_key);
      if (known != finished.end()) rows[run.row] = known->second;
    }
  }
  const ExistingRows existing{[&](const std::string& key) { return finished.contains(key); },
                              [&](const std::string& key) { return finished.at(key); }};
  const auto keep = [&](std::size_t row, const RunRecord& run) {
    if (on_row) on_row(run);
    rows[row] = run;
  };
  make_plan(plan, options, existing, keep, name);
  std::vector<RunRecord> made;
  for (std::optional<RunRecord>& row : rows) {
    if (row) made.push_back(std::move(*row));
  }
  return made;
}

std::string now_with_zone() {
  using namespace std::chrono;
  const auto now = system_clock::now().time_since_epoch();
  const auto seconds = duration_cast<std::chrono::seconds>(now);
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:06}+00:00",
                     fmt::gmtime(static_cast<std::time_t>(seconds.count())),
                     duration_cast<microseconds>(now - seconds).count());
}

Results describe_study(const StudySpec& spec, int threads) {
  Results results;
  results.study_id = spec.name;
  results.spec = spec.text;
  results.spec_sha256 = sha256(spec.text);
  results.source_hash = source_hash();
  results.dirty = source_is_dirty();
  results.dirty_hash = dirty_hash();
  results.created = now_with_zone();
  results.environment = capture_environment(threads > 0 ? threads : omp_get_max_threads());
  return results;
}

Results run_study(const StudySpec& spec, const StudyOptions& options) {
  const StudyPlan plan = plan_study(spec);
  Results results = describe_study(spec, options.threads);
  results.runs = run_plan(plan, options, {}, {}, spec.name);
  results.environment.push_back({"load_after", load_average()});
  return results;
}

}  // namespace ar3d
