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
  return {{"pairs", time.pairs},
          {"ratio", json_number(std::exp(time.estimate))},
          {"ratio_low", json_number(std::exp(time.interval.low))},
          {"ratio_high", json_number(std::exp(time.interval.high))},
          {"p_value", json_number(time.pairs == 0 ? kMissing : time.p_value())},
          {"adjusted_p_value", json_number(time.pairs == 0 ? kMissing : time.adjusted_p)}};
}

ordered_json cell_json(const CellComparison& cell) {
  ordered_json json = key_json(cell.key);
  json.update({{"n", cell.n >= 0 ? ordered_json(cell.n) : ordered_json(nullptr)},
               {"verdict", to_string(cell.verdict)},
               {"reason", valid_utf8(cell.reason)},
               {"measurements", cell.rows},
               {"instructions_ratio", json_number(std::exp(cell.instructions))},
               {"estimated_cycles_ratio", json_number(std::exp(cell.cycles))},
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
  return json;
}

constexpr std::size_t kLargestChanges = 3;

std::string percent(double ratio) { return fmt::format("{:+.1f} %", 100 * (ratio - 1)); }

std::string time_text(const TimeVerdict& time) {
  if (time.pairs == 0) return "not timed";
  std::string text = percent(std::exp(time.estimate));
  if (std::isfinite(time.interval.low)) {
    text += fmt::format(" [{}, {}]", percent(std::exp(time.interval.low)),
                        percent(std::exp(time.interval.high)));
  }
  text += fmt::format(", {} rounds", time.pairs);
  return std::isnan(time.adjusted_p) ? text : text + fmt::format(", p {:.2g}", time.adjusted_p);
}

/// "instructions +0.0 %, cycles +0.2 %; ", or nothing.
std::string counts_of(const CellComparison& cell) {
  if (!cell.is_counted()) return "";
  std::string text = "instructions " + percent(std::exp(cell.instructions));
  if (!std::isnan(cell.cycles)) text += ", cycles " + percent(std::exp(cell.cycles));
  return text + "; ";
}

std::string cell_line(const CellComparison& cell, bool shows_times) {
  const std::string time =
      shows_times ? counts_of(cell) + "time " + time_text(cell.time) : std::string();
  const char* between = time.empty() || cell.reason.empty() ? "" : "; ";
  return fmt::format("{:<12} {:<56} {}{}{}\n", to_string(cell.verdict),
                     cell_label(cell.key, cell.n), time, between, cell.reason);
}

bool has_line(const CellComparison& cell) {
  return cell.verdict != Verdict::pass && cell.verdict != Verdict::unjudged;
}

/// Lines of the cells that did not plainly pass, the heaviest verdicts first: of each cause (a
/// setting, a verdict and why) as many as fit beside the line of the setting and of the largest
/// changes, and how many more there are.
std::string cell_lines(const Comparison& comparison,
                       const std::function<std::string(const CellComparison&, bool)>& line,
                       fmt::format_string<const char*, std::size_t, const std::string&> more) {
  std::string text;
  for (const SettingComparison& setting : comparison.settings) {
    std::map<std::pair<Verdict, std::string>, std::vector<const CellComparison*>, std::greater<>>
        causes;
    for (const CellComparison& cell : comparison.cells) {
      if (!has_line(cell) || algorithm_label(cell.key) != setting.name) continue;
      causes[{cell.verdict, cell.cause}].push_back(&cell);
    }
    for (const auto& [cause, cells] : causes) {
      const std::size_t shown = std::min(cells.size(), kLinesOfCause - 2);
      for (std::size_t i = 0; i < shown; ++i) text += line(*cells[i], !comparison.drawings_only);
      if (shown < cells.size()) {
        text += fmt::format(more, to_string(cause.first), cells.size() - shown, setting.name);
      }
    }
  }
  return text;
}

/// "time -1.0 % +- 19 %: 15 rounds show changes from 24 % on", as far as it is known.
std::string evidence_text(const SettingComparison& setting) {
  std::string text;
  if (!std::isnan(setting.instructions)) {
    text += "; instructions " + percent(std::exp(setting.instructions));
  }
  if (!std::isfinite(setting.error)) return text;
  text += fmt::format("; time {} ± {}", percent(std::exp(setting.change)),
                      rounded_percent(setting.error));
  if (!std::isfinite(setting.visible)) return text;
  if (setting.verdict == Verdict::inconclusive) {
    text += fmt::format(": {} rounds show changes from {} on", setting.pairs,
                        rounded_percent(setting.visible));
  } else if (setting.verdict == Verdict::pass && setting.visible_alone > setting.visible) {
    text += fmt::format("; in one cell alone it shows from {} on",
                        rounded_percent(setting.visible_alone));
  }
  return text;
}

/// "3 of 6 cells: larger volume; time …"
std::string setting_text(const SettingComparison& setting) {
  return fmt::format("{} of {} cells{}{}{}", setting.of_verdict, setting.cells,
                     setting.cause.empty() ? "" : ": ", setting.cause, evidence_text(setting));
}

ordered_json settings_json(const Comparison& comparison) {
  const auto ratio = [](double log) { return json_number(std::exp(log)); };
  ordered_json settings = ordered_json::array();
  for (const SettingComparison& setting : comparison.settings) {
    settings.push_back({{"setting", valid_utf8(setting.name)},
                        {"verdict", to_string(setting.verdict)},
                        {"cells", setting.cells},
                        {"cells_of_verdict", setting.of_verdict},
                        {"cause", valid_utf8(setting.cause)},
                        {"instructions_ratio", ratio(setting.instructions)},
                        {"rounds", setting.pairs},
                        {"time_ratio", ratio(setting.change)},
                        {"time_ratio_low", ratio(setting.change - setting.error)},
                        {"time_ratio_high", ratio(setting.change + setting.error)},
                        {"visible_ratio", ratio(setting.visible)},
                        {"visible_in_one_cell_ratio", ratio(setting.visible_alone)}});
  }
  return settings;
}

/// Returns what changed most among the cells without a line: a change that was not judged is seen.
std::string largest_changes(const Comparison& comparison, std::size_t most) {
  std::string text;
  const auto add = [&](const char* what, const auto& size, const auto& line_of) {
    std::vector<const CellComparison*> cells;
    for (const CellComparison& cell : comparison.cells) {
      if (!has_line(cell) && std::abs(size(cell)) > 0) cells.push_back(&cell);  // no NaN
    }
    std::ranges::stable_sort(cells, std::greater(),
                             [&](const auto* cell) { return std::abs(size(*cell)); });
    cells.resize(std::min(cells.size(), most));
    if (!cells.empty()) text += fmt::format("largest other changes of {}\n", what);
    for (const CellComparison* cell : cells) {
      text += fmt::format("  {:<58} {}\n", cell_label(cell->key, cell->n), line_of(*cell));
    }
  };
  if (!comparison.drawings_only) {
    add(
        comparison.time_judged ? "time (judged)" : "time (NOT JUDGED)",
        [](const auto& cell) { return cell.time.pairs == 0 ? 0 : cell.time.estimate; },
        [](const auto& cell) { return time_text(cell.time); });
  }
  add(
      "volume", [](const auto& cell) { return cell.log2_volume_change; },
      [](const auto& cell) { return percent(std::exp2(cell.log2_volume_change)); });
  return text;
}

std::string environment_text(const Comparison& comparison) {
  if (comparison.environment.empty() || comparison.drawings_only) return "";
  const bool is_unlike = std::ranges::any_of(comparison.environment, &EnvironmentChange::differs);
  std::string text = fmt::format(
      "{}: times are {}\n", is_unlike ? "UNLIKE ENVIRONMENTS" : "BUSY MACHINE",
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
  return fmt::format(
      "time changes by {:.3g} % or more; instructions by more than {:.3g} %, estimated cycles by "
      "more than {:.3g} %; volume, bends, status, certificate: any change for the worse",
      100 * options.threshold, 100 * options.instruction_threshold, 100 * options.cycle_threshold);
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

std::string comparison_json(const Comparison& comparison, const CompareOptions& options) {
  ordered_json json;
  json["verdict"] = comparison.word();
  json["exit_code"] = comparison.exit_code();
  json["judged"] = comparison.judged();
  json["rule"] = {{"threshold", options.threshold},
                  {"significance", options.significance},
                  {"false_discovery_rate", options.false_discovery_rate},
                  {"confidence", options.confidence},
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
  json["settings"] = settings_json(comparison);
  if (comparison.times) json["times"] = times_json(*comparison.times);
  json["cells"] = ordered_json::array();
  for (const CellComparison& cell : comparison.cells) json["cells"].push_back(cell_json(cell));
  return json.dump(1) + "\n";
}

std::string comparison_markdown(const Comparison& comparison, const CompareOptions& options) {
  std::string text = fmt::format("## ar3d compare: {}\n\n", comparison.word());
  std::size_t passed = 0;
  for (const SettingComparison& setting : comparison.settings) {
    if (setting.verdict == Verdict::pass && ++passed > 0) continue;
    text += fmt::format("- **{}** {}: {}\n", to_string(setting.verdict), code_span(setting.name),
                        setting_text(setting));
  }
  if (passed > 0) {
    text += fmt::format("- PASS: {}\n", passed == 1 ? code_span(comparison.settings.back().name) +
                                                          evidence_text(comparison.settings.back())
                                                    : fmt::format("{} settings", passed));
  }
  for (const std::string& line : comparison.incomplete) {
    text += "- incomplete: " + code_span(line) + "\n";
  }
  for (const std::string& line : comparison.remarks) text += "- note: " + code_span(line) + "\n";
  for (const EnvironmentChange& change : comparison.environment) {
    if (comparison.drawings_only) break;
    text += change.differs()
                ? fmt::format("- unlike environments: {} was {}, is {}\n", code_span(change.name),
                              code_span(change.base), code_span(change.now))
                : fmt::format("- busy machine: {} was {} in both\n", code_span(change.name),
                              code_span(change.base));
  }
  text += fmt::format("\n<details><summary>{}</summary>\n\nJudged: {}. Rule: {}. Exit code {}.\n",
                      counts_text(comparison), comparison.judged(), rule_text(options),
                      comparison.exit_code());
  const std::string rows = cell_lines(comparison, markdown_row, "| {} | {} more of {} | | | |\n");
  if (!rows.empty()) {
    text += "\n| verdict | cell | counts, time | volume | reason |\n|---|---|---|---|---|\n" + rows;
  }
  const std::string changes = largest_changes(comparison, kLargestChanges);
  if (!changes.empty()) text += fmt::format("\n~~~\n{}~~~\n", changes);
  return text + "\n</details>\n";
}

std::string summary(const Comparison& comparison, const CompareOptions& options) {
  std::string text;
  for (const SettingComparison& setting : comparison.settings) {
    text += fmt::format("{:<12} {:<28} {}\n", to_string(setting.verdict), one_line(setting.name),
                        setting_text(setting));
  }
  text += environment_text(comparison) +
          cell_lines(comparison, cell_line, "{:<12} {} more of {}\n") +
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

}  // namespace ar3d
