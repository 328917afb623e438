// Says in words and in JSON where the measures of a history changed. Both outputs take the changes
// in the same order, the largest first.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "ar3d/analysis/history/history.h"
#include "ar3d/analysis/json.h"
#include "ar3d/base/printable.h"

namespace ar3d {
namespace {

constexpr std::size_t kMostNotes = 5;
constexpr double kSlowNote = 0.05;  // of a logarithm

/// "1.23 µs", "45.6 ms", "7.8 s".
std::string duration(double seconds) {
  const double size = std::abs(seconds);
  if (size < 1e-6) return fmt::format("{:.3g} ns", seconds * 1e9);
  if (size < 1e-3) return fmt::format("{:.3g} µs", seconds * 1e6);
  if (size < 1) return fmt::format("{:.3g} ms", seconds * 1e3);
  return fmt::format("{:.3g} s", seconds);
}

/// Mean of the logarithms of values [begin, end), or of the values themselves.
double level(const HistoryLine& line, std::size_t begin, std::size_t end) {
  std::vector<double> values(line.values.begin() + static_cast<std::ptrdiff_t>(begin),
                             line.values.begin() + static_cast<std::ptrdiff_t>(end));
  return median(std::move(values));
}

std::string absolute(const std::string& path) {
  return std::filesystem::absolute(path).lexically_normal().string();
}

std::string change_lines(const History& history, const PlacedChange& placed) {
  const Neighbours at = around(history, placed, false), surely = around(history, placed, true);
  std::string text = fmt::format(
      "{}: {} of {}\n    {} {} and {}", effect_text(*placed.line, *placed.change),
      to_string(placed.line->measure), cell_label(placed.line->cell.curve, placed.line->cell.n),
      placed.change->gradual ? "little by little, the middle between" : "between", at.before->name,
      at.after->name);
  if (surely.before != at.before || surely.after != at.after) {
    text += fmt::format(" (95 %: between {} and {})", surely.before->name, surely.after->name);
  }
  return text + "\n    " + compare_command(history, *placed.line, *placed.change) + "\n";
}

std::string judged_text(const History& history) {
  std::string text;
  for (const Measure measure : kMeasures) {
    if (measure >= Measure::crossings && history.count(measure, false) == 0) continue;
    text += fmt::format("{}{}: {} of {} lines judged", text.empty() ? "" : ", ", to_string(measure),
                        history.count(measure, true), history.count(measure, false));
  }
  return text;
}

nlohmann::ordered_json change_json(const History& history, const HistoryLine& line,
                                   const ChangePoint& change) {
  const Neighbours at = around(history, {&line, &change}, false);
  const Neighbours surely = around(history, {&line, &change}, true);
  return {{"before", at.before->name},
          {"after", at.after->name},
          {"surely_before", surely.before->name},
          {"surely_after", surely.after->name},
          {"ratio", json_number(std::exp(change.effect))},
          {"ratio_low", json_number(std::exp(change.interval.low))},
          {"ratio_high", json_number(std::exp(change.interval.high))},
          {"gradual", change.gradual},
          {"command", valid_utf8(compare_command(history, line, change))}};
}

}  // namespace

std::vector<PlacedChange> changes_in_order(const History& history) {
  std::vector<PlacedChange> changes;
  for (const HistoryLine& line : history.lines) {
    for (const ChangePoint& change : line.changes) changes.push_back({&line, &change});
  }
  const auto size = [](const PlacedChange& placed) {
    return std::isfinite(placed.change->effect) ? std::abs(placed.change->effect) : -1;
  };
  std::stable_sort(changes.begin(), changes.end(),
                   [&](const auto& a, const auto& b) { return size(a) > size(b); });
  return changes;
}

Neighbours around(const History& history, const PlacedChange& placed, bool surely) {
  const std::size_t after = surely ? placed.change->last : placed.change->at;
  const std::size_t before = (surely ? placed.change->first : placed.change->at) - 1;
  return {&history.results[placed.line->results[before]],
          &history.results[placed.line->results[after]]};
}

std::string percent_change(double log_ratio) {
  return fmt::format("{:+.3g} %", 100 * std::expm1(log_ratio));
}

const char* direction_text(const PlacedChange& placed) {
  constexpr const char* kMore[] = {"slower",        "more instructions", "more cycles",
                                   "larger volume", "more bends",        "more crossings",
                                   "larger angles"};
  static_assert(std::size(kMore) == kMeasures.size());
  constexpr const char* kLess[] = {"faster",         "fewer instructions", "fewer cycles",
                                   "smaller volume", "fewer bends",        "fewer crossings",
                                   "smaller angles"};
  static_assert(std::size(kLess) == kMeasures.size());
  if (!(std::abs(placed.change->effect) > 0)) return "other drawings";
  return (placed.change->effect > 0 ? kMore
                                    : kLess)[static_cast<std::size_t>(placed.line->measure)];
}

std::string value_text(Measure measure, double value) {
  if (measure == Measure::time) return duration(value);
  return measure == Measure::bends ? fmt::format("{:.4g}", value) : fmt::format("{:.5g}", value);
}

std::string effect_text(const HistoryLine& line, const ChangePoint& change) {
  if (line.measure == Measure::time) {
    return fmt::format("{} [{}, {}]", percent_change(change.effect),
                       percent_change(change.interval.low), percent_change(change.interval.high));
  }
  if (change.effect == 0) return "some graphs more, others less";
  const double before = level(line, change.at - 1, change.at);
  const double after = level(line, change.at, change.at + 1);
  const std::string values =
      fmt::format("{} to {}", value_text(line.measure, before), value_text(line.measure, after));
  return std::isfinite(change.effect) ? percent_change(change.effect) + ", " + values : values;
}

std::string compare_command(const History& history, const HistoryLine& line,
                            const ChangePoint& change) {
  const Neighbours at = around(history, {&line, &change}, true);
  return fmt::format("ar3d compare {} {}", shell_word(absolute(at.before->file)),
                     shell_word(absolute(at.after->file)));
}

std::string summary(const History& history, std::size_t most) {
  const std::vector<PlacedChange> changes = changes_in_order(history);
  std::string text;
  for (std::size_t i = 0; i < std::min(most, changes.size()); ++i) {
    text += change_lines(history, changes[i]);
  }
  if (changes.size() > most) text += fmt::format("{} more changes\n", changes.size() - most);
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
  const std::size_t environments = history.environments.size();
  text += fmt::format("history  {} results, {} environment{}; {}\n", history.results.size(),
                      environments, environments == 1 ? "" : "s", judged_text(history));
  return text + fmt::format("changes  {}\n", changes.size());
}

std::string history_json(const History& history) {
  using nlohmann::ordered_json;
  ordered_json results = ordered_json::array(), lines = ordered_json::array();
  for (const CommitResults& one : history.results) {
    results.push_back({{"file", valid_utf8(one.file)},
                       {"place", one.place},
                       {"name", one.name},
                       {"source_hash", valid_utf8(one.source_hash)},
                       {"study", valid_utf8(one.study)},
                       {"created", valid_utf8(one.created)},
                       {"environment", one.environment},
                       {"times_left_out", valid_utf8(one.untimed)},
                       {"slowness", json_number(one.slowness)},
                       {"unfinished_rows", one.unfinished}});
  }
  for (const HistoryLine& line : history.lines) {
    ordered_json changes = ordered_json::array();
    for (const ChangePoint& change : line.changes) {
      changes.push_back(change_json(history, line, change));
    }
    lines.push_back({{"environment", line.environment},
                     {"study", valid_utf8(line.study)},
                     {"cell", cell_label(line.cell.curve, line.cell.n)},
                     {"measure", to_string(line.measure)},
                     {"judged", line.is_judged},
                     {"results", line.results},
                     {"values", line.values},
                     {"changes", std::move(changes)}});
  }
  ordered_json environments = ordered_json::array();
  for (const auto& settings : history.environments) {
    ordered_json entries = ordered_json::object();
    for (const auto& [name, value] : settings) entries[valid_utf8(name)] = valid_utf8(value);
    environments.push_back(std::move(entries));
  }
  const ordered_json all = {{"results", results}, {"environments", environments}, {"lines", lines}};
  return all.dump(1) + "\n";
}

}  // namespace ar3d
