// One line for each setting: what its cells have in common, and what the rounds of all of them tell
// together, which is more than those of one cell.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "ar3d/analysis/compare/compare.h"

namespace ar3d {
namespace {

/// What a reason says before its first number.
std::string cause_of(const std::string& reason) {
  const std::size_t end = reason.find_first_of(":;(0123456789");
  std::string cause = reason.substr(0, end);
  if (cause.ends_with(" x")) cause.pop_back();
  while (cause.ends_with(' ')) cause.pop_back();
  return cause;
}

void set_times(const SettingVerdicts& rounds, const Comparison& comparison,
               SettingComparison& setting) {
  if (comparison.times) {
    for (const SettingTimes& times : comparison.times->settings) {
      if (times.name != setting.name) continue;
      setting.change = times.distance;
      setting.error = times.error;
      setting.visible = times.least;
    }
  }
  const auto at = rounds.find(setting.name);
  if (at == rounds.end()) return;
  const TimeVerdict& time = at->second;
  const auto [low, high] = time.interval;
  setting.pairs = time.pairs;
  setting.change = time.estimate;
  setting.error = std::max(high - setting.change, setting.change - low);
  setting.visible = time.visible;
  if (!comparison.time_judged || !std::isnan(setting.instructions)) return;
  if (time.change == Verdict::inconclusive || time.change <= setting.verdict) return;
  setting.verdict = time.change;
  setting.of_verdict = 0;
}

/// @param cells  all of one setting.
SettingComparison setting_of(const std::vector<const CellComparison*>& cells) {
  SettingComparison setting;
  setting.name = algorithm_label(cells.front()->key);
  setting.cells = cells.size();
  setting.pairs = cells.front()->time.pairs;
  std::vector<double> instructions;
  std::map<std::string, std::size_t> causes;
  for (const CellComparison* cell : cells)
    setting.verdict = std::max(setting.verdict, cell->verdict);
  for (const CellComparison* cell : cells) {
    setting.pairs = std::min(setting.pairs, cell->time.pairs);
    setting.visible_alone = std::fmax(setting.visible_alone, cell->time.visible);
    if (cell->is_counted()) instructions.push_back(cell->instructions);
    if (cell->verdict != setting.verdict) continue;
    ++setting.of_verdict;
    ++causes[cell->cause];
  }
  setting.instructions = median(std::move(instructions));
  const auto by_count = [](const auto& a, const auto& b) { return a.second < b.second; };
  setting.cause = std::max_element(causes.begin(), causes.end(), by_count)->first;
  return setting;
}

CurveKey setting_of(const RunRecord& run) { return {run.algorithm, run.options, {}, {}}; }

}  // namespace

void judge_settings(const SettingVerdicts& rounds, Comparison& comparison) {
  std::vector<std::vector<const CellComparison*>> by_setting;
  std::map<std::string, std::size_t> index_of;
  for (CellComparison& cell : comparison.cells) {
    cell.cause = cause_of(cell.reason);
    const std::string name = algorithm_label(cell.key);
    const auto [index, is_new] = index_of.try_emplace(name, by_setting.size());
    if (is_new) by_setting.emplace_back();
    by_setting[index->second].push_back(&cell);
  }
  for (const auto& cells : by_setting) {
    comparison.settings.push_back(setting_of(cells));
    if (!comparison.drawings_only) set_times(rounds, comparison, comparison.settings.back());
  }
  std::ranges::stable_sort(comparison.settings, std::greater(), &SettingComparison::verdict);
}

std::string rounded_percent(double log_ratio) {
  const double percent = 100 * std::expm1(log_ratio);
  return std::abs(percent) < 10 ? fmt::format("{:.1f} %", percent)
                                : fmt::format("{:.0f} %", percent);
}

Comparison compare_settings(const Results& results, const std::vector<SettingPair>& pairs,
                            const CompareOptions& options) {
  const bool in_turns = std::ranges::any_of(
      results.environment, [](const EnvironmentEntry& e) { return e.name == kTimingOrder; });
  std::set<CurveKey> timed;  // settings that have a timing phase
  for (const RunRecord& run : results.runs) {
    if (run.phase == RunPhase::timing) timed.insert(setting_of(run));
  }
  std::map<std::pair<std::int64_t, std::int64_t>, std::array<Results, 2>> rounds;
  for (const RunRecord& run : results.runs) {
    const bool is_timed = in_turns && timed.contains(setting_of(run));
    if (is_timed ? run.phase != RunPhase::timing : run.phase != RunPhase::metrics) continue;
    for (const SettingPair& pair : pairs) {
      for (const bool is_now : {false, true}) {
        if (setting_of(run) != (is_now ? pair.now : pair.base)) continue;
        auto& round = is_timed ? rounds[{run.session, run.repetition}] : rounds[{0, 0}];
        RunRecord& row = round[is_now].runs.emplace_back(run);
        row.algorithm = pair.name;
        row.options = row.row_key = "";
      }
    }
  }
  std::array<std::vector<Results>, 2> sides;
  for (auto& [key, round] : rounds) {
    for (const std::size_t side : {0U, 1U}) {
      round[side].environment = results.environment;
      sides[side].push_back(std::move(round[side]));
    }
  }
  if (rounds.empty()) throw InputError("neither of the settings has a row");
  CompareOptions judged = options;
  judged.drawings_only = options.drawings_only || !in_turns;
  Comparison comparison = compare_rounds(sides[0], sides[1], judged);
  if (!in_turns && !options.drawings_only) {
    comparison.remarks.push_back("the file has no times that were taken in turns");
  }
  if (results.planned_rows > static_cast<std::int64_t>(results.runs.size())) {
    comparison.incomplete.push_back(fmt::format("the file has {} of {} planned rows",
                                                results.runs.size(), results.planned_rows));
  }
  return comparison;
}

const char* to_string(Verdict verdict) {
  constexpr const char* kWords[] = {"PASS",         "IMPROVED",  "UNJUDGED",
                                    "INCONCLUSIVE", "REGRESSED", "VIOLATED"};
  return kWords[static_cast<std::size_t>(verdict)];
}

std::size_t Comparison::count(Verdict verdict) const {
  return static_cast<std::size_t>(std::count_if(
      cells.begin(), cells.end(), [&](const auto& cell) { return cell.verdict == verdict; }));
}

std::string Comparison::word() const {
  constexpr const char* kWords[] = {"REGRESSED", "VIOLATED", "INCOMPLETE", "INCONCLUSIVE",
                                    "UNJUDGED"};  // by exit code, from 3 on
  if (const int code = exit_code(); code > 0) return kWords[code - 3];
  const Verdict good = settings.front().verdict;
  return (drawings_only ? "DRAWINGS " : "") + std::string(to_string(good));
}

int Comparison::exit_code() const {
  const auto has = [&](Verdict verdict) {
    return std::ranges::count(settings, verdict, &SettingComparison::verdict) > 0;
  };
  if (has(Verdict::violated)) return 4;
  if (has(Verdict::regressed)) return 3;
  if (!incomplete.empty() || cells.empty()) return 5;
  if (has(Verdict::inconclusive)) return 6;
  return has(Verdict::unjudged) ? 7 : 0;
}

std::string Comparison::judged() const {
  if (drawings_only) return "drawings only, as asked";
  const auto by_counts = static_cast<std::size_t>(
      std::ranges::count_if(cells, [](const CellComparison& cell) { return cell.is_counted(); }));
  const bool has_times = std::ranges::any_of(
      cells, [](const CellComparison& cell) { return !cell.is_counted() && cell.is_timed_enough; });
  std::string text = "drawings";
  if (by_counts > 0) {
    text += fmt::format(
        ", and by counts (instructions, simulated cache), which have no noise, {} of {} cells",
        by_counts, cells.size());
  }
  if (by_counts < cells.size()) {
    text += !time_judged
                ? (by_counts > 0 ? "; times cannot be compared" : " only; times cannot be compared")
            : !has_times    ? "; there are too few times to judge"
            : by_counts > 0 ? ", the others by times"
                            : " and times";
  }
  if (!time_judged || (!has_times && by_counts == 0)) return text;
  if (times && !times->settings.empty()) text += ". " + times_sentence(*times);
  if (count(Verdict::inconclusive) == 0 || remedy.empty()) return text;
  return text + ". " + remedy;
}

}  // namespace ar3d
