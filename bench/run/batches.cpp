// Strong and weak scaling. Threads and ranks share one kind of batch: warm-ups, one barrier, one
// drawing after the other, and the hashes outside the clock; they differ in who hands out the rows
// and whose clock it is.
#include <fmt/ranges.h>

#include <barrier>
#include <sstream>

#include "ar3d/base/error.h"
#include "ar3d/base/parallel.h"
#include "ar3d/bench/measure/cores.h"
#include "ar3d/bench/run/execute.h"
#include "ar3d/bench/run/row_maker.h"

namespace ar3d {
namespace {

constexpr char kDrawn = 'd';

// The indices that one rank draws of the rows of a batch which `count` ranks share.
std::vector<std::size_t> indices_of_rank(int rank, int count, std::size_t rows) {
  std::vector<std::size_t> indices;
  for (auto i = static_cast<std::size_t>(rank); i < rows; i += static_cast<std::size_t>(count)) {
    indices.push_back(i);
  }
  return indices;
}

// Rows of one drawing that a process draws for a batch.
class BatchRows {
 public:
  BatchRows(const Graph& graph, const AlgorithmChoice& choice, std::uint32_t warm_ups,
            std::vector<RunRecord> begun, const std::function<bool()>& stop)
      : graph_(graph),
        choice_(choice),
        warm_ups_(warm_ups),
        rows_(std::move(begun)),
        drawings_(rows_.size()),
        stop_(stop) {
    for (RunRecord& row : rows_) row.warm_ups = warm_ups;
  }

  void warm_up() const {
    for (std::uint32_t i = 0; i < warm_ups_ && !stop_(); ++i) {
      draw(*choice_.algorithm, graph_, choice_.options);
    }
  }

  /// Draws the next row that is not begun. False: there is none, or the study stops.
  bool draw_next(int core, HardwareCounters& counters) {
    const std::size_t i = next_++;
    if (i >= rows_.size() || stop_()) return false;
    RunRecord& row = rows_[i];
    row.core = core;
    attempt(row, [&] {
      drawings_[i] = timed_drawing(graph_, choice_, counters, row);
      row.status = RunStatus::ok;
    });
    return true;
  }

  /// The rows with the hashes of their drawings.
  std::vector<RunRecord> take() {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (drawings_[i]) rows_[i].drawing_hash = drawing_hash(*drawings_[i]);
      drawings_[i].reset();
    }
    return std::move(rows_);
  }

 private:
  const Graph& graph_;
  const AlgorithmChoice& choice_;
  const std::uint32_t warm_ups_;
  std::vector<RunRecord> rows_;
  std::vector<std::optional<Drawing>> drawings_;
  const std::function<bool()>& stop_;
  std::atomic<std::size_t> next_ = 0;
};

// Draws all rows of a batch in threads that begin at the same time. Returns the wall time from the
// first thread's start, which all wait for, to the last thread's end.
double drawn_in_threads(BatchRows& rows, int threads) {
  using Clock = std::chrono::steady_clock;
  const std::vector<int> cores = allowed_cores();
  const bool pin = static_cast<std::size_t>(threads) <= cores.size();
  std::barrier start(threads);
  std::mutex mutex;
  Clock::time_point first_start = Clock::time_point::max();
  Clock::time_point last_end = Clock::time_point::min();
  in_threads(static_cast<std::uint32_t>(threads), [&](std::uint32_t i) {
    const int core = pin ? cores[cores.size() - 1 - i] : -1;
    bool waited = false;
    try {
      const OneThread one_thread;
      const Pinning pinning(core);
      HardwareCounters counters;
      rows.warm_up();
      start.arrive_and_wait();
      waited = true;
      const Clock::time_point begun = Clock::now();
      while (rows.draw_next(core, counters)) {
      }
      const Clock::time_point ended = Clock::now();
      const std::lock_guard<std::mutex> lock(mutex);
      first_start = std::min(first_start, begun);
      last_end = std::max(last_end, ended);
    } catch (...) {
      if (!waited) start.arrive_and_wait();
      throw;
    }
  });
  return std::chrono::duration<double>(last_end - first_start).count();
}

// Draws batches of equal drawings, shared by threads of this process or by ranks: gives their rows
// in the order asked for, with the time of the batch and without verdict.
class BatchDrawer {
 public:
  BatchDrawer(const StudyPlan& plan, int rank, std::function<bool()> stop)
      : plan_(plan), rank_(rank), stop_(std::move(stop)) {}

  // The maker of the rows of the instance at that index of the plan, whose graph is there.
  RowMaker& maker_for(std::size_t index) {
    if (index_ != index) {
      instance_ = plan_.instances[index];
      maker_.prepare(instance_);
      index_ = index;
    }
    return maker_;
  }

  // Threads take the rows one by one, each thread on a core of its own if there are so many.
  // `rows` are indices in the instance's runs; of one algorithm with the same options.
  // @throws InputError if the system starts fewer threads.
  std::vector<RunRecord> shared_by_threads(int threads, std::size_t index,
                                           const std::vector<std::size_t>& rows) {
    RowMaker& maker = maker_for(index);
    const PlannedRun& first = instance_.runs[rows.front()];
    BatchRows batch(*maker.graph(), first.choice, plan_.timing.warm_up,
                    std::vector<RunRecord>(rows.size(), maker.begun(first)), stop_);
    const double wall_s = drawn_in_threads(batch, threads);
    std::vector<RunRecord> made = batch.take();
    for (RunRecord& row : made) row.batch_s = wall_s;
    return made;
  }

  // Of r ranks, rank i draws the i-th row and every r-th after it; ranks stay where mpirun has put
  // them. Nothing is sent while they draw. Called on rank 0, whose clock their time is taken
  // from (Ranks::at_once). @throws InternalError what went wrong on a rank.
  std::vector<RunRecord> shared_by_ranks(Ranks& ranks, int count, std::size_t index,
                                         const std::vector<std::size_t>& rows) {
    const std::string job = fmt::format("{} {} {}", count, index, fmt::join(rows, " "));
    const auto& [wall_s, told] =
        ranks.at_once(count, job, [&](const std::string& text) { return make_ready(text); });
    std::vector<RunRecord> made(rows.size());
    for (int rank = 0; rank < count; ++rank) {
      const std::string& text = told[static_cast<std::size_t>(rank)];
      const std::vector<std::size_t> indices = indices_of_rank(rank, count, rows.size());
      const std::size_t size = row_message_size();
      expect(text.size() == indices.size() * size, "a rank tells its rows");
      for (std::size_t i = 0; i < indices.size(); ++i) {
        const std::string_view bytes(text.data() + i * size, size);
        expect(read_row_message(bytes, made[indices[i]]) == kDrawn, "a rank tells its rows whole");
        made[indices[i]].batch_s = wall_s;
      }
    }
    return made;
  }

  // Makes this rank's part of a batch.
  std::function<Tell()> make_ready(const std::string& job) {
    std::istringstream words(job);
    int count = 1;
    std::size_t index = 0;
    words >> count >> index;
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; words >> row;) rows.push_back(row);
    const RowMaker& maker = maker_for(index);
    if (maker.graph() == nullptr) {
      throw InternalError(
          fmt::format("internal error: rank {} cannot generate rank 0's graph", rank_));
    }
    std::vector<RunRecord> begun;
    for (const std::size_t i : indices_of_rank(rank_, count, rows.size())) {
      begun.push_back(maker.begun(instance_.runs[rows[i]]));
    }
    const auto batch =
        std::make_shared<BatchRows>(*maker.graph(), instance_.runs[rows.front()].choice,
                                    plan_.timing.warm_up, std::move(begun), stop_);
    batch->warm_up();
    const auto counters = std::make_shared<HardwareCounters>();
    return [batch, counters] {
      while (batch->draw_next(-1, *counters)) {
      }
      return [batch] {
        std::string text;
        for (const RunRecord& row : batch->take()) text += row_message(kDrawn, row);
        return text;
      };
    };
  }

 private:
  const StudyPlan& plan_;
  const int rank_;
  const std::function<bool()> stop_;
  std::optional<std::size_t> index_;
  PlannedInstance instance_;  // at index_
  RowMaker maker_;            // prepared for it
};

// Places of runs, by threads or ranks.
using Batches = std::map<std::int64_t, std::vector<std::size_t>>;

// Of each drawing in each phase the batches, by their number.
std::vector<std::map<std::uint32_t, Batches>> batched_drawings(const PlannedInstance& instance) {
  std::vector<std::map<std::uint32_t, Batches>> drawings;
  const PlannedRun* previous = nullptr;
  for (std::size_t i = 0; i < instance.runs.size(); ++i) {
    const PlannedRun& run = instance.runs[i];
    if (run.workers < 0) continue;
    const bool same =
        previous != nullptr && run.phase == previous->phase && is_same_drawing(run, *previous);
    if (!same) drawings.emplace_back();
    previous = &run;
    drawings.back()[run.batch][run.workers].push_back(i);
  }
  return drawings;
}

std::vector<RunRecord> drawn(RunPhase phase, int workers, std::size_t index,
                             const std::vector<std::size_t>& rows, StudySession& session,
                             BatchDrawer& drawer) {
  if (!is_over_ranks(phase)) return drawer.shared_by_threads(workers, index, rows);
  Ranks alone;
  Ranks* const ranks = session.policy().ranks;
  return drawer.shared_by_ranks(ranks != nullptr ? *ranks : alone, workers, index, rows);
}

// The batches of one index, by growing number of workers.
void make_round(const PlannedInstance& instance, std::size_t index, const Batches& batches,
                const RunRecord& reference, StudySession& session, BatchDrawer& drawer) {
  const RunPhase phase = instance.runs[batches.begin()->second.front()].phase;
  const auto emit = [&](const PlannedRun& run, const RunRecord& row) {
    if (session.wants(run)) session.add(run, row);
  };
  double single_s = kMissing;
  for (const auto& [workers, rows] : batches) {
    if (session.stopped()) return;
    if (!is_drawn(reference)) {
      for (const std::size_t i : rows) {
        emit(instance.runs[i], failed_row(instance, instance.runs[i], reference));
      }
      continue;
    }
    std::vector<RunRecord> made =
        drawn(phase, static_cast<int>(workers), index, rows, session, drawer);
    if (session.stopped()) return;  // it may not have been drawn to its end
    if (workers == 1) single_s = made.front().batch_s;
    const double ideal_s = is_strong(phase) ? single_s / static_cast<double>(workers) : single_s;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const PlannedRun& run = instance.runs[rows[i]];
      RunRecord& row = made[i];
      row.row_key = run.row_key;
      row.repetition = run.repetition;
      row.concurrency = workers;
      row.ideal_batch_s = ideal_s;
      row.efficiency = ideal_s / row.batch_s;
      take_over_certificate(reference, row);
      emit(run, row);
    }
  }
}

// All batches of the instance at that index of the plan.
void make_batches_of(std::size_t index, StudySession& session, BatchDrawer& drawer) {
  const PlannedInstance instance = session.plan().instances[index];
  const auto wants = [&](std::size_t i) { return session.wants(instance.runs[i]); };
  for (const auto& rounds : batched_drawings(instance)) {
    std::optional<RunRecord> reference;  // certified outside every batch, or its failure
    for (const auto& [number, batches] : rounds) {
      if (session.stopped()) return;
      const bool any_wanted = std::ranges::any_of(
          batches, [&](const auto& batch) { return std::ranges::any_of(batch.second, wants); });
      if (!any_wanted) continue;
      if (!reference) {
        const PlannedRun& run = instance.runs[batches.begin()->second.front()];
        reference = session.failure(instance, run);
        if (!reference) reference = drawer.maker_for(index).make_row(run);
      }
      make_round(instance, index, batches, *reference, session, drawer);
    }
  }
}

}  // namespace

MakeReady batch_parts(const StudyPlan& plan, int rank, const std::function<bool()>& stop) {
  const auto drawer = std::make_shared<BatchDrawer>(plan, rank, stop);
  return [drawer](const std::string& job) { return drawer->make_ready(job); };
}

void make_batches(StudySession& session) {
  const StudyPlan& plan = session.plan();
  BatchDrawer drawer(plan, 0, [&session] { return session.stopped(); });
  for (const PlannedBlock& block : plan.instances.blocks()) {
    if (!has_run(block.first, is_batched)) continue;
    for (std::size_t i = 0; i < block.count; ++i) {
      if (session.stopped()) return;
      make_batches_of(block.first_index + i, session, drawer);
    }
  }
}

}  // namespace ar3d
