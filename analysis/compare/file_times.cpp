// Times of two files: smallest times, the state of the machine, settings against all others.
#include "ar3d/analysis/compare/file_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "ar3d/analysis/statistics.h"
#include "ar3d/base/printable.h"

namespace ar3d {
namespace {

constexpr double kRobust = 1.4826;       // standard deviation by the median absolute deviation
constexpr double kOfMedian = 1.2533;     // standard error of a median by that of a mean
constexpr double kErrors = 3;            // standard errors that an interval is wide on either side
constexpr double kLeastError = 0.003;    // of a build's place in memory
constexpr double kFelt = 0.5;            // settings feel a state as unlike as cells do, times this
constexpr double kWithoutOthers = 0.05;  // by which yardsticks alone may be wrong
constexpr double kAlone = 10;            // residuals by which a single cell has to move
constexpr double kNoise = 6;             // residuals within which it has not moved,
constexpr double kMostNoise = 1.5;       // but never more than this times the threshold
constexpr std::size_t kOthers = 3;       // settings that tell a common factor

/// Root mean square distance, of the smallest of so many values drawn from them with replacement,
/// from the smallest: it is at least the k-th smallest with probability (1 - k / n)^n, k from 0.
double resampled_spread(std::vector<double> logs) {
  std::sort(logs.begin(), logs.end());
  const auto n = static_cast<double>(logs.size());
  double square = 0;
  for (std::size_t k = 0; k < logs.size(); ++k) {
    const auto at = static_cast<double>(k);
    const double probability = std::pow(1 - at / n, n) - std::pow(1 - (at + 1) / n, n);
    square += probability * std::pow(logs[k] - logs.front(), 2);
  }
  return std::sqrt(square);
}

double smallest(const std::vector<double>& logs, std::size_t begin, std::size_t end) {
  return *std::min_element(logs.begin() + static_cast<std::ptrdiff_t>(begin),
                           logs.begin() + static_cast<std::ptrdiff_t>(end));
}

/// Robust standard deviation about 0.
double spread_about_zero(std::vector<double> values) {
  for (double& value : values) value = std::abs(value);
  return kRobust * median(std::move(values));
}

/// Logarithms of a yardstick in one file: its smallest, and how far the median is above it.
std::pair<double, double> yardstick_of(const Results& results, std::size_t which) {
  std::vector<double> logs;
  for (const RunRecord& run : results.runs) {
    if (run.yardsticks_s[which] > 0) logs.push_back(std::log(run.yardsticks_s[which]));
  }
  if (logs.empty()) return {kMissing, 0};
  return {*std::min_element(logs.begin(), logs.end()),
          median(logs) - *std::min_element(logs.begin(), logs.end())};
}

/// Why the last session made no more rounds.
std::string last_rounds(const Results& results) {
  std::string last;
  for (const EnvironmentEntry& entry : results.environment) {
    if (entry.name == kTimingRounds) last = one_line(entry.value);
  }
  return last;
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

TimeChange change_of(double distance, double error, const TimeRule& rule) {
  const double limit = std::log1p(rule.threshold);
  if (distance - error > limit / 2) return TimeChange::slower;
  if (distance + error < -limit / 2) return TimeChange::faster;
  return std::abs(distance) + error < limit ? TimeChange::same : TimeChange::undecided;
}

}  // namespace

CellTimes cell_times(const PairedCell& cell) {
  using Graph = std::tuple<std::int64_t, std::int64_t, std::uint64_t>;
  std::map<Graph, std::array<std::map<std::int64_t, double>, 2>> graphs;
  for (const PairedRow& row : timed_rows(cell)) {
    const RunRecord& run = *row.base;
    auto& graph = graphs[{run.requested_n, run.instance_index, run.seed}];
    graph[0][run.repetition] = std::log(drawing_time_s(*row.base));
    graph[1][run.repetition] = std::log(drawing_time_s(*row.now));
  }
  CellTimes times;
  times.setting = algorithm_label(cell.key);
  for (const auto& [graph, sides] : graphs) {
    const double share = 1 / static_cast<double>(graphs.size());
    for (std::size_t side = 0; side < 2; ++side) {
      std::vector<double> logs;
      for (const auto& [round, log] : sides[side]) logs.push_back(log);
      const std::size_t rounds = logs.size();
      times.rounds = times.rounds == 0 ? rounds : std::min(times.rounds, rounds);
      times.ratio += share * (side == 0 ? -1 : 1) * smallest(logs, 0, rounds);
      times.spread += share * share * std::pow(resampled_spread(logs), 2);
      if (rounds < 2) continue;
      times.halves[side] +=
          share * (smallest(logs, 0, rounds / 2) - smallest(logs, rounds / 2, rounds));
    }
  }
  times.spread = std::sqrt(times.spread);
  return times;
}

namespace {

/// The rules of docs/analysis.md, "Then times", in their order.
class FileJudge {
 public:
  FileJudge(const std::vector<CellTimes>& cells, const TimeRule& rule)
      : cells_(cells), rule_(rule), limit_(std::log1p(rule.threshold)) {
    for (const CellTimes& cell : cells) {
      if (cell.rounds == 0) continue;
      const auto [place, is_new] = place_of_.try_emplace(cell.setting, by_setting_.size());
      if (is_new) by_setting_.emplace_back();
      by_setting_[place->second].push_back(&cell);
    }
  }

  FileTimes judged(const Results& base, const Results& now) {
    std::vector<double> ratios;
    for (const auto& of_setting : by_setting_) {
      times_.settings.push_back(setting_of(of_setting));
      ratios.push_back(times_.settings.back().ratio);
    }
    times_.rounds = {last_rounds(base), last_rounds(now)};
    has_others_ = ratios.size() >= kOthers;
    if (has_others_) times_.common = median(ratios);
    times_.is_alike = are_yardsticks_alike(base, now) && std::abs(times_.common) <= limit_ / 2;
    measure_residual();
    for (std::size_t i = 0; i < by_setting_.size(); ++i) judge_setting(i);
    for (const CellTimes& cell : cells_) times_.cells.push_back(change_of_cell(cell));
    return std::move(times_);
  }

 private:
  /// Missing ones say nothing against it.
  bool are_yardsticks_alike(const Results& base, const Results& now) {
    std::vector<double> differences, spreads;
    for (std::size_t which = 0; which < times_.yardsticks.size(); ++which) {
      const auto [before, before_spread] = yardstick_of(base, which);
      const auto [after, after_spread] = yardstick_of(now, which);
      times_.yardsticks[which] = after - before;
      differences.push_back(after - before);
      spreads.push_back(std::max(before_spread, after_spread));
    }
    return !(std::abs(median(differences)) > std::max(limit_ / 2, median(spreads)));
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

  void judge_setting(std::size_t place) {
    SettingTimes& setting = times_.settings[place];
    setting.distance = setting.ratio - times_.common;
    for (std::size_t side = 0; side < 2; ++side) {
      std::vector<double> own;
      for (const CellTimes* cell : by_setting_[place]) own.push_back(cell->halves[side]);
      const double drift = median(own) - (has_others_ ? median(drifts_[side]) : 0);
      setting.error = std::hypot(setting.error, drift / 2);
    }
    setting.error = std::hypot(setting.error, kErrors * kFelt * times_.residual);
    if (!times_.is_alike) setting.error += kWithoutOthers - limit_ / 2;
    setting.change = change_of(setting.distance, setting.error, rule_);
    const bool is_same = setting.change == TimeChange::same;
    const double sure = std::abs(setting.distance) - setting.error;
    const bool is_unsure = !has_others_ && sure < limit_ / 2 + kWithoutOthers;
    if (is_same ? !times_.is_alike : is_unsure) setting.change = TimeChange::undecided;
  }

  TimeChange change_of_cell(const CellTimes& cell) const {
    if (cell.rounds < kFewestRounds) return TimeChange::undecided;
    const SettingTimes& setting = times_.settings[place_of_.at(cell.setting)];
    const double alone = cell.ratio - setting.ratio;
    const double sure = std::max({2 * limit_, kAlone * times_.residual, kErrors * cell.spread});
    if (std::abs(alone) > sure && num_timed_ >= 4 * kOthers) {
      return alone > 0 ? TimeChange::slower : TimeChange::faster;
    }
    const double noise = std::min(kNoise * times_.residual, kMostNoise * limit_);
    return std::abs(alone) <= std::max(limit_, noise) ? setting.change : TimeChange::undecided;
  }

  const std::vector<CellTimes>& cells_;
  const TimeRule& rule_;
  const double limit_;
  std::map<std::string, std::size_t> place_of_;
  std::vector<std::vector<const CellTimes*>> by_setting_;
  std::array<std::vector<double>, 2> drifts_;  ///< of all cells within a file
  std::size_t num_timed_ = 0;
  bool has_others_ = false;
  FileTimes times_;
};

}  // namespace

FileTimes judge_file_times(const std::vector<CellTimes>& cells, const Results& base,
                           const Results& now, const TimeRule& rule) {
  return FileJudge(cells, rule).judged(base, now);
}

namespace {

std::string signed_percent(double log_ratio) {
  return fmt::format("{:+.1f} %", 100 * std::expm1(log_ratio));
}

}  // namespace

std::string distance_text(const SettingTimes& setting) {
  return fmt::format("{} {} [{}, {}]", setting.name, signed_percent(setting.distance),
                     signed_percent(setting.distance - setting.error),
                     signed_percent(setting.distance + setting.error));
}

std::string times_sentence(const FileTimes& times) {
  const auto factor = [](double log) {
    return std::isnan(log) ? std::string("-") : fmt::format("{:.2f}", std::exp(log));
  };
  std::string text = times.is_alike
                         ? "The machine was as fast in both"
                         : "NEW ran on a machine of another speed, or the whole program changed";
  text += ": its times are (NEW over BASE)";
  for (std::size_t i = 0; i < kYardsticks.size(); ++i) {
    text += fmt::format("{} {} {}", i == 0 ? "" : ",", kYardsticks[i], factor(times.yardsticks[i]));
  }
  text +=
      fmt::format(" for the yardsticks and {} for all settings together.", factor(times.common));
  std::string moved;
  for (const SettingTimes& setting : times.settings) {
    if (setting.change != TimeChange::slower && setting.change != TimeChange::faster) continue;
    moved += (moved.empty() ? "" : ", ") + distance_text(setting);
  }
  text +=
      moved.empty() ? " No setting moved against all others" : " Against all others moved " + moved;
  for (std::size_t side = 0; side < 2; ++side) {
    if (times.rounds[side].empty()) continue;
    text += fmt::format(". {} made {}", side == 0 ? "BASE" : "NEW", times.rounds[side]);
  }
  return text;
}

}  // namespace ar3d
