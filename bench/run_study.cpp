#include "ar3d/bench/run_study.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <omp.h>

#include <atomic>
#include <chrono>
#include <ctime>
#include <exception>
#include <mutex>
#include <optional>

#include "ar3d/bench/environment.h"
#include "ar3d/bench/progress.h"
#include "ar3d/results/sha256.h"

namespace ar3d {
namespace {

// What is left to do, without the rows that may turn out not to be needed.
struct Remaining {
  std::size_t rows = 0;
  double work = 0;
};

Remaining remaining_rows(const StudyPlan& plan, const FinishedRuns& finished) {
  Remaining remaining;
  for (const PlannedInstance& instance : plan.instances) {
    for (const PlannedRun& run : instance.runs) {
      if (run.optional || finished.contains(run.row_key)) continue;
      ++remaining.rows;
      remaining.work += work_of_row(instance);
    }
  }
  return remaining;
}

// The rows made so far and what is told about them; shared by all threads.
class Collector {
 public:
  Collector(const StudyPlan& plan, const FinishedRuns& finished,
            const std::function<void(const Run&)>& on_row)
      : rows_(plan.rows), work_(plan.rows), on_row_(on_row) {
    for (const PlannedInstance& instance : plan.instances) {
      for (const PlannedRun& run : instance.runs) {
        if (!run.optional) work_[run.row] = work_of_row(instance);
        const auto known = finished.find(run.row_key);
        if (known != finished.end()) rows_[run.row] = known->second;
      }
    }
  }

  void add(std::size_t row, Run run, Progress& progress) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (failure_) return;
    try {
      if (on_row_) on_row_(run);
    } catch (...) {  // noted before the lock is given up, so that no other row is told after it
      note(std::current_exception());
      return;
    }
    if (work_[row] > 0) progress.row_done(work_[row], run.status == RunStatus::ok);
    rows_[row] = std::move(run);
  }
  bool failed() const { return failed_; }

  std::vector<Run> take_rows() {
    if (failure_) std::rethrow_exception(failure_);
    std::vector<Run> rows;
    rows.reserve(rows_.size());
    for (std::optional<Run>& row : rows_) {
      if (row) rows.push_back(std::move(*row));
    }
    return rows;
  }

 private:
  void note(std::exception_ptr failure) {
    if (!failure_) failure_ = std::move(failure);
    failed_ = true;
  }

  std::mutex mutex_;
  std::vector<std::optional<Run>> rows_;
  std::vector<double> work_;  // of each row, 0 if the study is complete without it
  const std::function<void(const Run&)>& on_row_;
  std::exception_ptr failure_;
  std::atomic<bool> failed_ = false;
};

}  // namespace

std::vector<Run> run_plan(const StudyPlan& plan, const StudyOptions& options,
                          const FinishedRuns& finished,
                          const std::function<void(const Run&)>& on_row, const std::string& name) {
  const Remaining remaining = remaining_rows(plan, finished);
  Progress progress(options.progress, name, remaining.rows, remaining.work);
  Collector collector(plan, finished, on_row);
  RowHooks hooks;
  hooks.stop = [&] { return collector.failed() || (options.stop && options.stop->load()); };
  hooks.wanted = [&](const std::string& key) { return !finished.contains(key); };
  hooks.known = [&](const std::string& key) { return std::optional(finished.at(key)); };
  hooks.emit = [&](std::size_t row, Run run) { collector.add(row, std::move(run), progress); };
  MakingRules rules = options.making;
  rules.threads = options.threads > 0 ? options.threads : omp_get_max_threads();
  rules.timing = plan.timing;
  rules.budget = plan.budget;
  make_rows(plan, rules, hooks);
  progress.finish();
  return collector.take_rows();
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
