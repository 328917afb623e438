#include "ar3d/bench/run/timing_phase.h"

#include <deque>
#include <memory>
#include <mutex>
#include <unordered_map>

#include "ar3d/base/error.h"
#include "ar3d/bench/plan/work_order.h"
#include "ar3d/bench/run/precision.h"

namespace ar3d {
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
  explicit TimingSource(Making& making) : RowSource(making), rules_(making.plan().timing) {
    for (const PlannedBlock& block : making.plan().instances.blocks()) {
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
      if (const auto failed = making().failure(*drawing.instance, *drawing.left.front())) {
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
    making().add(*job.run, row);
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
    const auto instance = std::make_shared<const PlannedInstance>(making().plan().instances[place]);
    const PlannedRun* previous = nullptr;
    for (const PlannedRun& run : instance->runs) {
      if (run.phase != RunPhase::timing) continue;
      const bool same = previous != nullptr && is_same_drawing(run, *previous);
      if (!same) {
        drawings_.emplace_back().instance = instance;
        drawings_.back().place = place;
      }
      previous = &run;
      if (making().wants(run)) {
        drawings_.back().left.push_back(&run);
      } else if (const RunRecord known = making().known(run); is_drawn(known)) {
        drawings_.back().times_s.push_back(known.wall_s);
      }
    }
  }

  // Every row that the study needs of a drawing that failed is a row that says so.
  void fail_all(TimedDrawing& drawing, const RunRecord& failed) {
    for (const PlannedRun* run : drawing.left) {
      if (run->optional) continue;
      making().add(*run, failed_row(*drawing.instance, *run, failed));
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

std::unique_ptr<RowSource> timing_source(Making& making) {
  return std::make_unique<TimingSource>(making);
}

}  // namespace ar3d
