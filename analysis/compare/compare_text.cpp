// A comparison for people and programs: text, Markdown, JSON.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "ar3d/analysis/compare/compare.h"
#include "ar3d/analysis/table.h"
#include "ar3d/base/printable.h"

namespace ar3d {

namespace {

using nlohmann::ordered_json;

ordered_json time_json(const TimeVerdict& time) {
  const SignedRankTest& test = time.test;
  return {{"pairs", test.pairs},
          {"ratio", json_number(std::exp(test.estimate))},
          {"ratio_low", json_number(std::exp(test.interval.low))},
          {"ratio_high", json_number(std::exp(test.interval.high))},
          {"p_value", json_number(test.p_value())},
          {"adjusted_p_value", json_number(time.adjusted_p)}};
}

ordered_json cell_json(const CellComparison& cell) {
  ordered_json json = key_json(cell.key);
  json.update({{"n", cell.n >= 0 ? ordered_json(cell.n) : ordered_json(nullptr)},
               {"verdict", to_string(cell.verdict)},
               {"reason", valid_utf8(cell.reason)},
               {"measurements", cell.rows},
               {"instructions_ratio", json_number(std::exp(cell.counts.instructions))},
               {"estimated_cycles_ratio", json_number(std::exp(cell.counts.cycles))},
               {"volume_ratio", json_number(std::exp2(cell.log2_volume_change))},
               {"time", time_json(cell.time)}});
  return json;
}

ordered_json environment_json(const Comparison& comparison) {
  ordered_json changes = ordered_json::array();
  for (const EnvironmentChange& change : comparison.environment) {
    changes.push_back({{"name", valid_utf8(change.name)},
                       {"base", valid_utf8(change.base)},
                       {"new", valid_utf8(change.now)}});
  }
  return changes;
}

ordered_json times_json(const FileTimes& times) {
  ordered_json json = {{"machine_is_known", times.is_known},
                       {"common_factor", json_number(std::exp(times.common))}};
  for (std::size_t i = 0; i < kYardsticks.size(); ++i) {
    json["yardsticks"][kYardsticks[i]] = json_number(std::exp(times.yardsticks[i]));
  }
  json["settings"] = ordered_json::array();
  for (const SettingTimes& setting : times.settings) {
    json["settings"].push_back({{"setting", valid_utf8(setting.name)},
                                {"cells", setting.cells},
                                {"distance", json_number(std::exp(setting.distance))},
                                {"low", json_number(std::exp(setting.distance - setting.error))},
                                {"high", json_number(std::exp(setting.distance + setting.error))}});
  }
  return json;
}

ordered_json calibration_json(const Calibration& calibration) {
  return {{"cells", calibration.cells},
          {"pairs", calibration.pairs},
          {"false_alarms", calibration.false_alarms},
          {"relabellings", calibration.relabellings},
          {"false_alarm_rate", json_number(calibration.false_alarm_rate())},
          {"smallest_slowdown_median", json_number(calibration.smallest_slowdown_median)},
          {"smallest_slowdown_worst", json_number(calibration.smallest_slowdown_worst)}};
}

constexpr std::size_t kLargestChanges = 10;

std::string percent(double ratio) { return fmt::format("{:+.1f} %", 100 * (ratio - 1)); }

std::string time_text(const TimeVerdict& time) {
  const SignedRankTest& test = time.test;
  if (test.pairs == 0) return "not timed";
  std::string text = percent(std::exp(test.estimate));
  if (std::isfinite(test.interval.low)) {
    text += fmt::format(" [{}, {}]", percent(std::exp(test.interval.low)),
                        percent(std::exp(test.interval.high)));
  }
  text += fmt::format(", {} rounds", test.pairs);
  return std::isnan(time.adjusted_p) ? text : text + fmt::format(", p {:.2g}", time.adjusted_p);
}

/// "instructions +0.0 %, cycles +0.2 %; ", or nothing.
std::string counts_of(const CellComparison& cell) {
  if (!cell.counts.is_known()) return "";
  std::string text = "instructions " + percent(std::exp(cell.counts.instructions));
  if (!std::isnan(cell.counts.cycles)) text += ", cycles " + percent(std::exp(cell.counts.cycles));
  return text + "; ";
}

std::string cell_line(const CellComparison& cell, bool shows_times) {
  const std::string time =
      shows_times ? counts_of(cell) + "time " + time_text(cell.time) : std::string();
  const char* between = time.empty() || cell.reason.empty() ? "" : "; ";
  return fmt::format("{:<12} {:<56} {}{}{}\n", to_string(cell.verdict),
                     cell_label(cell.key, cell.n), time, between, cell.reason);
}

/// Lines of the cells that did not plainly pass, the heaviest verdicts first: `most_cells` of each
/// verdict, and how many more there are.
std::string cell_lines(const Comparison& comparison, std::size_t most_cells,
                       const std::function<std::string(const CellComparison&, bool)>& line,
                       fmt::format_string<const char*, std::size_t> more) {
  std::string text;
  for (const Verdict verdict :
       {Verdict::violated, Verdict::regressed, Verdict::inconclusive, Verdict::improved}) {
    std::size_t shown = 0;
    for (const CellComparison& cell : comparison.cells) {
      if (cell.verdict == verdict && shown++ < most_cells)
        text += line(cell, !comparison.drawings_only);
    }
    if (shown > most_cells) text += fmt::format(more, to_string(verdict), shown - most_cells);
  }
  return text;
}

/// Returns what changed most, in every case: a change that was not judged is seen, too.
std::string largest_changes(const Comparison& comparison, std::size_t most) {
  std::string text;
  const auto add = [&](const char* what, const auto& size, const auto& told) {
    std::vector<const CellComparison*> cells;
    for (const CellComparison& cell : comparison.cells) {
      if (std::abs(size(cell)) > 0) cells.push_back(&cell);  // no NaN
    }
    std::ranges::stable_sort(cells, std::greater(),
                             [&](const auto* cell) { return std::abs(size(*cell)); });
    cells.resize(std::min(cells.size(), most));
    text += fmt::format("largest changes of {}{}\n", what, cells.empty() ? ": none" : "");
    for (const CellComparison* cell : cells) {
      text += fmt::format("  {:<58} {}\n", cell_label(cell->key, cell->n), told(*cell));
    }
  };
  if (!comparison.drawings_only) {
    add(
        comparison.time_judged ? "time (judged)" : "time (NOT JUDGED)",
        [](const auto& cell) { return cell.time.test.pairs == 0 ? 0 : cell.time.test.estimate; },
        [](const auto& cell) { return time_text(cell.time); });
  }
  add(
      "volume", [](const auto& cell) { return cell.log2_volume_change; },
      [](const auto& cell) { return percent(std::exp2(cell.log2_volume_change)); });
  return text;
}

bool is_unlike(const Comparison& comparison) {
  return std::any_of(comparison.environment.begin(), comparison.environment.end(),
                     [](const EnvironmentChange& change) { return change.differs(); });
}

std::string environment_text(const Comparison& comparison) {
  if (comparison.environment.empty() || comparison.drawings_only) return "";
  std::string text = fmt::format(
      "{}: times are {}\n", is_unlike(comparison) ? "UNLIKE ENVIRONMENTS" : "BUSY MACHINE",
      comparison.time_judged ? "judged all the same, as asked" : "shown, but not judged");
  for (const EnvironmentChange& change : comparison.environment) {
    text += fmt::format("  {}: {}{}\n", one_line(change.name), one_line(change.base),
                        change.differs() ? " -> " + one_line(change.now) : " in both");
  }
  return text;
}

/// Cells that passed although their drawings changed.
std::size_t other_drawings(const Comparison& comparison) {
  std::size_t count = 0;
  for (const CellComparison& cell : comparison.cells) {
    if (cell.verdict == Verdict::pass && !cell.reason.empty()) ++count;
  }
  return count;
}

std::string rule_text(const CompareOptions& options) {
  const TimeRule& rule = options.time;
  return fmt::format(
      "time changes by {:.3g} % or more; instructions by more than {:.3g} %, estimated cycles by "
      "more than {:.3g} %; volume, bends, status, certificate: any change for the worse",
      100 * rule.threshold, 100 * options.instruction_threshold, 100 * options.cycle_threshold);
}

std::string counts_text(const Comparison& comparison) {
  return fmt::format(
      "{} cells ({} measurements): {} pass, {} improved, {} unjudged, {} inconclusive, {} "
      "regressed, {} violated",
      comparison.cells.size(), comparison.rows, comparison.count(Verdict::pass),
      comparison.count(Verdict::improved), comparison.count(Verdict::unjudged),
      comparison.count(Verdict::inconclusive), comparison.count(Verdict::regressed),
      comparison.count(Verdict::violated));
}

/// A code span in a table: no backtick ends it, no bar ends its field.
std::string code_span(const std::string& text) {
  std::string span = "`";
  for (const char c : one_line(text)) {
    span += c == '`' ? "'" : c == '|' ? "\\|" : std::string(1, c);
  }
  return span + "`";
}

std::string markdown_row(const CellComparison& cell, bool shows_times) {
  const double volume = cell.log2_volume_change;
  return fmt::format("| {} | {} | {} | {} | {} |\n", to_string(cell.verdict),
                     code_span(cell_label(cell.key, cell.n)),
                     shows_times ? counts_of(cell) + time_text(cell.time) : "–",
                     std::abs(volume) > 0 ? percent(std::exp2(volume)) : "–",
                     cell.reason.empty() ? "" : code_span(cell.reason));
}

}  // namespace

std::string comparison_json(const Comparison& comparison, const CompareOptions& options,
                            const Calibration* calibration) {
  ordered_json json;
  json["verdict"] = comparison.word();
  json["exit_code"] = comparison.exit_code();
  json["judged"] = comparison.judged();
  json["rule"] = {{"threshold", options.time.threshold},
                  {"significance", options.time.significance},
                  {"false_discovery_rate", options.time.false_discovery_rate},
                  {"confidence", options.time.confidence},
                  {"instruction_threshold", options.instruction_threshold},
                  {"cycle_threshold", options.cycle_threshold},
                  {"drawings_only", options.drawings_only}};
  json["time_judged"] = comparison.time_judged;
  json["environment_changes"] = environment_json(comparison);
  json["measurements"] = comparison.rows;
  for (const Verdict verdict : {Verdict::pass, Verdict::improved, Verdict::unjudged,
                                Verdict::inconclusive, Verdict::regressed, Verdict::violated}) {
    json["counts"][to_string(verdict)] = comparison.count(verdict);
  }
  for (const auto& [name, lines] : {std::pair{"incomplete", &comparison.incomplete},
                                    std::pair{"remarks", &comparison.remarks}}) {
    json[name] = ordered_json::array();
    for (const std::string& line : *lines) json[name].push_back(valid_utf8(line));
  }
  if (comparison.times) json["times"] = times_json(*comparison.times);
  if (calibration != nullptr) json["calibration"] = calibration_json(*calibration);
  json["cells"] = ordered_json::array();
  for (const CellComparison& cell : comparison.cells) json["cells"].push_back(cell_json(cell));
  return json.dump(1) + "\n";
}

std::string comparison_markdown(const Comparison& comparison, const CompareOptions& options,
                                std::size_t most_cells) {
  std::string text =
      fmt::format("## ar3d compare: {}\n\n{}\n\nJudged: {}. Exit code {}.\n", comparison.word(),
                  counts_text(comparison), comparison.judged(), comparison.exit_code());
  const std::string rows =
      cell_lines(comparison, most_cells, markdown_row, "| {} | {} more | | | |\n");
  if (!rows.empty()) {
    text += "\n| verdict | cell | counts, time | volume | reason |\n|---|---|---|---|---|\n" + rows;
  }
  for (const std::string& line : comparison.incomplete) {
    text += "\n- incomplete: " + code_span(line);
  }
  for (const std::string& line : comparison.remarks) text += "\n- note: " + code_span(line);
  for (const EnvironmentChange& change : comparison.environment) {
    if (comparison.drawings_only) break;
    text += change.differs()
                ? fmt::format("\n- unlike environments: {} was {}, is {}", code_span(change.name),
                              code_span(change.base), code_span(change.now))
                : fmt::format("\n- busy machine: {} was {} in both", code_span(change.name),
                              code_span(change.base));
  }
  return text +
         fmt::format("\n\n<details><summary>Everything</summary>\n\n~~~\n{}~~~\n\n</details>\n",
                     summary(comparison, options, most_cells));
}

std::string summary(const Comparison& comparison, const CompareOptions& options,
                    std::size_t most_cells) {
  std::string text = environment_text(comparison) +
                     cell_lines(comparison, most_cells, cell_line, "{:<12} {} more\n") +
                     largest_changes(comparison, kLargestChanges);
  for (const std::string& line : comparison.incomplete) text += "INCOMPLETE   " + line + "\n";
  for (const std::string& line : comparison.remarks) text += "note         " + line + "\n";
  if (const std::size_t others = other_drawings(comparison); others > 0) {
    text += fmt::format("note         {} cells passed with other drawings than before\n", others);
  }
  text += fmt::format("{}  {}\n", comparison.word(), counts_text(comparison));
  text += fmt::format("judged: {}\n", comparison.judged());
  text += fmt::format("rule: {}; exit code {}\n", rule_text(options), comparison.exit_code());
  return text;
}

std::string summary(const Calibration& calibration, const TimeRule& rule) {
  std::string text = fmt::format(
      "calibration  the program against itself: {} false alarms in {} cells of {} pairs\n",
      calibration.false_alarms, calibration.cells, calibration.pairs);
  text +=
      fmt::format("             false-alarm rate {:.4f} % a cell (its pairs relabelled {} times)\n",
                  100 * calibration.false_alarm_rate(), calibration.relabellings);
  if (!std::isfinite(calibration.smallest_slowdown_median)) {
    return text + fmt::format("             no slowdown is visible: {} cells need {} pairs\n",
                              calibration.cells, fewest_pairs(rule, calibration.cells));
  }
  return text + fmt::format(
                    "             smallest slowdown found 99 times of 100: {:.1f} % in half of the "
                    "cells, {:.1f} % in all\n",
                    100 * calibration.smallest_slowdown_median,
                    100 * calibration.smallest_slowdown_worst);
}

}  // namespace ar3d
