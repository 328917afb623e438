// Times of two files: in units of yardsticks, settings against all others.
#include "ar3d/analysis/compare/file_times.h"

#include <fmt/format.h>

#include <algorithm>

namespace ar3d {
namespace {

constexpr double kRobust = 1.4826;     // standard deviation by the median absolute deviation
constexpr double kOfMedian = 1.2533;   // standard error of a median by that of a mean
constexpr double kErrors = 2;          // standard errors that an interval is wide on either side
constexpr double kLeastError = 0.003;  // of a build's place in memory
constexpr double kFelt = 0.3;          // of a state of the machine settings feel this share unlike
constexpr double kAsFast = 0.025;      // log of a factor of the machine that is not worth a word
constexpr double kMemoryAsFast = 0.1;  // that of its memory, whose yardstick is noisier
constexpr double kPlaced = 6;          // thresholds by which its place in memory may move one graph
constexpr double kAlone = 10;          // residuals by which a single cell has to move
constexpr double kNoise = 6;           // residuals within which it has not moved,
constexpr double kMostNoise = 1.5;     // but never more than this times the threshold

/// Robust standard deviation about 0.
double spread_about_zero(std::vector<double> values) {
  for (double& value : values) value = std::abs(value);
  return kRobust * median(std::move(values));
}

/// Returns the standard error of the median of independent values; infinite for none.
double error_of_median(std::vector<double> values) {
  const double middle = median(values);
  const double root = std::sqrt(static_cast<double>(values.size()));
  for (double& value : values) value -= middle;
  return kOfMedian * spread_about_zero(std::move(values)) / root;
}

SettingTimes setting_of(const std::vector<const CellTimes*>& cells) {
  SettingTimes setting;
  setting.name = cells.front()->setting;
  setting.cells = cells.size();
  std::vector<double> ratios, spreads, residuals;
  std::array<std::vector<double>, 2> halves;
  for (const CellTimes* cell : cells) {
    ratios.push_back(cell->ratio);
    spreads.push_back(cell->spread);
    for (std::size_t side = 0; side < 2; ++side) halves[side].push_back(cell->halves[side]);
  }
  setting.ratio = median(ratios);
  for (const double ratio : ratios) residuals.push_back(ratio - setting.ratio);
  const double spread = std::max(spread_about_zero(residuals), median(spreads));
  const double of_cells = kOfMedian * spread / std::sqrt(static_cast<double>(cells.size()));
  setting.error = kErrors * std::hypot(of_cells, kLeastError);
  return setting;
}

/// The rules of docs/analysis.md, "Then times", in their order.
class FileJudge {
 public:
  FileJudge(const std::vector<CellTimes>& cells, const CompareOptions& rule)
      : cells_(cells), limit_(std::log1p(rule.threshold)) {
    for (const CellTimes& cell : cells) {
      if (cell.rounds == 0) continue;
      const auto [index, is_new] = index_of_.try_emplace(cell.setting, by_setting_.size());
      if (is_new) by_setting_.emplace_back();
      by_setting_[index->second].push_back(&cell);
    }
  }

  FileTimes judged(const std::array<double, 3>& yardsticks) {
    std::vector<double> ratios;
    for (const auto& of_setting : by_setting_) {
      times_.settings.push_back(setting_of(of_setting));
      ratios.push_back(times_.settings.back().ratio);
    }
    times_.yardsticks = yardsticks;
    has_others_ = ratios.size() >= kFewestSettings;
    if (has_others_) times_.common = median(ratios);
    measure_machine();
    measure_residual();
    for (std::size_t i = 0; i < by_setting_.size(); ++i) judge_setting(i);
    for (const CellTimes& cell : cells_) {
      times_.cells.push_back(change_of_cell(cell));
      times_.errors.push_back(cell.rounds == 0 ? kMissing : error_of_cell(cell));
    }
    return std::move(times_);
  }

 private:
  /// Missing yardsticks say nothing against it.
  void measure_machine() {
    const double machine = (times_.yardsticks[0] + times_.yardsticks[2]) / 2;
    times_.machine = std::isnan(machine) ? 0 : machine;
    contention_ = std::isnan(machine) ? 0 : times_.yardsticks[0] - times_.yardsticks[2];
    times_.is_known = std::abs(has_others_ ? times_.common : times_.machine) <= limit_ / 2;
  }

  void measure_residual() {
    std::vector<double> residuals;
    for (std::size_t i = 0; i < by_setting_.size(); ++i) {
      for (const CellTimes* cell : by_setting_[i]) {
        residuals.push_back(cell->ratio - times_.settings[i].ratio);
        for (std::size_t side = 0; side < 2; ++side) drifts_[side].push_back(cell->halves[side]);
      }
    }
    num_timed_ = residuals.size();
    times_.residual = spread_about_zero(std::move(residuals));
  }

  void judge_setting(std::size_t index) {
    SettingTimes& setting = times_.settings[index];
    setting.distance = setting.ratio - times_.common;
    for (std::size_t side = 0; side < 2; ++side) {
      std::vector<double> own;
      for (const CellTimes* cell : by_setting_[index]) own.push_back(cell->halves[side]);
      const double drift = median(own) - (has_others_ ? median(drifts_[side]) : 0);
      setting.error = std::hypot(setting.error, drift / 2);
    }
    setting.error = std::hypot(setting.error, kFelt * contention_);
    if (!times_.is_known && !has_others_) setting.error += kWithoutOthers - limit_ / 2;
    setting.least = limit_ / 2 + setting.error + (has_others_ ? 0 : kWithoutOthers);
    const double size = std::abs(setting.distance);
    if (size > setting.least) {
      setting.change = setting.distance > 0 ? Verdict::regressed : Verdict::improved;
    } else if (times_.is_known && size - setting.error <= limit_ / 2 &&
               size + setting.error < limit_) {
      setting.change = Verdict::pass;
    }
  }

  double error_of_cell(const CellTimes& cell) const {
    const SettingTimes& setting = times_.settings[index_of_.at(cell.setting)];
    return std::hypot(kErrors * cell.spread, setting.error);
  }

  Verdict change_of_cell(const CellTimes& cell) const {
    if (cell.rounds < kFewestRounds) return Verdict::inconclusive;
    const SettingTimes& setting = times_.settings[index_of_.at(cell.setting)];
    const double alone = cell.ratio - setting.ratio;
    const double placed = limit_ * std::max(2.0, kPlaced / static_cast<double>(cell.graphs));
    const double sure = std::max({placed, kAlone * times_.residual, kErrors * cell.spread});
    if (std::abs(alone) > sure && num_timed_ >= 4 * kFewestSettings) {
      return alone > 0 ? Verdict::regressed : Verdict::improved;
    }
    const double noise = std::min(kNoise * times_.residual, kMostNoise * limit_);
    return std::abs(alone) <= std::max(limit_, noise) ? setting.change : Verdict::inconclusive;
  }

  const std::vector<CellTimes>& cells_;
  const double limit_;
  std::map<std::string, std::size_t> index_of_;
  std::vector<std::vector<const CellTimes*>> by_setting_;
  std::array<std::vector<double>, 2> drifts_;  ///< of all cells within a file
  std::size_t num_timed_ = 0;
  bool has_others_ = false;
  double contention_ = 0;  ///< log of what the cached search is slower by than arithmetic
  FileTimes times_;
};

}  // namespace

SideTimes side_times(const GraphRounds& graphs) {
  SideTimes times;
  times.graphs = graphs.size();
  for (auto [graph, rounds] : graphs) {
    const double share = 1 / static_cast<double>(graphs.size());
    std::sort(rounds.begin(), rounds.end());
    std::vector<double> logs;
    for (const auto& [round, log] : rounds) logs.push_back(log);
    const auto middle = logs.begin() + static_cast<std::ptrdiff_t>(logs.size() / 2);
    times.rounds = times.rounds == 0 ? logs.size() : std::min(times.rounds, logs.size());
    times.level += share * median(logs);
    times.variance += std::pow(share * error_of_median(logs), 2);
    if (logs.size() < 2) continue;
    times.halves += share * (median({logs.begin(), middle}) - median({middle, logs.end()}));
  }
  return times;
}

CellTimes cell_times(std::string setting, const SideTimes& base, const SideTimes& now) {
  return {.setting = std::move(setting),
          .rounds = std::min(base.rounds, now.rounds),
          .ratio = now.level - base.level,
          .spread = std::sqrt(base.variance + now.variance),
          .halves = {base.halves, now.halves},
          .graphs = std::max<std::size_t>(1, now.graphs)};
}

CellTimes cell_times(const PairedCell& cell) {
  std::array<GraphRounds, 2> sides;
  const std::vector<PairedRow> rows = timed_rows(cell);
  const bool is_corrected = std::ranges::all_of(rows, [](const PairedRow& row) {
    return !std::isnan(log_slowness(*row[0]) + log_slowness(*row[1]));
  });
  for (const PairedRow& row : rows) {
    for (std::size_t side = 0; side < 2; ++side) {
      const RunRecord& run = *row[side];
      sides[side][{row[0]->requested_n, row[0]->instance_index, row[0]->seed}].emplace_back(
          run.repetition, is_corrected ? log_corrected_time(run) : std::log(drawing_time_s(run)));
    }
  }
  return cell_times(algorithm_label(cell.key), side_times(sides[0]), side_times(sides[1]));
}

FileTimes judge_file_times(const std::vector<CellTimes>& cells,
                           const std::array<double, 3>& yardsticks, const CompareOptions& rule) {
  return FileJudge(cells, rule).judged(yardsticks);
}

std::array<double, 3> yardsticks_of(const Results& results) {
  std::array<double, 3> medians{};
  for (std::size_t which = 0; which < medians.size(); ++which) {
    std::vector<double> logs;
    for (const RunRecord& run : results.runs) {
      if (run.yardsticks_s[which] > 0) logs.push_back(std::log(run.yardsticks_s[which]));
    }
    medians[which] = median(std::move(logs));
  }
  return medians;
}

std::string times_sentence(const FileTimes& times) {
  const auto factor = [](double log) {
    return std::isnan(log) ? std::string("-") : fmt::format("{:.2f}", std::exp(log));
  };
  const bool has_yardsticks = !std::isnan(times.yardsticks[0]);
  const bool is_memory_alike = std::abs(times.yardsticks[1]) <= kMemoryAsFast;
  std::string text = is_memory_alike ? "The machine was as fast in both"
                                     : "The machine's cores were as fast in both, its memory not";
  if (!times.is_known) {
    text = "NEW ran on a machine of another speed, or the whole program changed";
  } else if (std::abs(times.machine) > kAsFast) {
    text = "NEW ran on a machine of another speed, which yardsticks account for";
  }
  if (!has_yardsticks) text = "Without yardsticks in both, how fast the machine was is not known";
  text += fmt::format(": {}times are (NEW over BASE)", has_yardsticks ? "its " : "");
  for (std::size_t i = 0; has_yardsticks && i < kYardsticks.size(); ++i) {
    text += fmt::format("{} {} {}", i == 0 ? "" : ",", kYardsticks[i], factor(times.yardsticks[i]));
  }
  text += fmt::format("{} {} for all settings together",
                      has_yardsticks ? " for the yardsticks and, in units of theirs," : "",
                      factor(times.common));
  for (std::size_t side = 0; side < 2; ++side) {
    if (times.rounds[side].empty()) continue;
    text += fmt::format(". {} made {}", side == 0 ? "BASE" : "NEW", times.rounds[side]);
  }
  return text;
}

}  // namespace ar3d
