#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "ar3d/bench/run/phases.h"
#include "ar3d/model/error.h"

namespace ar3d {
namespace {

std::vector<const PlannedRun*> runs_in_order(const PlannedInstance& instance,
                                             const RowHooks& hooks) {
  std::vector<const PlannedRun*> runs;
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
      : RowSource(plan.instances), hooks_(hooks), order_(plan) {}

  std::optional<RowJob> next(int slot) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    Share& share = shares_[slot];
    while (share.next == share.runs.size()) {
      const std::optional<std::size_t> place = next_place();
      if (!place) return std::nullopt;
      share.place = *place;
      share.instance = std::make_shared<const PlannedInstance>(instances()[*place]);
      share.runs = runs_in_order(*share.instance, hooks_);
      share.next = 0;
    }
    return RowJob{share.place, share.instance, share.runs[share.next++], {}};
  }

  void done(const RowJob& job, RunRecord row) override { hooks_.emit(job.run->row, row); }

 private:
  // The instance that a slot has in hand and what is left to be done with it.
  struct Share {
    std::size_t place = 0;
    std::shared_ptr<const PlannedInstance> instance;
    std::vector<const PlannedRun*> runs;
    std::size_t next = 0;
  };

  std::optional<std::size_t> next_place() {
    if (hooks_.next_instance) return hooks_.next_instance();
    if (begun_ == order_.size()) return std::nullopt;
    return order_[begun_++];
  }

  const RowHooks& hooks_;
  std::mutex mutex_;
  LargestFirst order_;
  std::size_t begun_ = 0;
  std::map<int, Share> shares_;
};

}  // namespace

// Drawing is linear in n; certifying, which takes most of the time, sorts. The constant is what a
// row of no vertices takes.
double work_of_row(const PlannedInstance& instance) {
  const auto n = static_cast<double>(instance.n);
  return 200 + n * std::log2(n + 1);
}

double work_of_instance(const PlannedInstance& instance) {
  return work_of_row(instance) * static_cast<double>(instance.runs.size());
}

LargestFirst::LargestFirst(const StudyPlan& plan) {
  for (const PlannedBlock& block : plan.instances.blocks()) blocks_.push_back({&block, 0});
  std::stable_sort(blocks_.begin(), blocks_.end(), [](const Part& a, const Part& b) {
    return work_of_instance(a.block->first) > work_of_instance(b.block->first);
  });
  for (Part& part : blocks_) {
    part.first = size_;
    size_ += part.block->count;
  }
}

std::size_t LargestFirst::operator[](std::size_t i) const {
  expect(i < size_, "an order has that place");
  const auto behind =
      std::upper_bound(blocks_.begin(), blocks_.end(), i,
                       [](std::size_t wanted, const Part& part) { return wanted < part.first; });
  const Part& part = *std::prev(behind);
  return part.block->first_place + (i - part.first);
}

std::unique_ptr<RowSource> metrics_source(const StudyPlan& plan, const RowHooks& hooks) {
  return std::make_unique<MetricsSource>(plan, hooks);
}

}  // namespace ar3d
