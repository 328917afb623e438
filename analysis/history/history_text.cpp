// A history in words: where it changed, commit by commit, the last one first; its tables.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "ar3d/analysis/history/history.h"
#include "ar3d/base/printable.h"

namespace ar3d {
namespace {

constexpr std::size_t kMostNotes = 5;
constexpr double kSlowNote = 0.05;  // of a logarithm

std::string percent_change(double log_ratio) {
  return fmt::format("{:+.3g} %", 100 * std::expm1(log_ratio));
}

/// "+10.2 % [+9.1 %, +11.3 %]"; empty if there is no ratio.
std::string effect_text(const HistoryChange& change) {
  if (!std::isfinite(change.effect) || change.direction == 0) return "";
  std::string text = " " + percent_change(change.effect);
  if (change.interval.width() == 0) return text;
  return text + fmt::format(" [{}, {}]", percent_change(change.interval.low),
                            percent_change(change.interval.high));
}

std::string change_line(const History& history, const HistoryChange& change) {
  const HistoryLine& line = history.lines[change.line];
  const std::string cell = cell_label(line.cell.curve, line.cell.n);
  const std::string who = change.setting.empty() ? "all settings" : change.setting;
  return fmt::format(
      "    {}: {}{}, {}\n", change.cells == 1 ? cell : who, direction_text(change),
      effect_text(change),
      change.cells == 1 ? fmt::format("1 of {} cells", change.of)
                        : fmt::format("{} of {} cells, most in {}", change.cells, change.of, cell));
}

std::string judged_text(const History& history) {
  std::string text;
  for (const Measure measure : kMeasures) {
    std::size_t all = 0, judged = 0;
    for (const HistoryLine& line : history.lines) {
      all += line.measure == measure;
      judged += line.measure == measure && line.is_judged;
    }
    if (measure >= Measure::crossings && all == 0) continue;
    text += fmt::format("{}{}: {} of {} lines judged", text.empty() ? "" : ", ", to_string(measure),
                        judged, all);
  }
  return text;
}

std::string notes(const History& history) {
  std::string text;
  std::size_t untimed = 0;
  for (const CommitResults& results : history.results) {
    if (results.untimed.empty() || ++untimed > kMostNotes) continue;
    text += fmt::format("note     times of {} are left out: {}\n", results.file, results.untimed);
  }
  if (untimed > kMostNotes) {
    text += fmt::format("note     times of {} more are left out\n", untimed - kMostNotes);
  }
  for (const CommitResults& results : history.results) {
    if (std::abs(std::log(results.slowness)) < kSlowNote) continue;
    text += fmt::format("note     times of {} are divided by {:.2f}, as the machine was slower\n",
                        results.file, results.slowness);
  }
  return text;
}

/// The smallest and largest of what times of single settings show.
std::string sight_text(const History& history) {
  double low = kMissing, high = kMissing;
  for (const auto& [environment, study, smallest] : history.sights) {
    low = std::fmin(low, smallest.best);
    high = std::fmax(high, smallest.best);
  }
  if (std::isnan(low)) return "times    too few results to show a change\n";
  return fmt::format("times    the smallest change that these results show: {} to {}\n",
                     percent_change(low), percent_change(high));
}

/// Leaves out what all environments share, where there are several.
void fill_environments(const History& history, Table& table) {
  std::set<std::string> names;
  for (const auto& settings : history.environments) {
    for (const auto& [name, value] : settings) names.insert(name);
  }
  for (const std::string& name : names) {
    std::vector<std::string> values;
    for (const auto& settings : history.environments) {
      const auto at = settings.find(name);
      values.push_back(at == settings.end() ? "absent" : at->second);
    }
    if (values.size() > 1 && std::set(values.begin(), values.end()).size() == 1) continue;
    for (std::size_t i = 0; i < values.size(); ++i) table.add({i + 1, name, values[i]});
  }
}

std::string compare_command(const History& history, const HistoryChange& change) {
  return fmt::format("ar3d compare {} {}", shell_word(history.results[change.before].file),
                     shell_word(history.results[change.at].file));
}

}  // namespace

const char* direction_text(const HistoryChange& change) {
  constexpr const char* kMore[] = {"slower",        "more instructions", "more cycles",
                                   "larger volume", "more bends",        "more crossings",
                                   "larger angles"};
  static_assert(std::size(kMore) == kMeasures.size());
  constexpr const char* kLess[] = {"faster",         "fewer instructions", "fewer cycles",
                                   "smaller volume", "fewer bends",        "fewer crossings",
                                   "smaller angles"};
  static_assert(std::size(kLess) == kMeasures.size());
  if (change.direction == 0) return "other drawings";
  return (change.direction > 0 ? kMore : kLess)[static_cast<std::size_t>(change.measure)];
}

std::vector<Table> history_tables(const History& history, const std::string& folder) {
  std::vector<Table> tables = empty_tables("history");
  const auto table = [&](const char* name) -> Table& { return table_named(name, tables); };
  table("summary").add({folder, history.results.size(), history.environments.size(),
                        history.lines.size(),
                        std::ranges::count(history.lines, true, &HistoryLine::is_judged)});
  for (const CommitResults& one : history.results) {
    table("results").add({one.index, one.name, one.source_hash.substr(0, 12), one.study,
                          one.created, one.environment + 1, one.unfinished, one.slowness,
                          one.untimed});
  }
  for (std::size_t i = 0; i < history.lines.size(); ++i) {
    const HistoryLine& line = history.lines[i];
    const CurveKey& curve = line.cell.curve;
    table("lines").add({line.environment + 1, line.study, algorithm_label(curve),
                        family_label(curve), count_or_none(line.cell.n), line.cell.graphs,
                        cell_label(curve, line.cell.n), to_string(line.measure), line.is_judged});
    const double first = line.values.front() > 0 ? line.values.front() : kMissing;
    for (std::size_t at = 0; at < line.values.size(); ++at) {
      table("history").add({i, line.results[at], line.values[at], line.values[at] / first - 1});
    }
  }
  for (const HistoryChange& change : history.changes) {
    table("changes").add({change.at, change.before, change.setting, to_string(change.measure),
                          direction_text(change), change.direction > 0, change.cells, change.of,
                          std::expm1(change.effect), std::expm1(change.interval.low),
                          std::expm1(change.interval.high), change.line,
                          compare_command(history, change)});
  }
  for (const auto& [environment, study, smallest] : history.sights) {
    table("sights").add({environment + 1, study, smallest.setting, smallest.cells, smallest.results,
                         std::expm1(smallest.at_once), std::expm1(smallest.best)});
  }
  fill_environments(history, table("environments"));
  return tables;
}

std::string summary(const History& history, std::size_t most_commits) {
  std::string text;
  std::size_t commits = 0, last = history.results.size(), before = last;
  for (const HistoryChange& change : history.changes) {
    if (change.at != last || change.before != before) {
      last = change.at;
      before = change.before;
      if (++commits > most_commits) continue;
      text += fmt::format("{}, after {}\n    {}\n", history.results[last].name,
                          history.results[before].name, compare_command(history, change));
    }
    if (commits <= most_commits) text += change_line(history, change);
  }
  if (commits > most_commits) {
    text += fmt::format("{} more commits changed something\n", commits - most_commits);
  }
  const std::size_t environments = history.environments.size();
  return text + notes(history) + sight_text(history) +
         fmt::format("history  {} results, {} environment{}; {}\nchanges  {}\n",
                     history.results.size(), environments, environments == 1 ? "" : "s",
                     judged_text(history), history.changes.size());
}

}  // namespace ar3d
