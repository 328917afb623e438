#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ar3d/analysis/compare/file_times.h"
#include "ar3d/analysis/compare/pairing.h"
#include "ar3d/analysis/compare/time_change.h"
#include "ar3d/store/columns/curves.h"
#include "ar3d/store/rows.h"

namespace ar3d {

/// Describes one thing about the machine, the build or its load that two results do not share.
struct EnvironmentChange {
  std::string name;  ///< "cpu", "flags", …
  std::string base;  ///< its value there, "absent" if none
  std::string now;
  /// Returns false for a machine that was equally busy with other work on both sides.
  bool differs() const { return base != now; }
};

/// Holds the name of the change that says that the machine was busy.
inline constexpr const char* kLoadOfOtherWork = "load of other work";

/// Returns all lasting settings of a machine and a build, by name (processor, cores, kernel,
/// compiler, flags, libraries, threads, variables); values of several sessions, "a | b". Results
/// with equal settings are of one environment.
std::map<std::string, std::string> lasting_settings(
    const std::vector<EnvironmentEntry>& environment);

/// Returns the one-minute load at a session's beginning that is more than half of the cores, or at
/// its end, if it is as much more than the rows that it made at a time; empty if none is.
std::string load_of_other_work(const std::vector<EnvironmentEntry>& environment,
                               double rows_at_a_time);

/// Returns what makes times of the two incomparable: every recorded setting that differs
/// (processor, cores, kernel, compiler, flags, libraries, threads, variables), and a machine busy
/// with other work when either began (one-minute load above half of its cores). Values of several
/// sessions count together. Empty: alike.
std::vector<EnvironmentChange> environment_changes(const Results& base, const Results& now);

/// Describes the verdict on one cell: an algorithm with its options on a family at one size.
struct CellComparison {
  CurveKey key;
  std::int64_t n = -1;
  std::size_t rows = 0;
  Verdict verdict = Verdict::pass;
  std::string reason;              ///< one line, empty for a plain pass
  std::string cause;               ///< what the reason says before its first number
  double instructions = kMissing;  ///< count_change(): given, they decide, and times do not
  double cycles = kMissing;        ///< as well
  bool is_counted() const { return !std::isnan(instructions); }
  std::vector<FixedChange> fixed;  ///< what changed that has no noise
  bool is_drawn = false;           ///< some pair of drawings is there, so that times can be judged
  std::vector<double> log_ratios;  ///< of turns: one for each round
  TimeVerdict time;                ///< of log(new / base)
  bool is_timed_enough = false;    ///< there are as many rounds of times as a verdict needs
  /// Holds log2(new / base) of the volume, of the pair of drawings in which it changed most.
  double log2_volume_change = 0;
};

/// Describes what all cells of one algorithm with its options say together.
struct SettingComparison {
  std::string name;  ///< algorithm_label()
  std::size_t cells = 0;
  Verdict verdict = Verdict::pass;  ///< the heaviest of its cells and, in turns, of its times
  std::size_t of_verdict = 0;       ///< cells that have it
  std::string cause;                ///< what most of these have in common; empty for a plain pass
  double instructions = kMissing;   ///< log(new / base), median over its counted cells
  std::size_t pairs = 0;            ///< rounds of times, of the cell with the fewest
  double change = kMissing;   ///< log(new / base) of its times; of two files against all others
  double error = kMissing;    ///< `change` is within +- error with 95 %
  double visible = kMissing;  ///< smallest change that so many rounds show
  double visible_alone = kMissing;  ///< likewise in one cell alone, of its noisiest
};

struct Comparison {
  std::vector<CellComparison> cells;        ///< in base's order
  std::vector<SettingComparison> settings;  ///< the heaviest verdicts first
  std::vector<EnvironmentChange> environment;
  bool time_judged = true;         ///< false: unlike environments, times are shown but are no gate
  bool drawings_only = false;      ///< times were not to be judged
  bool is_copy = false;            ///< the two hold the same measurements, down to every time
  std::optional<FileTimes> times;  ///< of two files
  std::string remedy;              ///< a sentence: what takes turns; empty: nothing does
  std::size_t rows = 0;            ///< measurements that both sides hold
  std::vector<std::string> incomplete;  ///< why the comparison is not whole, one line each
  std::vector<std::string> remarks;     ///< one line each

  std::size_t count(Verdict verdict) const;  ///< of cells
  /// Returns the heaviest verdict of all cells and settings, between which stands INCOMPLETE (below REGRESSED).
  /// PASS and IMPROVED say that everything was judged; "DRAWINGS PASS" and "DRAWINGS IMPROVED" that
  /// times were not to be.
  std::string word() const;
  /// Returns the exit code: 0 pass or improved, 3 regression, 4 violated, 5 incomplete or nothing
  /// compared, 6 inconclusive, 7 times not judged.
  int exit_code() const;
  /// Returns what the verdict is about, in a sentence or a few: what was judged by counts and what
  /// by times, how fast the machine was on either side, what moved against all others, what cannot
  /// be said and what to run to be able to say it.
  std::string judged() const;
};

/// Compares two results: first what has no noise (status, certificate, graph, volume, bends, counts
/// of callgrind), then, where counts are missing, times of drawing, measured one after the other
/// (judge_file_times). Two that hold the same measurements, down to every time (a file and its
/// copy), are alike whatever the machine was doing. Cost: O(r log r) for r rows.
/// @throws InputError if the two are of different studies, or one holds a measurement twice.
Comparison compare(const Results& base, const Results& now, const CompareOptions& options = {});

/// Compares settings of one results file: drawings always, times of its timing phase if it drew the
/// settings of each graph in turns (kTimingOrder). A round is one repetition in one session.
/// @param pairs  each becomes the setting of its name.
/// @throws InputError as compare().
Comparison compare_settings(const Results& results, const std::vector<SettingPair>& pairs,
                            const CompareOptions& options = {});

/// Compares two programs that took turns: base[i] and now[i] were measured one right after the
/// other, and a pair is a round. Load that disturbed both is no reason not to judge times.
/// @param base, now  equally many, at least one.
Comparison compare_rounds(const std::vector<Results>& base, const std::vector<Results>& now,
                          const CompareOptions& options = {});

/// Holds how many lines one cause has, that of its setting included.
inline constexpr std::size_t kLinesOfCause = 10;

/// Returns a text for a terminal: a line for each setting, the environment where it differs, the
/// cells that did not pass, the largest changes of time and volume of those that did, and the
/// verdict with what it judged. No times where drawings only were to be judged.
std::string summary(const Comparison& comparison, const CompareOptions& options);

/// Returns the same as Markdown, for a comment on a change: the verdict as a heading, a line for
/// each setting that did not pass, what was judged, and folded a table of the cells. Every foreign
/// text stands in a code span, out of which no text leads.
std::string comparison_markdown(const Comparison& comparison, const CompareOptions& options);

/// Returns everything, for programs; missing numbers are null.
std::string comparison_json(const Comparison& comparison, const CompareOptions& options);

/// Holds what the rounds of all cells of a setting tell together, by algorithm_label().
using SettingVerdicts = std::map<std::string, TimeVerdict>;

/// Fills Comparison::settings from its cells. @param rounds  of settings in turns; of two files
/// Comparison::times says it.
void judge_settings(const SettingVerdicts& rounds, Comparison& comparison);

/// Returns "4.8 %" or "24 %" of the logarithm of a ratio.
std::string rounded_percent(double log_ratio);

}  // namespace ar3d
