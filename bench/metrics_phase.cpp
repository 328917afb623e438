#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <numeric>

#include "ar3d/bench/phases.h"

namespace ar3d {
namespace {

std::deque<const PlannedRun*> runs_in_order(const PlannedInstance& instance,
                                            const RowHooks& hooks) {
  std::deque<const PlannedRun*> runs;
  for (const PlannedRun& run : instance.runs) {
    const bool wanted = !hooks.wanted || hooks.wanted(run.row_key);
    if (run.phase == RunPhase::metrics && wanted) runs.push_back(&run);
  }
  std::stable_sort(runs.begin(), runs.end(), [](const PlannedRun* a, const PlannedRun* b) {
    return a->repetition < b->repetition;
  });
  return runs;
}

class MetricsSource final : public RowSource {
 public:
  MetricsSource(const StudyPlan& plan, const RowHooks& hooks)
      : plan_(plan),
        hooks_(hooks),
        order_(hooks.next_instance ? std::vector<std::size_t>() : largest_first(plan)) {}

  std::optional<RowJob> next(int slot) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    Share& share = shares_[slot];
    while (share.runs.empty()) {
      const std::optional<std::size_t> place = next_place();
      if (!place) return std::nullopt;
      share.instance = &plan_.instances.at(*place);
      share.runs = runs_in_order(*share.instance, hooks_);
    }
    const PlannedRun* run = share.runs.front();
    share.runs.pop_front();
    return RowJob{share.instance, run, {}};
  }

  void done(const RowJob& job, Run row) override { hooks_.emit(job.run->row, std::move(row)); }

 private:
  // The instance that a slot has in hand and what is left to be done with it.
  struct Share {
    const PlannedInstance* instance = nullptr;
    std::deque<const PlannedRun*> runs;
  };

  std::optional<std::size_t> next_place() {
    if (hooks_.next_instance) return hooks_.next_instance();
    if (begun_ == order_.size()) return std::nullopt;
    return order_[begun_++];
  }

  const StudyPlan& plan_;
  const RowHooks& hooks_;
  std::mutex mutex_;
  std::vector<std::size_t> order_;
  std::size_t begun_ = 0;
  std::map<int, Share> shares_;
};

}  // namespace

// Drawing is linear in n, but certifying, which takes most of the time, grows like n^1.5 or faster;
// good enough for the order and the remaining time.
double work_of_row(const PlannedInstance& instance) {
  return 1000 + std::pow(static_cast<double>(instance.n), 1.5);
}

std::vector<std::size_t> largest_first(const StudyPlan& plan) {
  std::vector<std::size_t> order(plan.instances.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto work = [&](std::size_t i) {
    return work_of_row(plan.instances[i]) * static_cast<double>(plan.instances[i].runs.size());
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return work(a) > work(b); });
  return order;
}

std::unique_ptr<RowSource> metrics_source(const StudyPlan& plan, const RowHooks& hooks) {
  return std::make_unique<MetricsSource>(plan, hooks);
}

}  // namespace ar3d
