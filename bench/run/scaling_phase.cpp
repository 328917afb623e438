#include "ar3d/bench/run/scaling_phase.h"

#include <algorithm>
#include <atomic>
#include <barrier>
#include <chrono>
#include <map>
#include <mutex>
#include <system_error>

#include "ar3d/base/parallel.h"
#include "ar3d/bench/measure/one_thread.h"
#include "ar3d/bench/measure/pinning.h"
#include "ar3d/bench/plan/work_order.h"
#include "ar3d/bench/run/rank_batch.h"

namespace ar3d {
namespace {

using Clock = std::chrono::steady_clock;
using Rows = std::vector<const PlannedRun*>;

// The rows of one drawing in one phase: batch -> threads or ranks -> rows.
using Rounds = std::map<std::uint32_t, std::map<std::int64_t, Rows>>;

struct BatchedDrawing {
  RunPhase phase = RunPhase::strong;
  Rounds rounds;
};

std::vector<BatchedDrawing> batched_drawings(const PlannedInstance& instance) {
  std::vector<BatchedDrawing> drawings;
  const PlannedRun* previous = nullptr;
  for (const PlannedRun& run : instance.runs) {
    if (run.scale < 0) continue;
    const bool same =
        previous != nullptr && run.phase == previous->phase && is_same_drawing(run, *previous);
    if (!same) drawings.push_back({run.phase, {}});
    previous = &run;
    drawings.back().rounds[run.batch][run.scale].push_back(&run);
  }
  return drawings;
}

// One batch: its threads take the drawings one by one.
class ThreadBatch {
 public:
  ThreadBatch(const Graph& graph, const TimingRules& rules, const Rows& rows,
              const RunRecord& begun, const Making& making)
      : graph_(graph),
        rules_(rules),
        rows_(rows),
        making_(making),
        results_(rows.size(), begun),
        drawings_(rows.size()) {}

  // Wall time from the first thread's start, which all wait for, to the last thread's end.
  double run(int threads) {
    const std::vector<int> cores = allowed_cores();
    const bool pin = static_cast<std::size_t>(threads) <= cores.size();
    std::barrier start(threads);
    std::optional<InputError> missing;
    in_threads(
        static_cast<std::uint32_t>(threads),
        [&](std::uint32_t i) { work(pin ? cores[cores.size() - 1 - i] : -1, start); },
        [&](std::uint32_t, const std::system_error& error) {
          missing = cannot_start_threads(threads, error);
          start.arrive_and_drop();  // those that began wait for all
        });
    if (missing) throw *missing;
    return std::chrono::duration<double>(last_end_ - first_start_).count();
  }

  // The rows, without verdict. The drawings are hashed now, outside the clock.
  std::vector<RunRecord> take_rows() {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (drawings_[i]) results_[i].drawing_hash = drawing_hash(*drawings_[i]);
      drawings_[i].reset();
    }
    return std::move(results_);
  }

 private:
  void work(int core, std::barrier<>& start) {
    bool waited = false;
    try {
      const OneThread one_thread;
      const Pinning pinning(core);
      HardwareCounters counters;
      const AlgorithmChoice& choice = rows_.front()->choice;
      for (std::uint32_t i = 0; i < rules_.warm_up && !making_.stopped(); ++i) {
        draw(*choice.algorithm, graph_, choice.options);
      }
      start.arrive_and_wait();
      waited = true;
      const Clock::time_point begun = Clock::now();
      for (std::size_t i = next_++; i < rows_.size() && !making_.stopped(); i = next_++) {
        draw_row(i, core, counters);
      }
      const Clock::time_point ended = Clock::now();
      const std::lock_guard<std::mutex> lock(mutex_);
      first_start_ = std::min(first_start_, begun);
      last_end_ = std::max(last_end_, ended);
    } catch (...) {
      if (!waited) start.arrive_and_wait();
      throw;
    }
  }

  void draw_row(std::size_t i, int core, HardwareCounters& counters) {
    RunRecord& run = results_[i];
    run.core = core;
    run.warm_ups = rules_.warm_up;
    attempt(run, [&] {
      drawings_[i] = timed_drawing(graph_, rows_[i]->choice, counters, run);
      run.status = RunStatus::ok;
    });
  }

  const Graph& graph_;
  const TimingRules& rules_;
  const Rows& rows_;
  const Making& making_;
  std::vector<RunRecord> results_;
  std::vector<std::optional<Drawing>> drawings_;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;
  Clock::time_point first_start_ = Clock::time_point::max();
  Clock::time_point last_end_ = Clock::time_point::min();
};

// All batches of one instance.
class InstanceBatches {
 public:
  /// @param place  of the instance in the plan.
  InstanceBatches(const PlannedInstance& instance, std::size_t place, Making& making,
                  RankBatches& rank_batches)
      : instance_(instance), place_(place), making_(making), rank_batches_(rank_batches) {}

  void run() {
    for (const BatchedDrawing& drawing : batched_drawings(instance_)) {
      std::optional<RunRecord> reference;
      for (const auto& [number, batches] : drawing.rounds) {
        if (making_.stopped()) return;
        if (!any_wanted(batches)) continue;
        if (!reference) reference = certified(*batches.begin()->second.front());
        run_round(drawing.phase, batches, *reference);
      }
    }
  }

 private:
  bool any_wanted(const std::map<std::int64_t, Rows>& batches) const {
    return std::any_of(batches.begin(), batches.end(), [&](const auto& batch) {
      return std::any_of(batch.second.begin(), batch.second.end(),
                         [&](const PlannedRun* run) { return making_.wants(*run); });
    });
  }

  // The drawing certified, outside every batch; or how it failed.
  RunRecord certified(const PlannedRun& run) {
    if (std::optional<RunRecord> failed = making_.failure(instance_, run)) return *failed;
    if (maker_.graph() == nullptr) maker_.prepare(instance_);
    return maker_.make(run);
  }

  void run_round(RunPhase phase, const std::map<std::int64_t, Rows>& batches,
                 const RunRecord& reference) {
    double single_s = kMissing;
    for (const auto& [scale, rows] : batches) {
      if (making_.stopped()) return;
      if (!is_drawn(reference)) {
        for (const PlannedRun* run : rows) emit(*run, failed_row(instance_, *run, reference));
        continue;
      }
      MadeBatch made = is_over_ranks(phase) ? shared_by_ranks(static_cast<int>(scale), rows)
                                            : shared_by_threads(static_cast<int>(scale), rows);
      if (making_.stopped()) return;  // it may not have been drawn to its end
      if (scale == 1) single_s = made.wall_s;
      const double ideal_s = is_strong(phase) ? single_s / static_cast<double>(scale) : single_s;
      for (std::size_t i = 0; i < rows.size(); ++i) {
        RunRecord& row = made.rows[i];
        row.row_key = rows[i]->row_key;
        row.repetition = rows[i]->repetition;
        row.concurrency = scale;
        row.batch_s = made.wall_s;
        row.ideal_batch_s = ideal_s;
        row.efficiency = ideal_s / made.wall_s;
        take_over_certificate(reference, row);
        emit(*rows[i], row);
      }
    }
  }

  MadeBatch shared_by_threads(int threads, const Rows& rows) {
    ThreadBatch batch(*maker_.graph(), making_.plan().timing, rows, maker_.begun(*rows.front()),
                      making_);
    const double wall_s = batch.run(threads);
    return {wall_s, batch.take_rows()};
  }

  MadeBatch shared_by_ranks(int count, const Rows& rows) {
    std::vector<std::size_t> places;
    for (const PlannedRun* run : rows) {
      places.push_back(static_cast<std::size_t>(run - instance_.runs.data()));
    }
    Ranks alone;
    Ranks* const ranks = making_.policy().ranks;
    return rank_batches_.make(ranks != nullptr ? *ranks : alone, count, place_, places);
  }

  void emit(const PlannedRun& run, const RunRecord& row) {
    if (making_.wants(run)) making_.add(run, row);
  }

  const PlannedInstance& instance_;
  const std::size_t place_;
  Making& making_;
  RankBatches& rank_batches_;
  RowMaker maker_{{.concurrency = 1, .core = -1, .memory = MemoryScope::process}};
};

}  // namespace

void run_batches(Making& making) {
  const StudyPlan& plan = making.plan();
  RankBatches rank_batches(plan, plan.timing, 0, [&making] { return making.stopped(); });
  for (const PlannedBlock& block : plan.instances.blocks()) {
    if (!has_run(block.first, is_batched)) continue;
    for (std::size_t i = 0; i < block.count; ++i) {
      if (making.stopped()) return;
      const std::size_t place = block.first_place + i;
      const PlannedInstance instance = plan.instances[place];
      InstanceBatches(instance, place, making, rank_batches).run();
    }
  }
}

}  // namespace ar3d
