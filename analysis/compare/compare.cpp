// Two results are paired cell by cell. What has no noise is judged first: verdicts, sizes, counts.
// Times decide only where counts are missing, and only if both files hold enough of them. The
// verdict of the whole is the heaviest of its cells.
#include "ar3d/analysis/compare/compare.h"

#include <fmt/format.h>

#include <algorithm>

#include "ar3d/base/printable.h"

namespace ar3d {
namespace {

CellComparison unjudged(const PairedCell& cell) {
  CellComparison compared;
  compared.key = cell.key, compared.n = cell.n, compared.rows = cell.rows.size();
  return compared;
}

/// True if one side is the other: begun at the same moment in the same environment, and every time
/// equal to the last bit.
bool holds_same_measurements(const Results& base, const Results& now) {
  const auto is_same = [](double a, double b) {
    return a == b || (std::isnan(a) && std::isnan(b));
  };
  const auto same_time = [&](const RunRecord& a, const RunRecord& b) {
    return is_same(a.wall_s, b.wall_s) && is_same(a.cpu_s, b.cpu_s);
  };
  const auto same_entry = [](const EnvironmentEntry& a, const EnvironmentEntry& b) {
    return a.name == b.name && a.value == b.value && a.session == b.session;
  };
  return base.created == now.created &&
         std::equal(base.environment.begin(), base.environment.end(), now.environment.begin(),
                    now.environment.end(), same_entry) &&
         std::equal(base.runs.begin(), base.runs.end(), now.runs.begin(), now.runs.end(),
                    same_time);
}

void require_same_study(const Results& base, const Results& now) {
  if (base.study_id == now.study_id) return;
  throw InputError(fmt::format("results of different studies: BASE is '{}', NEW is '{}'",
                               one_line(base.study_id), one_line(now.study_id)));
}

/// Takes in the pairs of one cell, of one round or of all.
void add_pairs(const PairedCell& cell, const CompareOptions& options, CellComparison& into) {
  std::array<double, 2> logs{};
  std::ranges::move(count_changes(cell, options, logs), std::back_inserter(into.fixed));
  if (!std::isnan(logs[0])) into.instructions = logs[0], into.cycles = logs[1];
  for (const PairedRow& row : cell.rows) {
    std::ranges::move(fixed_changes(row), std::back_inserter(into.fixed));
    double& largest = into.log2_volume_change;
    const double change = log2_volume_change(row);
    if (std::abs(change) > std::abs(largest)) largest = change;
    into.is_drawn |= both_drawn(row);
  }
}

/// The verdict on what has no noise: the heaviest change, and in words how often it occurs.
FixedChange judge_fixed(const std::vector<FixedChange>& changes) {
  if (changes.empty()) return {Verdict::pass, ""};
  const auto& [worst, message] = *std::ranges::max_element(changes, {}, &FixedChange::first);
  const auto alike = std::ranges::count(changes, worst, &FixedChange::first);
  std::string reason = one_line(message);
  if (alike > 1) reason += fmt::format(" (and {} more like it)", alike - 1);
  return {worst, std::move(reason)};
}

std::size_t rounds_needed(const Comparison& comparison, const CompareOptions& rule) {
  return comparison.times ? kFewestRounds : fewest_pairs(rule);
}

std::string undecided_reason(const TimeVerdict& time, const Comparison& comparison,
                             const CompareOptions& rule) {
  const std::size_t enough = rounds_needed(comparison, rule);
  if (time.pairs == 0) return "no time on both sides";
  if (time.pairs < enough) {
    return fmt::format("{} rounds of times; {} are needed", time.pairs, enough);
  }
  if (comparison.times && !comparison.times->is_known)
    return "nothing tells how fast the machine was";
  return fmt::format("{} rounds show changes from {} on", time.pairs,
                     rounded_percent(time.visible));
}

/// Weighs the noiseless verdict and the time's together. What was not drawn on both sides has no
/// time to judge. Where counts decide, a slower time is a contradiction and no regression.
void judge(CellComparison& cell, const CompareOptions& rule, const Comparison& comparison) {
  std::tie(cell.verdict, cell.reason) = judge_fixed(cell.fixed);
  const std::string fixed_reason = cell.reason;
  const bool is_heavy = cell.verdict >= Verdict::regressed;
  if (is_heavy || comparison.drawings_only || comparison.is_copy || !cell.is_drawn) return;
  const auto set = [&](Verdict verdict, const std::string& reason) {
    cell.verdict = verdict;
    cell.reason = reason + (fixed_reason.empty() ? "" : "; " + fixed_reason);
  };
  if (cell.is_counted()) {
    if (comparison.time_judged && cell.time.change == Verdict::regressed) {
      set(Verdict::inconclusive, "slower, though its counts have not grown");
    }
    return;
  }
  if (!comparison.time_judged) return set(Verdict::unjudged, "times not judged");
  const Verdict change = cell.time.change;
  if (change == Verdict::pass) return;
  if (change == Verdict::inconclusive) {
    return set(change, undecided_reason(cell.time, comparison, rule));
  }
  const std::string word = change == Verdict::regressed ? "slower" : "faster";
  if (cell.time.follows_setting) return set(change, word + " (as its setting)");
  if (comparison.times && !comparison.times->is_known) {
    return set(Verdict::inconclusive, word + " than all others on a machine of unknown speed");
  }
  set(change, word);
}

/// @param settings  what rounds tell of each; empty for two files.
Comparison judge_all(const std::vector<TimeVerdict>& times, const SettingVerdicts& settings,
                     Comparison comparison, const CompareOptions& options) {
  for (std::size_t i = 0; i < times.size(); ++i) {
    CellComparison& cell = comparison.cells[i];
    cell.time = times[i];
    cell.is_timed_enough = cell.time.pairs >= rounds_needed(comparison, options);
    judge(cell, options, comparison);
  }
  judge_settings(settings, comparison);
  return comparison;
}

/// Why the last session made no more rounds.
std::string last_rounds(const Results& results) {
  std::string last;
  for (const EnvironmentEntry& entry : results.environment) {
    if (entry.name == kTimingRounds) last = one_line(entry.value);
  }
  return last;
}

/// Returns what two files' times say of each cell; `comparison.times` of all.
std::vector<TimeVerdict> judge_files(const std::vector<CellTimes>& cells, const Results& base,
                                     const Results& now, const CompareOptions& rule,
                                     Comparison& comparison) {
  std::array<double, 3> yardsticks = yardsticks_of(now);
  const std::array<double, 3> before = yardsticks_of(base);
  for (std::size_t i = 0; i < before.size(); ++i) yardsticks[i] -= before[i];
  comparison.times = judge_file_times(cells, yardsticks, rule);
  comparison.times->rounds = {last_rounds(base), last_rounds(now)};
  std::vector<TimeVerdict> verdicts(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    TimeVerdict& verdict = verdicts[i];
    verdict.pairs = cells[i].rounds;
    verdict.estimate = cells[i].ratio;
    verdict.p_greater = verdict.p_less = verdict.adjusted_p = kMissing;  // nothing is tested
    verdict.change = comparison.times->cells[i];
    const double error = comparison.times->errors[i];
    verdict.interval = {cells[i].ratio - error, cells[i].ratio + error};
    for (const SettingTimes& setting : comparison.times->settings) {
      if (setting.name == cells[i].setting) verdict.visible = setting.least;
    }
  }
  return verdicts;
}

void note_gaps(const Results& results, const char* side, Comparison& comparison) {
  if (results.runs.empty()) {
    comparison.incomplete.push_back(fmt::format("nothing measured: {} has no rows", side));
  } else if (results.planned_rows > static_cast<std::int64_t>(results.runs.size())) {
    comparison.incomplete.push_back(fmt::format("{} has {} of {} planned rows", side,
                                                results.runs.size(), results.planned_rows));
  }
}

/// The pairs of two results, and what is to be said of them.
std::vector<PairedCell> pairs_of(const Results& base, const Results& now, Comparison& comparison) {
  std::vector<PairedCell> cells = pair_rows(base, now, comparison.incomplete, comparison.remarks);
  std::size_t untimed = 0;
  for (const PairedCell& cell : cells) {
    comparison.rows += cell.rows.size();
    untimed += rows_without_time(cell);
  }
  if (untimed > 0) {
    add_once(
        comparison.incomplete,
        fmt::format("{} drawn measurements have no time above 0 (NaN, 0 or infinite)", untimed));
  }
  const auto failed = [](const PairedRow& row) {
    return std::ranges::all_of(row, is_unfinished, &RunRecord::status);
  };
  for (const PairedCell& cell : cells) {
    const auto at = std::ranges::find_if(cell.rows, failed);
    if (at == cell.rows.end()) continue;
    add_once(comparison.incomplete,
             fmt::format("{} came out on neither side: {}", one_line(cell_label(cell.key, cell.n)),
                         one_line(at->back()->message)));
  }
  return cells;
}

/// Marks of sanitised or unoptimised builds.
void note_marks(const Results& results, const char* side, Comparison& comparison) {
  const auto marked = std::find_if(results.runs.begin(), results.runs.end(),
                                   [](const RunRecord& run) { return !run.build_kind.empty(); });
  if (marked == results.runs.end()) return;
  comparison.remarks.push_back(
      fmt::format("{} was measured by a {} build", side, one_line(marked->build_kind)));
  comparison.time_judged = false;
}

bool has_yardsticks(const Results& results) {
  return std::any_of(results.runs.begin(), results.runs.end(),
                     [](const RunRecord& run) { return run.yardsticks_s[0] > 0; });
}

/// Notes which version of each of the study's own programs is compared with which.
void note_versions(const Results& base, const Results& now, Comparison& comparison) {
  constexpr std::string_view kVersion = "version_";
  std::map<std::string, std::array<std::string, 2>> versions;
  for (const std::size_t side : {0U, 1U}) {
    for (const EnvironmentEntry& entry : (side == 0 ? base : now).environment) {
      if (entry.name.starts_with(kVersion)) versions[entry.name][side] = entry.value;
    }
  }
  const auto text = [](const std::string& of) { return of.empty() ? "unknown" : one_line(of); };
  for (const auto& [name, of] : versions) {
    if (of[0] == of[1]) continue;
    comparison.remarks.push_back(fmt::format("{}: version {} in BASE, {} in NEW",
                                             one_line(name.substr(kVersion.size())), text(of[0]),
                                             text(of[1])));
  }
}

/// Returns what is to be said of two results before any cell is looked at.
/// @param in_turns  whether they were measured in turns; files were one after the other.
Comparison first_look(const Results& base, const Results& now, const CompareOptions& options,
                      bool in_turns) {
  Comparison comparison;
  comparison.drawings_only = options.drawings_only;
  comparison.is_copy = !in_turns && holds_same_measurements(base, now);
  if (comparison.is_copy) comparison.remarks.push_back("BASE and NEW hold the same measurements");
  if (!comparison.is_copy) comparison.environment = environment_changes(base, now);
  // Yardsticks tell better than the load whether the machine was as fast in both.
  if (in_turns || (has_yardsticks(base) && has_yardsticks(now))) {
    std::erase_if(comparison.environment,
                  [](const EnvironmentChange& change) { return change.name == kLoadOfOtherWork; });
  }
  comparison.time_judged = comparison.environment.empty();
  note_versions(base, now, comparison);
  note_marks(base, "BASE", comparison);
  note_marks(now, "NEW", comparison);
  comparison.time_judged = comparison.time_judged || options.time_always || comparison.is_copy;
  note_gaps(base, "BASE", comparison);
  note_gaps(now, "NEW", comparison);
  return comparison;
}

/// As judge_times, with the smallest change that each shows.
std::vector<TimeVerdict> judge_rounds(const std::vector<std::vector<double>>& log_ratios,
                                      const CompareOptions& rule) {
  std::vector<TimeVerdict> times = judge_times(log_ratios, rule);
  for (std::size_t i = 0; i < times.size(); ++i) {
    std::vector<double> noise = log_ratios[i];
    for (double& ratio : noise) ratio -= times[i].estimate;
    times[i].visible = std::log1p(smallest_visible_slowdown(std::move(noise), rule, times.size()));
  }
  return times;
}

/// Gives a cell that its own rounds leave open the verdict of its setting, unless they differ from
/// the setting's estimate: by the signed-rank test, its p-value times `tests` at most the rule's
/// false_discovery_rate. @param log_ratios  of the cell's rounds.
void follow_setting(const TimeVerdict& setting, std::vector<double> log_ratios,
                    const CompareOptions& rule, std::size_t tests, TimeVerdict& cell) {
  if (cell.change != Verdict::inconclusive || cell.pairs < fewest_pairs(rule)) return;
  for (double& ratio : log_ratios) ratio -= setting.estimate;
  const double p = judge_times({std::move(log_ratios)}, rule).front().p_value();
  if (p * static_cast<double>(tests) <= rule.false_discovery_rate) return;
  cell.change = setting.change;
  cell.follows_setting = cell.change != Verdict::inconclusive;
}

}  // namespace

Comparison compare(const Results& base, const Results& now, const CompareOptions& options) {
  require_same_study(base, now);
  Comparison comparison = first_look(base, now, options, false);
  std::vector<CellTimes> cells;
  for (const PairedCell& cell : pairs_of(base, now, comparison)) {
    add_pairs(cell, options, comparison.cells.emplace_back(unjudged(cell)));
    cells.push_back(cell_times(cell));
  }
  const std::vector<TimeVerdict> times = judge_files(cells, base, now, options, comparison);
  return judge_all(times, {}, std::move(comparison), options);
}

Comparison compare_rounds(const std::vector<Results>& base, const std::vector<Results>& now,
                          const CompareOptions& options) {
  expect(!base.empty() && base.size() == now.size(), "a comparison of unequally many rounds");
  Comparison comparison = first_look(base.front(), now.front(), options, true);
  std::map<std::pair<CurveKey, std::int64_t>, std::size_t> index_of;
  std::map<std::string, std::vector<double>> rounds_of;  // of a setting
  for (std::size_t round = 0; round < base.size(); ++round) {
    require_same_study(base[round], now[round]);
    std::map<std::string, std::vector<double>> of_round;
    for (const PairedCell& cell : pairs_of(base[round], now[round], comparison)) {
      const auto [index, is_new] =
          index_of.try_emplace({cell.key, cell.n}, comparison.cells.size());
      if (is_new) comparison.cells.push_back(unjudged(cell));
      CellComparison& into = comparison.cells[index->second];
      add_pairs(cell, options, into);
      const double ratio = round_log_time_ratio(cell);
      if (!std::isfinite(ratio)) continue;
      into.log_ratios.push_back(ratio);
      of_round[algorithm_label(cell.key)].push_back(ratio);
    }
    for (auto& [name, ratios] : of_round) rounds_of[name].push_back(median(std::move(ratios)));
  }
  std::vector<std::vector<double>> of_cells, of_settings;
  for (const CellComparison& cell : comparison.cells) of_cells.push_back(cell.log_ratios);
  for (const auto& [name, ratios] : rounds_of) of_settings.push_back(ratios);
  std::vector<TimeVerdict> times = judge_rounds(of_cells, options);
  const std::vector<TimeVerdict> all = judge_rounds(of_settings, options);
  SettingVerdicts settings;
  for (const auto& [name, ratios] : rounds_of) settings[name] = all[settings.size()];
  for (std::size_t i = 0; i < times.size(); ++i) {
    const auto setting = settings.find(algorithm_label(comparison.cells[i].key));
    if (setting == settings.end()) continue;
    follow_setting(setting->second, of_cells[i], options, times.size(), times[i]);
  }
  return judge_all(times, settings, std::move(comparison), options);
}

}  // namespace ar3d
