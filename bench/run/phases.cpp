#include "ar3d/bench/run/phases.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

#include "ar3d/base/error.h"
#include "ar3d/bench/plan/plan.h"

namespace ar3d {
namespace {

// The largest k with P(at most k - 1 of n fair coins show heads) <= 2.5 %: the interval from the
// k-th smallest to the k-th largest value has at least 95 % confidence. 0 if there is none.
std::size_t order_of_bound(std::size_t n) {
  double log_probability = -static_cast<double>(n) * std::log(2.0);  // of exactly k heads
  double sum = 0;
  for (std::size_t k = 0; k < n; ++k) {
    sum += std::exp(log_probability);
    if (sum > 0.025) return k;
    log_probability += std::log(static_cast<double>(n - k)) - std::log(static_cast<double>(k + 1));
  }
  return 0;
}

}  // namespace

double median_precision(std::vector<double> values) {
  const std::size_t n = values.size();
  const std::size_t bound = order_of_bound(n);
  if (bound == 0) return std::numeric_limits<double>::infinity();
  std::sort(values.begin(), values.end());
  const double median = (values[(n - 1) / 2] + values[n / 2]) / 2;
  if (!(median > 0)) return std::numeric_limits<double>::infinity();
  return (values[n - bound] - values[bound - 1]) / 2 / median;
}

namespace {

std::vector<const PlannedRun*> runs_in_order(const PlannedInstance& instance,
                                             const StudySession& session) {
  std::vector<const PlannedRun*> runs;
  for (const PlannedRun& run : instance.runs) {
    if (run.phase == RunPhase::metrics && session.wants(run)) runs.push_back(&run);
  }
  std::stable_sort(runs.begin(), runs.end(), [](const PlannedRun* a, const PlannedRun* b) {
    return a->repetition < b->repetition;
  });
  return runs;
}

class MetricsSource final : public RowSource {
 public:
  explicit MetricsSource(StudySession& session) : RowSource(session), order_(session.plan()) {}

  std::optional<RowJob> next(int worker) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    InstanceInHand& share = shares_[worker];
    while (share.next == share.runs.size()) {
      const std::optional<std::size_t> place = next_place();
      if (!place) return std::nullopt;
      share.place = *place;
      share.instance = std::make_shared<const PlannedInstance>(session().plan().instances[*place]);
      share.runs = runs_in_order(*share.instance, session());
      share.next = 0;
    }
    return RowJob{share.place, share.instance, share.runs[share.next++], {}};
  }

  void done(const RowJob& job, RunRecord row) override { session().add(*job.run, row); }

 private:
  // The instance that a worker has in hand and what is left to be done with it.
  struct InstanceInHand {
    std::size_t place = 0;
    std::shared_ptr<const PlannedInstance> instance;
    std::vector<const PlannedRun*> runs;
    std::size_t next = 0;
  };

  std::optional<std::size_t> next_place() {
    if (const auto& next = session().policy().next_instance) return next();
    if (begun_ == order_.size()) return std::nullopt;
    return order_[begun_++];
  }

  std::mutex mutex_;
  LargestFirst order_;
  std::size_t begun_ = 0;
  std::map<int, InstanceInHand> shares_;
};

}  // namespace

std::unique_ptr<RowSource> metrics_source(StudySession& session) {
  return std::make_unique<MetricsSource>(session);
}

namespace {

// One drawing's repetitions.
struct TimedDrawing {
  std::size_t place = 0;
  std::shared_ptr<const PlannedInstance> instance;
  std::deque<const PlannedRun*> left;  // rows not made yet, by repetition
  std::vector<double> times_s;
  std::optional<RunRecord> certified;

  bool needs_more() const {
    if (left.empty()) return false;
    const PlannedRun& next = *left.front();
    return !next.optional || median_precision(times_s) > next.precision;
  }
};

class TimingSource final : public RowSource {
 public:
  explicit TimingSource(StudySession& session) : RowSource(session), rules_(session.plan().timing) {
    for (const PlannedBlock& block : session.plan().instances.blocks()) {
      if (!has_run(block.first, [](RunPhase phase) { return phase == RunPhase::timing; })) continue;
      for (std::size_t i = 0; i < block.count; ++i) add_drawings(block.first_place + i);
    }
    for (std::size_t i = 0; i < drawings_.size(); ++i) {
      if (drawings_[i].needs_more()) round_.push_back(i);
    }
  }

  std::optional<RowJob> next(int) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    while (!round_.empty()) {
      const std::size_t place = round_.front();
      round_.pop_front();
      TimedDrawing& drawing = drawings_[place];
      if (const auto failed = session().failure(*drawing.instance, *drawing.left.front())) {
        fail_all(drawing, *failed);
        continue;
      }
      const PlannedRun* run = drawing.left.front();
      drawing.left.pop_front();
      in_hand_[run] = place;
      return RowJob{
          drawing.place, drawing.instance, run, {!drawing.certified, rules_.warm_up, rules_.write}};
    }
    return std::nullopt;
  }

  void done(const RowJob& job, RunRecord row) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    const std::size_t place = in_hand_.at(job.run);
    in_hand_.erase(job.run);
    TimedDrawing& drawing = drawings_[place];
    if (drawing.certified) {
      take_over_certificate(*drawing.certified, row);
    } else if (is_drawn(row)) {
      drawing.certified = row;
    }
    session().add(*job.run, row);
    if (!is_drawn(row)) {
      fail_all(drawing, row);
      return;
    }
    drawing.times_s.push_back(row.wall_s);
    if (drawing.needs_more()) round_.push_back(place);
  }

 private:
  // The drawings of an instance: runs of one algorithm and options follow each other in the plan.
  void add_drawings(std::size_t place) {
    const auto instance =
        std::make_shared<const PlannedInstance>(session().plan().instances[place]);
    const PlannedRun* previous = nullptr;
    for (const PlannedRun& run : instance->runs) {
      if (run.phase != RunPhase::timing) continue;
      const bool same = previous != nullptr && is_same_drawing(run, *previous);
      if (!same) {
        drawings_.emplace_back().instance = instance;
        drawings_.back().place = place;
      }
      previous = &run;
      if (session().wants(run)) {
        drawings_.back().left.push_back(&run);
      } else if (const RunRecord known = session().known(run); is_drawn(known)) {
        drawings_.back().times_s.push_back(known.wall_s);
      }
    }
  }

  // Every row that the study needs of a drawing that failed is a row that says so.
  void fail_all(TimedDrawing& drawing, const RunRecord& failed) {
    for (const PlannedRun* run : drawing.left) {
      if (run->optional) continue;
      session().add(*run, failed_row(*drawing.instance, *run, failed));
    }
    drawing.left.clear();
  }

  const TimingRules& rules_;
  std::mutex mutex_;
  std::vector<TimedDrawing> drawings_;
  std::deque<std::size_t> round_;  // places in drawings_ of those that wait for their turn
  std::unordered_map<const PlannedRun*, std::size_t> in_hand_;
};

}  // namespace

std::unique_ptr<RowSource> timing_source(StudySession& session) {
  return std::make_unique<TimingSource>(session);
}

}  // namespace ar3d
