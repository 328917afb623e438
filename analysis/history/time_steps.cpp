// When times changed for good: at every result, the last k results against the k before, judged by
// the rule for two files. What settings vary by from result to result counts as error, too, since
// two results alone do not show it.
#include <algorithm>

#include "ar3d/analysis/history/history.h"

namespace ar3d {
namespace {

constexpr std::size_t kWidest = 8;     // results on either side
constexpr std::size_t kManyCells = 6;  // whose median a burst in some of them does not move
constexpr std::size_t kFewWidth = 4;   // results on either side that fewer cells need
constexpr double kErrors = 3.5;        // standard deviations of the noise between results
constexpr double kUsualNoise = 0.01;   // before results have shown it
constexpr double kUsualWeight = 4;     // results that this counts as
constexpr double kRobust = 1.4826;     // standard deviation by the median absolute one

/// Two windows of `width` results on either side of `at`, and what the rule says of them.
struct Windows {
  std::size_t at = 0;
  std::size_t width = 0;
  std::vector<std::size_t> cells;     // that all these results have
  std::vector<CellTimes> cell_times;  // of these
  std::vector<double> rises;          // from the mean of one window to that of the other
  FileTimes times;
};

/// Holds how far the means on either side of a step are apart, and the step.
using Candidate = std::pair<double, TimeStep>;

using Levels = std::array<std::vector<double>, 2>;  // before and after, sorted, equally many

/// From the upper median before to the lower one after, or from the lower one to the upper one:
/// what a burst in one result does not show. Zero if the two have unlike signs.
/// @param all  from the largest value to the smallest one instead.
double lasting_difference(const Levels& levels, bool all) {
  const std::size_t size = levels[0].size();
  const std::size_t high = all ? size - 1 : size / 2, low = all ? 0 : (size - 1) / 2;
  return std::max(levels[1][low] - levels[0][high], 0.0) +
         std::min(levels[1][high] - levels[0][low], 0.0);
}

class StepFinder {
 public:
  StepFinder(const TimeSeries& series, const CompareOptions& rule) : series_(series), rule_(rule) {
    for (const std::string& setting : series.settings) ++cells_of_[setting];
  }

  std::pair<std::vector<TimeStep>, std::vector<SmallestStep>> found() {
    const std::size_t size = series_.results.size();
    for (std::size_t width = 1; width <= std::min(kWidest, size / 2); ++width) {
      std::vector<Windows> all;
      for (std::size_t at = width; at + width <= size; ++at) all.push_back(compared(at, width));
      if (width == 1) note_noise(all);
      std::vector<Candidate> candidates;
      for (const Windows& windows : all) add_candidates(windows, candidates);
      std::stable_sort(candidates.begin(), candidates.end(),
                       [](const auto& a, const auto& b) { return a.first > b.first; });
      for (auto& [height, step] : candidates) {
        if (is_free(step)) steps_.push_back(std::move(step));
      }
    }
    std::ranges::stable_sort(steps_, {}, &TimeStep::at);
    return {std::move(steps_), smallest()};
  }

 private:
  Windows compared(std::size_t at, std::size_t width) const {
    Windows windows{
        .at = at, .width = width, .cells = {}, .cell_times = {}, .rises = {}, .times = {}};
    for (std::size_t cell = 0; cell < series_.settings.size(); ++cell) {
      std::array<SideTimes, 2> sides;
      const auto levels = joined(at, width, cell, sides);
      if (!levels || std::min(sides[0].rounds, sides[1].rounds) < kFewestRounds) continue;
      const std::string& setting = series_.settings[cell];
      CellTimes times = cell_times(setting, sides[0], sides[1]);
      times.ratio = lasting_difference(*levels, cells_of_.at(setting) < kManyCells);
      windows.cells.push_back(cell);
      windows.cell_times.push_back(std::move(times));
      windows.rises.push_back(mean((*levels)[1]) - mean((*levels)[0]));
    }
    windows.times = judge_file_times(windows.cell_times, yardsticks(at, width), rule_);
    return windows;
  }

  /// The results of either side as one file, without a level; their levels if all have times.
  std::optional<Levels> joined(std::size_t at, std::size_t width, std::size_t cell,
                               std::array<SideTimes, 2>& sides) const {
    Levels levels;
    const auto share = 1 / static_cast<double>(width);
    for (std::size_t i = at - width; i < at + width; ++i) {
      const SideTimes& one = series_.results[i][cell];
      if (one.rounds == 0) return std::nullopt;
      SideTimes& side = sides[i >= at];
      side.rounds += one.rounds;
      side.graphs = one.graphs;
      side.variance += one.variance * share * share;
      side.halves += one.halves * share;
      levels[i >= at].push_back(one.level);
    }
    for (auto& side : levels) std::sort(side.begin(), side.end());
    return levels;
  }

  std::array<double, 3> yardsticks(std::size_t at, std::size_t width) const {
    std::array<double, 3> changes{};
    for (std::size_t which = 0; which < changes.size(); ++which) {
      std::array<std::vector<double>, 2> sides;
      for (std::size_t i = at - width; i < at + width; ++i) {
        sides[i >= at].push_back(series_.yardsticks[i][which]);
      }
      changes[which] = median(sides[1]) - median(sides[0]);
    }
    return changes;
  }

  /// A setting among others moves against these, since it may be the common one itself.
  void note_noise(const std::vector<Windows>& neighbours) {
    for (const Windows& windows : neighbours) {
      const std::vector<SettingTimes>& settings = windows.times.settings;
      moved_[""].emplace_back(windows.at, std::abs(windows.times.common));
      for (const SettingTimes& setting : settings) {
        std::vector<double> others;
        for (const SettingTimes& other : settings) {
          if (&other != &setting) others.push_back(other.ratio);
        }
        const double common = settings.size() < kFewestSettings ? 0 : median(std::move(others));
        moved_[setting.name].emplace_back(windows.at, std::abs(setting.ratio - common));
      }
    }
  }

  /// Returns what the noise between results adds to the error of a comparison; changes, that at
  /// `at` too, are no noise.
  double noise(const std::string& setting, std::size_t at, std::size_t width) const {
    const auto moved = moved_.find(setting);
    std::vector<double> others;
    if (moved != moved_.end()) {
      for (const auto& [index, size] : moved->second) {
        if (index != at && !has_step(setting, index)) others.push_back(size);
      }
    }
    const auto seen = static_cast<double>(others.size());
    const double own = others.empty() ? 0 : kRobust * median(others);  // of a difference
    const double squared =
        (2 * kUsualWeight * kUsualNoise * kUsualNoise + seen * own * own) / (kUsualWeight + seen);
    return kErrors * std::sqrt(squared / static_cast<double>(width));
  }

  bool has_step(const std::string& setting, std::size_t at) const {
    return std::ranges::any_of(steps_, [&](const TimeStep& step) {
      return step.at == at && step.setting == setting && step.cell == kNoCell;
    });
  }

  /// True if no change of the same, or of all settings, lies within the step's windows.
  bool is_free(const TimeStep& step) const {
    return std::ranges::none_of(steps_, [&](const TimeStep& other) {
      const bool is_same =
          other.setting.empty() ||
          (other.setting == step.setting && (other.cell == step.cell || other.cell == kNoCell));
      return is_same && other.at + step.width > step.at && step.at + step.width > other.at;
    });
  }

  void add_candidates(const Windows& windows, std::vector<Candidate>& into) const {
    const FileTimes& times = windows.times;
    const bool has_others = times.settings.size() >= kFewestSettings;
    if (has_others) add_common(windows, into);
    if (has_others && !times.is_known) return;
    std::map<std::string, const SettingTimes*> by_name;
    for (const SettingTimes& setting : times.settings) {
      by_name[setting.name] = &setting;
      const double more = noise(setting.name, windows.at, windows.width);
      if (!is_enough(setting.cells, windows.width)) continue;
      if (std::abs(setting.distance) <= setting.least + more) continue;
      add(windows,
          {.setting = setting.name,
           .cells = setting.cells,
           .change = setting.distance,
           .error = setting.error + more},
          into);
    }
    if (windows.width < kFewWidth) return;
    for (std::size_t i = 0; i < windows.cells.size(); ++i) {
      const CellTimes& cell = windows.cell_times[i];
      const SettingTimes& setting = *by_name.at(cell.setting);
      const bool is_moved =
          times.cells[i] == Verdict::regressed || times.cells[i] == Verdict::improved;
      if (!is_moved || times.cells[i] == setting.change) continue;
      std::array<SideTimes, 2> sides;
      const auto levels = joined(windows.at, windows.width, windows.cells[i], sides);
      if (std::abs(lasting_difference(*levels, true)) < std::log1p(rule_.threshold) / 2) continue;
      add(windows,
          {.setting = setting.name,
           .cell = windows.cells[i],
           .change = cell.ratio - times.common,
           .error = 2 * cell.spread},
          into);
    }
  }

  /// All settings together: only yardsticks tell that it was not the machine.
  void add_common(const Windows& windows, std::vector<Candidate>& into) const {
    std::vector<double> errors;
    for (const SettingTimes& setting : windows.times.settings) errors.push_back(setting.error);
    const double error =
        median(std::move(errors)) + kWithoutOthers + noise("", windows.at, windows.width);
    const double change = windows.times.common;
    if (!is_enough(windows.cells.size(), windows.width)) return;
    if (std::abs(change) <= error + std::log1p(rule_.threshold) / 2) return;
    add(windows, {.setting = "", .cells = windows.cells.size(), .change = change, .error = error},
        into);
  }

  static void add(const Windows& windows, TimeStep step, std::vector<Candidate>& into) {
    step.at = windows.at;
    step.width = windows.width;
    std::vector<double> rises;
    double farthest = 0;
    for (std::size_t i = 0; i < windows.cells.size(); ++i) {
      const bool is_its = step.cell == kNoCell ? step.setting.empty() ||
                                                     step.setting == windows.cell_times[i].setting
                                               : step.cell == windows.cells[i];
      if (!is_its) continue;
      const double rise = step.change > 0 ? windows.rises[i] : -windows.rises[i];
      if (rises.empty() || rise > farthest) farthest = rise, step.most = windows.cells[i];
      rises.push_back(rise);
    }
    const double height = median(std::move(rises));
    into.emplace_back(height, std::move(step));
  }

  static bool is_enough(std::size_t cells, std::size_t width) {
    return cells >= kManyCells || width >= kFewWidth;
  }

  std::vector<SmallestStep> smallest() const {
    const std::size_t size = series_.results.size();
    std::map<std::string, SmallestStep> by_name;
    for (const std::vector<SideTimes>& result : series_.results) {
      std::map<std::string, std::size_t> cells;
      for (std::size_t i = 0; i < result.size(); ++i) {
        if (result[i].rounds > 0) ++cells[series_.settings[i]];
      }
      for (const auto& [name, count] : cells) {
        SmallestStep& step = by_name[name];
        step.setting = name;
        step.cells = std::max(step.cells, count);
        ++step.results;
      }
    }
    for (std::size_t width = 1; width <= std::min(kWidest, size / 2); ++width) {
      const Windows last = compared(size - width, width);
      for (const SettingTimes& setting : last.times.settings) {
        if (!is_enough(setting.cells, width)) continue;
        SmallestStep& step = by_name[setting.name];
        const double least = setting.least + noise(setting.name, last.at, width);
        if (width == 1) step.at_once = least;
        step.best = std::fmin(step.best, least);
      }
    }
    std::vector<SmallestStep> steps;
    for (auto& [name, step] : by_name) steps.push_back(std::move(step));
    return steps;
  }

  const TimeSeries& series_;
  const CompareOptions& rule_;
  std::map<std::string, std::size_t> cells_of_;
  /// Holds how far a setting moved from one result to the next, by its name; "": all together.
  std::map<std::string, std::vector<std::pair<std::size_t, double>>> moved_;
  std::vector<TimeStep> steps_;
};

}  // namespace

std::pair<std::vector<TimeStep>, std::vector<SmallestStep>> find_time_steps(
    const TimeSeries& series, const CompareOptions& rule) {
  return StepFinder(series, rule).found();
}

}  // namespace ar3d
