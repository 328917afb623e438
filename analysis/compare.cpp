#include "ar3d/analysis/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "ar3d/analysis/compare/pairing.h"
#include "ar3d/analysis/text.h"
#include "ar3d/base/error.h"

namespace ar3d {
namespace {

/// What a cell has to be judged by.
struct Evidence {
  PairedCell cell;
  std::vector<FixedChange> fixed;
  std::vector<double> log_ratios;
  double log2_volume_change = 0;
  bool is_drawn = false;  ///< some pair of drawings is there, so that there are times to judge
};

/// Whether one side is the other: begun at the same moment in the same environment, and every time
/// equal to the last bit.
bool holds_same_measurements(const Results& base, const Results& now) {
  const auto same_time = [](const RunRecord& a, const RunRecord& b) {
    return a.wall_s == b.wall_s || (std::isnan(a.wall_s) && std::isnan(b.wall_s));
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

/// Takes the pairs of one cell, of one round or of all, into the evidence.
void add_pairs(const PairedCell& cell, double instruction_threshold, Evidence& into);

void require_same_study(const Results& base, const Results& now) {
  if (base.study_id == now.study_id) return;
  throw InputError(fmt::format("results of different studies: BASE is '{}', NEW is '{}'",
                               one_line(base.study_id), one_line(now.study_id)));
}

std::vector<FixedChange> fixed_changes_of(const PairedCell& cell, double instruction_threshold) {
  std::vector<FixedChange> changes = instruction_change(cell, instruction_threshold);
  for (const PairedRow& row : cell.rows) {
    for (FixedChange& change : fixed_changes(row)) changes.push_back(std::move(change));
  }
  return changes;
}

void add_pairs(const PairedCell& cell, double instruction_threshold, Evidence& into) {
  for (FixedChange& change : fixed_changes_of(cell, instruction_threshold)) {
    into.fixed.push_back(std::move(change));
  }
  for (const PairedRow& row : cell.rows) {
    const double change = log2_volume_change(row);
    if (std::abs(change) > std::abs(into.log2_volume_change)) into.log2_volume_change = change;
    into.is_drawn |= both_drawn(row);
  }
}

/// Curves of which some size has too few pairs become one cell of all sizes.
std::vector<PairedCell> with_enough_pairs(std::vector<PairedCell> cells, std::size_t enough) {
  std::map<CurveKey, bool> pooled;
  for (const PairedCell& cell : cells) {
    const bool few = log_time_ratios(cell).size() < enough;
    pooled[cell.key] = pooled[cell.key] || few;
  }
  std::map<CurveKey, std::size_t> place_of;
  std::vector<PairedCell> result;
  for (PairedCell& cell : cells) {
    if (!pooled[cell.key]) {
      result.push_back(std::move(cell));
      continue;
    }
    const auto [place, is_new] = place_of.try_emplace(cell.key, result.size());
    if (is_new) {
      result.push_back(std::move(cell));
      continue;
    }
    PairedCell& whole = result[place->second];
    whole.n = -1;
    whole.rows.insert(whole.rows.end(), cell.rows.begin(), cell.rows.end());
  }
  return result;
}

/// The verdict on what has no noise: the heaviest change, and in words how often it occurs.
std::pair<Verdict, std::string> judge_fixed(const std::vector<FixedChange>& changes) {
  if (changes.empty()) return {Verdict::pass, ""};
  const auto worst = std::max_element(
      changes.begin(), changes.end(),
      [](const FixedChange& a, const FixedChange& b) { return a.effect < b.effect; });
  const auto alike = std::count_if(changes.begin(), changes.end(), [&](const FixedChange& change) {
    return change.effect == worst->effect;
  });
  std::string reason = one_line(worst->message);
  if (alike > 1) reason += fmt::format(" (and {} more like it)", alike - 1);
  switch (worst->effect) {
    case Effect::other:
      break;
    case Effect::better:
      return {Verdict::improved, std::move(reason)};
    case Effect::worse:
      return {Verdict::regressed, std::move(reason)};
    case Effect::violated:
      return {Verdict::violated, std::move(reason)};
  }
  return {Verdict::pass, std::move(reason)};
}

std::string undecided_reason(const TimeVerdict& time, std::size_t enough) {
  if (time.test.pairs == 0) return "no time on both sides";
  if (time.test.pairs < enough) {
    return fmt::format("{} pairs of times; {} are needed", time.test.pairs, enough);
  }
  return "the times' noise hides a change of the threshold's size";
}

/// Weighs the noiseless verdict and the time's together. What was not drawn on both sides has no
/// time to judge.
void judge(CellComparison& cell, const std::pair<Verdict, std::string>& fixed, bool is_drawn,
           const TimeRule& rule, const Comparison& comparison) {
  std::tie(cell.verdict, cell.reason) = fixed;
  const std::string& fixed_reason = fixed.second;
  const bool is_heavy = cell.verdict >= Verdict::regressed;
  if (is_heavy || comparison.drawings_only || comparison.is_copy || !is_drawn) return;
  const auto set = [&](Verdict verdict, const std::string& reason) {
    cell.verdict = verdict;
    cell.reason = reason + (fixed_reason.empty() ? "" : "; " + fixed_reason);
  };
  if (!comparison.time_judged) {
    set(Verdict::unjudged, "times not judged");
    return;
  }
  switch (cell.time.change) {
    case TimeChange::same:
      break;
    case TimeChange::slower:
      set(Verdict::regressed, "slower");
      break;
    case TimeChange::faster:
      set(Verdict::improved, "faster");
      break;
    case TimeChange::undecided:
      set(Verdict::inconclusive, undecided_reason(cell.time, fewest_pairs(rule)));
  }
}

Comparison judge_all(std::vector<Evidence> evidence, Comparison comparison,
                     const CompareOptions& options) {
  std::vector<std::vector<double>> log_ratios;
  for (const Evidence& cell : evidence) log_ratios.push_back(cell.log_ratios);
  const std::vector<TimeVerdict> times = judge_times(log_ratios, options.time);
  for (std::size_t i = 0; i < evidence.size(); ++i) {
    CellComparison cell;
    cell.key = evidence[i].cell.key;
    cell.n = evidence[i].cell.n;
    cell.rows = evidence[i].cell.rows.size();
    cell.time = times[i];
    cell.log_ratios = std::move(evidence[i].log_ratios);
    cell.log2_volume_change = evidence[i].log2_volume_change;
    judge(cell, judge_fixed(evidence[i].fixed), evidence[i].is_drawn, options.time, comparison);
    comparison.cells.push_back(std::move(cell));
  }
  return comparison;
}

void note_gaps(const Results& results, const char* side, Comparison& comparison) {
  if (results.runs.empty()) {
    comparison.incomplete.push_back(fmt::format("nothing measured: {} has no rows", side));
  } else if (results.planned_rows > static_cast<std::int64_t>(results.runs.size())) {
    comparison.incomplete.push_back(fmt::format("{} has {} of {} planned rows", side,
                                                results.runs.size(), results.planned_rows));
  }
}

/// A line that is there already is not said again.
void add_once(std::vector<std::string>& lines, std::string line) {
  if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(std::move(line));
}

void note_pairing(const Pairing& pairing, Comparison& comparison) {
  std::size_t untimed = 0;
  for (const PairedCell& cell : pairing.cells) {
    comparison.rows += cell.rows.size();
    untimed += rows_without_time(cell);
  }
  if (pairing.missing > 0) {
    add_once(comparison.incomplete, fmt::format("NEW lacks {} measurements of BASE; the first: {}",
                                                pairing.missing, one_line(pairing.first_missing)));
  }
  if (untimed > 0) {
    add_once(
        comparison.incomplete,
        fmt::format("{} drawn measurements have no time above 0 (NaN, 0 or infinite)", untimed));
  }
  if (pairing.fewer > 0) {
    add_once(comparison.remarks,
             fmt::format("{} timed repetitions of BASE have no partner", pairing.fewer));
  }
  if (pairing.extra > 0) {
    add_once(comparison.remarks,
             fmt::format("{} measurements of NEW are not in BASE", pairing.extra));
  }
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

/// What is to be said of two results before any cell is looked at.
/// @param load_matters  whether other work on the machine makes times incomparable.
Comparison first_look(const Results& base, const Results& now, const CompareOptions& options,
                      bool load_matters) {
  Comparison comparison;
  comparison.drawings_only = options.drawings_only;
  comparison.is_copy = load_matters && holds_same_measurements(base, now);
  if (comparison.is_copy) comparison.remarks.push_back("BASE and NEW hold the same measurements");
  if (!comparison.is_copy) comparison.environment = environment_changes(base, now);
  if (!load_matters) {
    std::erase_if(comparison.environment,
                  [](const EnvironmentChange& change) { return change.name == kLoadOfOtherWork; });
  }
  comparison.time_judged = comparison.environment.empty();
  note_marks(base, "BASE", comparison);
  note_marks(now, "NEW", comparison);
  comparison.time_judged = comparison.time_judged || options.time_always || comparison.is_copy;
  note_gaps(base, "BASE", comparison);
  note_gaps(now, "NEW", comparison);
  return comparison;
}

}  // namespace

Comparison compare(const Results& base, const Results& now, const CompareOptions& options) {
  require_same_study(base, now);
  Comparison comparison = first_look(base, now, options, true);
  Pairing pairing = pair_rows(base, now);
  note_pairing(pairing, comparison);
  std::vector<Evidence> evidence;
  for (PairedCell& cell : with_enough_pairs(std::move(pairing.cells), fewest_pairs(options.time))) {
    Evidence& added = evidence.emplace_back();
    add_pairs(cell, options.instruction_threshold, added);
    added.log_ratios = log_time_ratios(cell);
    added.cell = std::move(cell);
  }
  return judge_all(std::move(evidence), std::move(comparison), options);
}

Comparison compare_rounds(const std::vector<Results>& base, const std::vector<Results>& now,
                          const CompareOptions& options) {
  expect(!base.empty() && base.size() == now.size(), "a comparison of unequally many rounds");
  Comparison comparison = first_look(base.front(), now.front(), options, false);
  std::map<std::pair<CurveKey, std::int64_t>, std::size_t> place_of;
  std::vector<Evidence> evidence;
  for (std::size_t round = 0; round < base.size(); ++round) {
    require_same_study(base[round], now[round]);
    const Pairing pairing = pair_rows(base[round], now[round]);
    note_pairing(pairing, comparison);
    for (const PairedCell& cell : pairing.cells) {
      const auto [place, is_new] = place_of.try_emplace({cell.key, cell.n}, evidence.size());
      if (is_new) evidence.push_back({.cell = cell, .fixed = {}, .log_ratios = {}});
      Evidence& into = evidence[place->second];
      add_pairs(cell, options.instruction_threshold, into);
      const double ratio = round_log_time_ratio(cell);
      if (std::isfinite(ratio)) into.log_ratios.push_back(ratio);
    }
  }
  return judge_all(std::move(evidence), std::move(comparison), options);
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
  for (const Verdict verdict : {Verdict::violated, Verdict::regressed}) {
    if (count(verdict) > 0) return to_string(verdict);
  }
  if (!incomplete.empty() || cells.empty()) return "INCOMPLETE";
  for (const Verdict verdict : {Verdict::inconclusive, Verdict::unjudged}) {
    if (count(verdict) > 0) return to_string(verdict);
  }
  const Verdict good = count(Verdict::improved) > 0 ? Verdict::improved : Verdict::pass;
  return (drawings_only ? "DRAWINGS " : "") + std::string(to_string(good));
}

int Comparison::exit_code() const {
  if (count(Verdict::violated) > 0) return 4;
  if (count(Verdict::regressed) > 0) return 3;
  if (!incomplete.empty() || cells.empty()) return 5;
  if (count(Verdict::inconclusive) > 0) return 6;
  return count(Verdict::unjudged) > 0 ? 7 : 0;
}

std::string Comparison::judged() const {
  if (drawings_only) return "drawings only, as asked";
  return time_judged ? "drawings and times" : "drawings only; times cannot be compared";
}

}  // namespace ar3d
