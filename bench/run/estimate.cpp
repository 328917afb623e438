// Tells before a study begins what it will cost. Small sizes are drawn in processes of their own,
// with limits; larger sizes follow by a power law.
#include "ar3d/bench/run/estimate.h"

#include <fmt/format.h>
#include <malloc.h>

#include <fstream>
#include <new>

#include "ar3d/base/error.h"
#include "ar3d/base/system_calls.h"
#include "ar3d/bench/corpus/corpus.h"
#include "ar3d/bench/measure/cores.h"
#include "ar3d/bench/measure/environment.h"
#include "ar3d/bench/measure/instruments.h"
#include "ar3d/bench/measure/processes.h"
#include "ar3d/bench/run/row_maker.h"

namespace ar3d {
namespace {

constexpr std::uint64_t kSizeRatio = 6;
// What callgrind makes of a drawing, and what it takes beside it, the sweep of the cache above all.
constexpr double kCountedTimes = 100, kCountedAlwaysSeconds = 0.03, kCountingStartSeconds = 2;

// Far beyond what is measured, the caches make the power law another one.
std::uint64_t calibration_size(std::uint64_t largest) {
  constexpr std::uint64_t kUsual = 3000;
  constexpr std::uint64_t kMost = 33333;
  return std::min(largest, std::clamp(largest / 30, kUsual, kMost));
}

// What a row of n vertices takes; no time at all if that is unknown.
struct RowCosts {
  double n = 0;
  double row_s = 0;
  double draw_s = 0;
  double bytes = 0;
};
using CostModel = std::function<RowCosts(std::uint64_t n)>;

// Times and bytes at the larger calibration size * (n / that size)^exponent. Where the choice names
// a space, bytes grow as it, and times as n times its root: about as measured for routed drawings.
CostModel model_through(const RowCosts& small, const RowCosts& large,
                        const AlgorithmChoice& choice) {
  const auto exponent = [&](double RowCosts::*value) {
    if (large.n <= small.n || small.*value <= 0 || large.*value <= 0) return 1.0;
    return std::clamp(std::log(large.*value / (small.*value)) / std::log(large.n / small.n), 1.0,
                      2.5);
  };
  return [=, of_row = exponent(&RowCosts::row_s), of_drawing = exponent(&RowCosts::draw_s),
          of_bytes = exponent(&RowCosts::bytes)](std::uint64_t wanted) {
    const double ratio = std::max(static_cast<double>(wanted), 1.0) / std::max(large.n, 1.0);
    double row = std::pow(ratio, of_row), drawing = std::pow(ratio, of_drawing);
    double bytes = std::pow(ratio, of_bytes);
    if (large.n > 0 && choice.algorithm->space) {
      const auto& space = choice.algorithm->space;
      bytes = space(choice.options, wanted) /
              space(choice.options, static_cast<std::uint64_t>(large.n));
      row = drawing = ratio * std::sqrt(bytes);
      bytes = std::max(bytes, ratio);
    }
    return RowCosts{0, large.row_s * row, large.draw_s * drawing,
                    std::max(0.0, large.bytes) * bytes};
  };
}

// The better of two goes, the first of which pays for cold caches, unless that is nothing beside
// it. CPU time, since what else runs now says nothing about when the study runs.
RowCosts measured_here(const PlannedInstance& instance, const PlannedRun& run,
                       const Budget& budget) {
  constexpr double kLong_s = 1;
  const OneThread one_thread;
  RowCosts best;
  best.row_s = std::numeric_limits<double>::infinity();
  for (int go = 0; go < 2 && (go == 0 || best.row_s < kLong_s); ++go) {
    malloc_trim(0);  // else what is freed hides what is used
    RowMaker maker(MemoryScope::row, 1, -1, budget.certify_memory_bytes);
    RowMemory memory(MemoryScope::row);
    const std::int64_t before = memory.begin_row();
    const Stopwatch time(kCpuTime);
    maker.prepare(instance);
    const RunRecord row = maker.make_row(run, {.bisect = false});  // which few rows seek
    const double seconds = time.seconds();
    if (row.status == RunStatus::out_of_memory) throw std::bad_alloc();
    if (!is_drawn(row)) return {};
    const auto used = static_cast<double>(row.peak_bytes - std::min(before, row.base_bytes));
    best.n = static_cast<double>(row.n);
    best.row_s = std::min(best.row_s, seconds);
    best.draw_s = go == 0 ? row.cpu_s : std::min(best.draw_s, row.cpu_s);
    best.bytes = std::max(best.bytes, used);
  }
  return best;
}

std::string passed(RunStatus end, const Budget& budget, std::uint64_t n) {
  if (end == RunStatus::timeout) {
    return fmt::format("twice budget.row_time_s ({:.3g} s)", (*budget.row_time_s)(n));
  }
  if (!budget.row_memory_bytes) return "this machine's memory";
  return fmt::format("twice budget.row_memory_bytes ({})",
                     bytes_text((*budget.row_memory_bytes)(n)));
}

// In a process of its own, which may use twice what the study gives such a row: where that does not
// do, the row is impossible. Smaller rows of the same kind may be possible; the plan has larger
// ones.
RowCosts measured_at(const PlannedInstance& like, const PlannedRun& run, std::uint64_t requested_n,
                     const Budget& budget) {
  PlannedInstance instance = like;
  instance.requested_n = requested_n;
  if (const auto& corpus = like.choice.corpus) {  // one of that size, or a piece of a larger one
    const std::uint32_t limit = run.choice.algorithm->guarantee.max_degree;
    instance.index = corpus->index(corpus->first_of_size(requested_n, limit));
  }
  const std::uint64_t n = like.choice.family->nearest_n(requested_n, like.choice.parameters);
  std::optional<double> cpu_s;
  double memory_bytes = available_memory();
  if (budget.row_time_s) cpu_s = 2 * (*budget.row_time_s)(n) + 1;
  if (budget.row_memory_bytes) {
    memory_bytes = std::min(memory_bytes, 2 * (*budget.row_memory_bytes)(n));
  }
  RowCosts measured;
  static_assert(std::is_trivially_copyable_v<RowCosts>);
  const RunStatus end = run_within(cpu_s, memory_bytes, bytes_in(measured),
                                   [&] { measured = measured_here(instance, run, budget); });
  if (end == RunStatus::ok) return measured;
  if (end == RunStatus::crashed) return {};  // the row will say why
  throw InputError(
      fmt::format("{} {}n={} with {} {} would exceed its budget: a trial took more than {}",
                  like.choice.family->name, like.parameters.empty() ? "" : like.parameters + " ", n,
                  run.choice.algorithm->name, run.options, passed(end, budget, n)));
}

// @param calibration_n  raised to the largest size that was drawn.
CostModel calibrated(const PlannedInstance& instance, const PlannedRun& run, std::uint64_t largest,
                     const Budget& budget, std::uint64_t& calibration_n) {
  constexpr double kSlow_s = 0.3;  // such drawings are known from smaller ones
  // What a program costs is not known before.
  if (run.choice.program) return model_through({}, {}, {});
  const auto measured = [&](std::uint64_t size) {
    const RowCosts costs = measured_at(instance, run, size, budget);
    if (costs.row_s > 0) calibration_n = std::max(calibration_n, size);
    return costs;
  };
  const auto smaller = [](std::uint64_t size) {
    return std::max<std::uint64_t>(1, size / kSizeRatio);
  };
  const auto through = [&](const RowCosts& small, const RowCosts& large) {
    return model_through(small, large, run.choice);
  };
  const std::uint64_t size = calibration_size(largest);
  const RowCosts small = measured(smaller(size));
  const bool is_slow = small.row_s > kSlow_s;  // its exponents are larger at larger sizes
  if (is_slow && largest > size) return through(small, measured(2 * smaller(size)));
  if (is_slow) return through(measured(smaller(smaller(size))), small);
  const auto n_of = [&](std::uint64_t wanted) {
    return instance.choice.family->nearest_n(wanted, instance.choice.parameters);
  };
  return through(small, n_of(size) == n_of(smaller(size)) ? small : measured(size));
}

class Estimator {
 public:
  explicit Estimator(const StudyPlan& plan) : plan_(plan) {
    for (const PlannedBlock& block : plan.instances.blocks()) {
      for (const PlannedRun& run : block.first.runs) {
        std::uint64_t& largest = largest_[curve_of(block.first, run)];
        largest = std::max(largest, block.first.requested_n);
      }
    }
  }

  StudyEstimate run(int threads) {
    for (std::size_t i = 0; i < plan_.instances.blocks().size(); ++i) {
      const PlannedInstance first = plan_.instances[plan_.instances.blocks()[i].first_index];
      for (const PlannedRun& run : first.runs) add(i, first, run);
    }
    result_.wall_s = phase_s_[RunPhase::metrics] / threads +
                     phase_s_[RunPhase::timing] / plan_.timing.concurrency +
                     phase_s_[RunPhase::strong] + phase_s_[RunPhase::weak] +
                     phase_s_[RunPhase::strong_ranks] + phase_s_[RunPhase::weak_ranks];
    result_.threads = threads;
    if (result_.counting_s > 0) result_.counting_s += kCountingStartSeconds;
    return std::move(result_);
  }

 private:
  // A run of every instance of a block.
  void add(std::size_t block, const PlannedInstance& instance, const PlannedRun& run) {
    const std::size_t count = plan_.instances.blocks()[block].count;
    if (run.optional) {
      result_.optional_rows += count;
      return;
    }
    result_.rows += count;
    CellEstimate& cell = cell_of(instance, run);
    cell.rows += count;
    if (!cell.is_known) result_.unknown_rows += count;
    if (counted_.emplace(&cell - result_.cells.data(), block).second) cell.instances += count;
    if (run.phase == RunPhase::metrics && run.repetition == 0 &&
        cell.n <= std::uint64_t{kLargestCounted}) {
      result_.counting_s +=
          (kCountedAlwaysSeconds + kCountedTimes * cell.draw_s) * static_cast<double>(count);
    }
    const double seconds = cost_of(cell, run) * static_cast<double>(count);
    cell.total_s += seconds;
    phase_s_[run.phase] += seconds;
  }

  // A metrics row and the first timed one are certified; other timed ones are only drawn, after
  // their warm-ups.
  double cost_of(const CellEstimate& cell, const PlannedRun& run) const {
    const bool certified = run.phase == RunPhase::metrics || run.repetition == 0;
    const double warm_ups = run.phase == RunPhase::timing ? plan_.timing.warm_up : 0;
    return (certified ? cell.row_s : cell.draw_s) + warm_ups * cell.draw_s;
  }

  CellEstimate& cell_of(const PlannedInstance& instance, const PlannedRun& run) {
    const CurveKey curve = curve_of(instance, run);
    const auto [at, is_new] = indices_.try_emplace({curve, instance.n}, result_.cells.size());
    if (is_new) {
      const RowCosts costs = model_of(curve, instance, run)(instance.n);
      CellEstimate cell;
      cell.curve = curve;
      cell.n = instance.n;
      cell.is_known = costs.row_s > 0;
      cell.row_s = costs.row_s;
      cell.draw_s = costs.draw_s;
      cell.row_bytes = costs.bytes;
      result_.largest_row_bytes = std::max(result_.largest_row_bytes, cell.row_bytes);
      result_.cells.push_back(std::move(cell));
    }
    return result_.cells[at->second];
  }

  // Of a family with very many parameters only the first few are drawn; the costliest of them
  // stands for the others.
  const CostModel& model_of(const CurveKey& curve, const PlannedInstance& instance,
                            const PlannedRun& run) {
    const auto known = models_.find(curve);
    if (known != models_.end()) return known->second;
    constexpr std::size_t kMost = 16;
    std::vector<const CostModel*>& alike =
        by_family_[{curve.algorithm, curve.options, curve.family, {}, curve.level}];
    if (alike.size() >= kMost) {
      return **std::max_element(alike.begin(), alike.end(),
                                [&](const CostModel* a, const CostModel* b) {
                                  return (*a)(instance.n).row_s < (*b)(instance.n).row_s;
                                });
    }
    const CostModel& model = models_
                                 .emplace(curve, calibrated(instance, run, largest_.at(curve),
                                                            plan_.budget, result_.calibration_n))
                                 .first->second;
    alike.push_back(&model);
    return model;
  }

  const StudyPlan& plan_;
  StudyEstimate result_;
  std::map<CurveKey, std::uint64_t> largest_;
  std::map<CurveKey, CostModel> models_;
  std::map<CurveKey, std::vector<const CostModel*>> by_family_;  // without parameters
  std::map<std::pair<CurveKey, std::uint64_t>, std::size_t> indices_;
  std::set<std::pair<std::ptrdiff_t, std::size_t>> counted_;  // instances of a cell, by block
  std::map<RunPhase, double> phase_s_;
};

std::string seconds_text(double seconds) { return fmt::format("{:.3g} s", seconds); }

void refuse_above(const CellEstimate& cell, double estimated, double limit,
                  std::string (*text)(double), const std::string& what) {
  if (estimated <= limit) return;
  throw InputError(fmt::format("{} is estimated at {}, {} {}",
                               cell_label(cell.curve, static_cast<std::int64_t>(cell.n)),
                               text(estimated), what, text(limit)));
}

// The largest rows that may be made at the same time.
void refuse_together(const StudyEstimate& estimate, double memory_bytes) {
  std::vector<const CellEstimate*> cells;
  for (const CellEstimate& cell : estimate.cells) cells.push_back(&cell);
  std::stable_sort(cells.begin(), cells.end(), [](const CellEstimate* a, const CellEstimate* b) {
    return a->row_bytes > b->row_bytes;
  });
  auto left = static_cast<std::size_t>(estimate.threads);
  double bytes = 0;
  for (const CellEstimate* cell : cells) {
    const std::size_t at_once = std::min(left, cell->rows);
    bytes += cell->row_bytes * static_cast<double>(at_once);
    left -= at_once;
  }
  if (bytes <= memory_bytes) return;
  throw InputError(
      fmt::format("the largest rows, made {} at a time, are estimated at {}, but this machine has "
                  "{}: --threads can be fewer",
                  estimate.threads, bytes_text(bytes), bytes_text(memory_bytes)));
}

}  // namespace

StudyEstimate estimate(const StudyPlan& plan, int threads) { return Estimator(plan).run(threads); }

std::string bytes_text(double bytes) {
  constexpr const char* kUnits[] = {"bytes", "kB", "MB", "GB", "TB", "PB"};
  std::size_t unit = 0;
  for (; bytes >= 999.5 && unit + 1 < std::size(kUnits); ++unit) bytes /= 1000;
  return fmt::format("{:.3g} {}", bytes, kUnits[unit]);
}

double available_memory() {
  double bytes = 1024 * std::atof(proc_value("/proc/meminfo", "MemTotal").c_str());
  if (bytes == 0) bytes = std::numeric_limits<double>::infinity();
  double limit = 0;
  if (std::ifstream("/sys/fs/cgroup/memory.max") >> limit) bytes = std::min(bytes, limit);
  return bytes;
}

void refuse_impossible(const StudyPlan& plan, const StudyEstimate& estimate, double memory_bytes) {
  for (const CellEstimate& cell : estimate.cells) {
    refuse_above(cell, cell.row_bytes, memory_bytes, bytes_text, "but this machine has");
    if (plan.budget.row_memory_bytes) {
      refuse_above(cell, cell.row_bytes / 2, (*plan.budget.row_memory_bytes)(cell.n), bytes_text,
                   "even halved, but budget.row_memory_bytes gives");
    }
    if (plan.budget.row_time_s) {
      refuse_above(cell, cell.row_s / 2, (*plan.budget.row_time_s)(cell.n), seconds_text,
                   "even halved, but budget.row_time_s gives");
    }
  }
  refuse_together(estimate, memory_bytes);
}

}  // namespace ar3d
