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
  // @param maker  prepared for `instance`. @param runs  of it, a batch, whose rows in `share` are
  // drawn here.
  BatchRows(const RowMaker& maker, const PlannedInstance& instance,
            const std::vector<std::size_t>& runs, const std::vector<std::size_t>& share,
            std::uint32_t warm_ups, const std::function<bool()>& stop)
      : graph_(*maker.graph()),
        choice_(instance.runs[runs.front()].choice),
        warm_ups_(warm_ups),
        drawings_(share.size()),
        stop_(stop) {
    for (const std::size_t i : share) {
      rows_.push_back(maker.begun(instance.runs[runs[i]]));
      rows_.back().warm_ups = warm_ups;
    }
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
  const Stopwatch time;
  const std::vector<int> cores = allowed_cores();
  const bool pin = static_cast<std::size_t>(threads) <= cores.size();
  std::barrier start(threads);
  std::mutex mutex;
  double first_start_s = std::numeric_limits<double>::infinity(), last_end_s = 0;
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
      const double begun_s = time.seconds();
      while (rows.draw_next(core, counters)) {
      }
      const double ended_s = time.seconds();
      const std::lock_guard<std::mutex> lock(mutex);
      first_start_s = std::min(first_start_s, begun_s);
      last_end_s = std::max(last_end_s, ended_s);
    } catch (...) {
      if (!waited) start.arrive_and_wait();
      throw;
    }
  });
  return last_end_s - first_start_s;
}

// The rows of a batch at these places in the runs of an instance, which are of one drawing: in the
// order asked for, with the time of the batch and without verdict. Threads take the rows one by
// one, each thread on a core of its own if there are so many.
// @param maker  prepared for the instance. @throws InputError if the system starts fewer threads.
std::vector<RunRecord> shared_by_threads(int threads, const PlannedInstance& instance,
                                         const std::vector<std::size_t>& runs,
                                         const RowMaker& maker, const StudySession& session) {
  const std::function<bool()> stop = [&session] { return session.stopped(); };
  BatchRows batch(maker, instance, runs, indices_of_rank(0, 1, runs.size()),
                  session.plan().timing.warm_up, stop);
  const double wall_s = drawn_in_threads(batch, threads);
  std::vector<RunRecord> made = batch.take();
  for (RunRecord& row : made) row.batch_s = wall_s;
  return made;
}

// Makes a rank's part of a batch ready.
std::function<GetResult()> part_of_batch(const StudyPlan& plan, int rank, RowMaker& maker,
                                         const std::function<bool()>& stop,
                                         const std::string& job) {
  std::istringstream words(job);
  int count = 1;
  std::size_t index = 0;
  words >> count >> index;
  std::vector<std::size_t> runs;
  for (std::size_t run = 0; words >> run;) runs.push_back(run);
  const PlannedInstance& instance = maker.prepare(plan, index);
  if (maker.graph() == nullptr) {
    throw InternalError(
        fmt::format("internal error: rank {} cannot generate rank 0's graph", rank));
  }
  const auto batch = std::make_shared<BatchRows>(
      maker, instance, runs, indices_of_rank(rank, count, runs.size()), plan.timing.warm_up, stop);
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

// As shared_by_threads. Of r ranks, rank i draws the i-th row and every r-th after it; ranks stay
// where mpirun has put them. Nothing is sent while they draw. Called on rank 0, whose clock their
// time is taken from (Ranks::at_once). @throws InternalError what went wrong on a rank.
std::vector<RunRecord> shared_by_ranks(int count, std::size_t index,
                                       const std::vector<std::size_t>& runs, RowMaker& maker,
                                       const StudySession& session) {
  const std::function<bool()> stop = [&session] { return session.stopped(); };
  Ranks alone;
  Ranks* const ranks = session.policy().ranks;
  const auto& [wall_s, texts] =
      (ranks != nullptr ? *ranks : alone)
          .at_once(count, fmt::format("{} {} {}", count, index, fmt::join(runs, " ")),
                   [&](const std::string& job) {
                     return part_of_batch(session.plan(), 0, maker, stop, job);
                   });
  std::vector<RunRecord> made(runs.size());
  for (int rank = 0; rank < count; ++rank) {
    const std::string& text = texts[static_cast<std::size_t>(rank)];
    const std::vector<std::size_t> indices = indices_of_rank(rank, count, runs.size());
    const std::size_t size = row_message_size();
    expect(text.size() == indices.size() * size, "a rank sends its rows");
    for (std::size_t i = 0; i < indices.size(); ++i) {
      const std::string_view bytes(text.data() + i * size, size);
      expect(read_row_message(bytes, made[indices[i]]) == kDrawn, "a rank sends its rows whole");
      made[indices[i]].batch_s = wall_s;
    }
  }
  return made;
}

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

// The batches of one index, by growing number of workers.
void make_round(const PlannedInstance& instance, std::size_t index, const Batches& batches,
                const RunRecord& reference, StudySession& session, RowMaker& maker) {
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
    const int share = static_cast<int>(workers);
    maker.prepare(session.plan(), index);
    std::vector<RunRecord> made = is_over_ranks(phase)
                                      ? shared_by_ranks(share, index, rows, maker, session)
                                      : shared_by_threads(share, instance, rows, maker, session);
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
void make_batches_of(std::size_t index, StudySession& session, RowMaker& maker) {
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
        if (!reference) {
          maker.prepare(session.plan(), index);
          reference = maker.make_row(run);
        }
      }
      make_round(instance, index, batches, *reference, session, maker);
    }
  }
}

}  // namespace

MakeReady batch_parts(const StudyPlan& plan, int rank, const std::function<bool()>& stop) {
  return [&plan, rank, stop, maker = std::make_shared<RowMaker>()](const std::string& job) {
    return part_of_batch(plan, rank, *maker, stop, job);
  };
}

void make_batches(StudySession& session) {
  const StudyPlan& plan = session.plan();
  RowMaker maker;
  for (const PlannedBlock& block : plan.instances.blocks()) {
    if (!has_run(block.first, is_batched)) continue;
    for (std::size_t i = 0; i < block.count; ++i) {
      if (session.stopped()) return;
      make_batches_of(block.first_index + i, session, maker);
    }
  }
}

}  // namespace ar3d
