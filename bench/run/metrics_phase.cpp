#include "ar3d/bench/run/metrics_phase.h"

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "ar3d/bench/plan/work_order.h"

namespace ar3d {
namespace {

std::vector<const PlannedRun*> runs_in_order(const PlannedInstance& instance,
                                             const Making& making) {
  std::vector<const PlannedRun*> runs;
  for (const PlannedRun& run : instance.runs) {
    if (run.phase == RunPhase::metrics && making.wants(run)) runs.push_back(&run);
  }
  std::stable_sort(runs.begin(), runs.end(), [](const PlannedRun* a, const PlannedRun* b) {
    return a->repetition < b->repetition;
  });
  return runs;
}

class MetricsSource final : public RowSource {
 public:
  explicit MetricsSource(Making& making) : RowSource(making), order_(making.plan()) {}

  std::optional<RowJob> next(int worker) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    Share& share = shares_[worker];
    while (share.next == share.runs.size()) {
      const std::optional<std::size_t> place = next_place();
      if (!place) return std::nullopt;
      share.place = *place;
      share.instance = std::make_shared<const PlannedInstance>(making().plan().instances[*place]);
      share.runs = runs_in_order(*share.instance, making());
      share.next = 0;
    }
    return RowJob{share.place, share.instance, share.runs[share.next++], {}};
  }

  void done(const RowJob& job, RunRecord row) override { making().add(*job.run, row); }

 private:
  // The instance that a worker has in hand and what is left to be done with it.
  struct Share {
    std::size_t place = 0;
    std::shared_ptr<const PlannedInstance> instance;
    std::vector<const PlannedRun*> runs;
    std::size_t next = 0;
  };

  std::optional<std::size_t> next_place() {
    if (const auto& next = making().policy().next_instance) return next();
    if (begun_ == order_.size()) return std::nullopt;
    return order_[begun_++];
  }

  std::mutex mutex_;
  LargestFirst order_;
  std::size_t begun_ = 0;
  std::map<int, Share> shares_;
};

}  // namespace

std::unique_ptr<RowSource> metrics_source(Making& making) {
  return std::make_unique<MetricsSource>(making);
}

}  // namespace ar3d
