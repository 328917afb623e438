// Two results are paired cell by cell. What has no noise is judged first: verdicts, sizes, counts.
// Times decide only where counts are missing, and only if both files hold enough of them. The
// verdict of the whole is the heaviest of its cells.
#include "ar3d/analysis/compare/compare.h"

#include <fmt/format.h>

#include "ar3d/base/printable.h"

namespace ar3d {
namespace {

/// Holds what a cell has to be judged by.
struct Evidence {
  CellComparison cell = {};  ///< without verdict and time
  std::vector<FixedChange> fixed = {};
  bool is_drawn = false;  ///< some pair of drawings is there, so that there are times to judge
};

Evidence evidence_of(const PairedCell& cell) {
  Evidence evidence;
  evidence.cell.key = cell.key, evidence.cell.n = cell.n, evidence.cell.rows = cell.rows.size();
  return evidence;
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

/// Takes the pairs of one cell, of one round or of all, into the evidence.
void add_pairs(const PairedCell& cell, const CompareOptions& options, Evidence& into) {
  const CountChange counts = count_change(cell);
  if (counts.is_known()) into.cell.counts = counts;
  for (FixedChange& change :
       count_changes(counts, options.instruction_threshold, options.cycle_threshold)) {
    into.fixed.push_back(std::move(change));
  }
  for (const PairedRow& row : cell.rows) {
    for (FixedChange& change : fixed_changes(row)) into.fixed.push_back(std::move(change));
    double& largest = into.cell.log2_volume_change;
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

std::string undecided_reason(const TimeVerdict& time, const Comparison& comparison,
                             const TimeRule& rule) {
  const std::size_t enough = comparison.times ? kFewestRounds : fewest_pairs(rule);
  if (time.test.pairs == 0) return "no time on both sides";
  if (time.test.pairs < enough) {
    return fmt::format("{} rounds of times; {} are needed", time.test.pairs, enough);
  }
  if (comparison.times && !comparison.times->is_known)
    return "nothing tells how fast the machine was";
  return "the times' noise hides a change of the threshold's size";
}

/// Weighs the noiseless verdict and the time's together. What was not drawn on both sides has no
/// time to judge. Where counts decide, a slower time is a contradiction and no regression.
void judge(CellComparison& cell, const FixedChange& fixed, bool is_drawn, const TimeRule& rule,
           const Comparison& comparison) {
  std::tie(cell.verdict, cell.reason) = fixed;
  const std::string& fixed_reason = fixed.second;
  const bool is_heavy = cell.verdict >= Verdict::regressed;
  if (is_heavy || comparison.drawings_only || comparison.is_copy || !is_drawn) return;
  const auto set = [&](Verdict verdict, const std::string& reason) {
    cell.verdict = verdict;
    cell.reason = reason + (fixed_reason.empty() ? "" : "; " + fixed_reason);
  };
  if (cell.counts.is_known()) {
    if (comparison.time_judged && cell.time.change == TimeChange::slower) {
      set(Verdict::inconclusive, "slower, though its counts have not grown");
    }
    return;
  }
  if (!comparison.time_judged) return set(Verdict::unjudged, "times not judged");
  if (cell.time.change == TimeChange::same) return;
  if (cell.time.change == TimeChange::undecided) {
    return set(Verdict::inconclusive, undecided_reason(cell.time, comparison, rule));
  }
  const bool is_slower = cell.time.change == TimeChange::slower;
  const std::string word = is_slower ? "slower" : "faster";
  if (comparison.times && !comparison.times->is_known) {
    return set(Verdict::inconclusive, word + " than all others on a machine of unknown speed");
  }
  set(is_slower ? Verdict::regressed : Verdict::improved, word);
}

Comparison judge_all(std::vector<Evidence> evidence, const std::vector<TimeVerdict>& times,
                     Comparison comparison, const CompareOptions& options) {
  for (std::size_t i = 0; i < evidence.size(); ++i) {
    CellComparison& cell = evidence[i].cell;
    cell.time = times[i];
    judge(cell, judge_fixed(evidence[i].fixed), evidence[i].is_drawn, options.time, comparison);
    comparison.cells.push_back(std::move(cell));
  }
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
                                     const Results& now, const TimeRule& rule,
                                     Comparison& comparison) {
  std::array<double, 3> yardsticks = yardsticks_of(now);
  const std::array<double, 3> before = yardsticks_of(base);
  for (std::size_t i = 0; i < before.size(); ++i) yardsticks[i] -= before[i];
  comparison.times = judge_file_times(cells, yardsticks, rule);
  comparison.times->rounds = {last_rounds(base), last_rounds(now)};
  std::vector<TimeVerdict> verdicts(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    SignedRankTest& test = verdicts[i].test;
    test.pairs = cells[i].rounds;
    test.estimate = cells[i].ratio;
    test.interval = {kMissing, kMissing};
    verdicts[i].adjusted_p = kMissing;
    verdicts[i].change = comparison.times->cells[i];
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
  comparison.base_commit = base.source_hash;
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

}  // namespace

Comparison compare(const Results& base, const Results& now, const CompareOptions& options) {
  require_same_study(base, now);
  Comparison comparison = first_look(base, now, options, false);
  const Pairing pairing = pair_rows(base, now);
  note_pairing(pairing, comparison);
  std::vector<Evidence> evidence;
  std::vector<CellTimes> cells;
  for (const PairedCell& cell : pairing.cells) {
    add_pairs(cell, options, evidence.emplace_back(evidence_of(cell)));
    cells.push_back(cell_times(cell));
  }
  const std::vector<TimeVerdict> times = judge_files(cells, base, now, options.time, comparison);
  return judge_all(std::move(evidence), times, std::move(comparison), options);
}

Comparison compare_rounds(const std::vector<Results>& base, const std::vector<Results>& now,
                          const CompareOptions& options) {
  expect(!base.empty() && base.size() == now.size(), "a comparison of unequally many rounds");
  Comparison comparison = first_look(base.front(), now.front(), options, true);
  std::map<std::pair<CurveKey, std::int64_t>, std::size_t> place_of;
  std::vector<Evidence> evidence;
  for (std::size_t round = 0; round < base.size(); ++round) {
    require_same_study(base[round], now[round]);
    const Pairing pairing = pair_rows(base[round], now[round]);
    note_pairing(pairing, comparison);
    for (const PairedCell& cell : pairing.cells) {
      const auto [place, is_new] = place_of.try_emplace({cell.key, cell.n}, evidence.size());
      if (is_new) evidence.push_back(evidence_of(cell));
      Evidence& into = evidence[place->second];
      add_pairs(cell, options, into);
      const double ratio = round_log_time_ratio(cell);
      if (std::isfinite(ratio)) into.cell.log_ratios.push_back(ratio);
    }
  }
  std::vector<std::vector<double>> log_ratios;
  for (const Evidence& cell : evidence) log_ratios.push_back(cell.cell.log_ratios);
  const std::vector<TimeVerdict> times = judge_times(log_ratios, options.time);
  return judge_all(std::move(evidence), times, std::move(comparison), options);
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
  const auto by_counts = static_cast<std::size_t>(std::count_if(
      cells.begin(), cells.end(), [](const auto& cell) { return cell.counts.is_known(); }));
  std::string text = "drawings";
  if (by_counts > 0) {
    text += fmt::format(
        ", and by counts (instructions, simulated cache), which have no noise, {} of {} cells",
        by_counts, cells.size());
  }
  const bool has_timed = by_counts < cells.size();
  if (!time_judged && by_counts == 0) return "drawings only; times cannot be compared";
  if (!time_judged) return text + (has_timed ? "; times cannot be compared" : "");
  if (has_timed) text += by_counts > 0 ? ", the others by times" : " and times";
  if (!times || times->settings.empty()) return text;
  text += ". " + times_sentence(*times);
  if (count(Verdict::inconclusive) == 0) return text;
  const bool is_commit = base_commit.size() == 40;
  return text +
         fmt::format(". To know more: `ar3d compare --base {}` runs both builds in turns{}",
                     is_commit ? base_commit.substr(0, 12) : "COMMIT",
                     times->is_known ? ", or measure more rounds" : ", or measure both again");
}

}  // namespace ar3d
