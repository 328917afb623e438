// `ar3d bisect`: which commit changed a cell? Builds and compares until it is found.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "ar3d/analysis/compare/pairing.h"
#include "ar3d/analysis/compare/signed_rank.h"
#include "ar3d/analysis/history/cell_values.h"
#include "ar3d/analysis/history/change_points.h"
#include "ar3d/base/error.h"
#include "ar3d/base/nearest_name.h"
#include "ar3d/base/printable.h"
#include "ar3d/base/say.h"
#include "ar3d/bench/compare/commits.h"
#include "ar3d/bench/compare/interleave.h"
#include "ar3d/bench/measure/processes.h"
#include "ar3d/bench/plan/plan.h"
#include "ar3d/store/columns/curves.h"
#include "ar3d/store/run_storage.h"
#include "commands.h"
#include "options.h"

namespace ar3d {
namespace {

namespace fs = std::filesystem;

constexpr double kConfidence = 0.99;  // of one decision about a commit
constexpr int kTimedRepetitions = 5;  // of one round; the smallest time counts
constexpr int kDoublings = 2;         // of the rounds, where they leave it open
constexpr double kInstructionThreshold = 0.01;
constexpr double kCycleThreshold = 0.05;

struct BisectArguments {
  std::string good;
  std::string bad = "HEAD";
  std::string cell;
  std::string study = "regression";
  std::string measure = "time";
  std::size_t rounds = 15;
  int core = -1;
  double threshold_percent = 2;
  bool quiet = false;
};

bool is_counted(const std::string& measure) {
  return measure == to_string(Measure::instructions) || measure == to_string(Measure::cycles);
}

/// Thrown where a signal asked to stop.
struct BisectStopped {};

/// Runs the cell with GOOD and another program.
class CellJudge {
 public:
  CellJudge(std::string good, StudySpec spec, std::string folder, const BisectArguments& arguments)
      : good_(std::move(good)),
        spec_(std::move(spec)),
        folder_(std::move(folder)),
        arguments_(arguments) {}

  /// What a program does otherwise than GOOD: log(its value / GOOD's), with an interval; for volume
  /// and bends 1 if some drawing's are other ones, else 0.
  /// @param boundary  more rounds are made until the interval is without it; none: once.
  /// @throws BisectStopped; InputError if a program does not run, or the cell has no value.
  Shift difference(const std::string& program, std::optional<double> boundary) const {
    return arguments_.measure == "time" ? of_time(program, boundary) : of_drawings(program);
  }

 private:
  InterleavedRounds run(const std::string& program, std::size_t rounds) const {
    InterleaveOptions options{rounds, arguments_.core, nullptr};
    options.count = is_counted(arguments_.measure);
    InterleavedRounds run = run_interleaved(good_, program, spec_, folder_, options);
    if (run.interrupted) throw BisectStopped();
    return run;
  }

  Shift of_time(const std::string& program, std::optional<double> boundary) const {
    std::vector<double> log_ratios;
    SignedRankTest test;
    for (int doubling = 0; doubling <= (boundary ? kDoublings : 0); ++doubling) {
      const std::size_t more = doubling == 0 ? arguments_.rounds : log_ratios.size();
      const InterleavedRounds rounds = run(program, std::max<std::size_t>(more, 1));
      for (std::size_t i = 0; i < rounds.base.size(); ++i) {
        for (const PairedCell& cell : pair_rows(rounds.base[i], rounds.now[i]).cells) {
          const double ratio = round_log_time_ratio(cell);
          if (std::isfinite(ratio)) log_ratios.push_back(ratio);
        }
      }
      test = signed_rank_test(log_ratios, SignedRankDistribution(log_ratios.size()), kConfidence);
      if (log_ratios.empty()) throw InputError("the cell has no times");
      if (boundary && !test.interval.contains(*boundary)) break;
    }
    return {test.estimate, test.interval};
  }

  Shift of_drawings(const std::string& program) const {
    const InterleavedRounds rounds = run(program, 1);
    const CellValue base = value_of(rounds.base.front()), now = value_of(rounds.now.front());
    const double ratio = std::log(now.value / base.value);
    const double change = is_counted(arguments_.measure) ? ratio : base.exact == now.exact ? 0 : 1;
    return {change, {change, change}};
  }

  CellValue value_of(const Results& results) const {
    for (const auto& [cell, values] : cell_values(view_of(results)).cells) {
      for (std::size_t i = 0; i < kMeasures.size(); ++i) {
        const bool is_asked = to_string(kMeasures[i]) == arguments_.measure;
        if (is_asked && std::isfinite(values[i].value)) return values[i];
      }
    }
    throw InputError(fmt::format("the cell has no {}", arguments_.measure));
  }

  std::string good_;
  StudySpec spec_;
  std::string folder_;
  const BisectArguments& arguments_;
};

std::string text_of(const Shift& difference, const std::string& measure) {
  const auto percent = [](double log) { return fmt::format("{:+.3g} %", 100 * std::expm1(log)); };
  if (measure == "volume" || measure == "bends") {
    return difference.estimate > 0 ? fmt::format("{} changed", measure)
                                   : fmt::format("{} as GOOD's", measure);
  }
  std::string text = fmt::format("{} {}", measure, percent(difference.estimate));
  if (measure == "time" && std::isfinite(difference.interval.low)) {
    text += fmt::format(" [{}, {}]", percent(difference.interval.low),
                        percent(difference.interval.high));
  }
  return text;
}

/// What a plan says of the cell.
struct PlannedCell {
  CurveKey curve;
  std::uint64_t requested_n = 0;
  std::uint32_t instances = 0;
};

PlannedCell find_cell(const StudySpec& spec, const std::string& cell) {
  PlannedCell found;
  std::set<std::string> labels;
  for (const PlannedInstance& instance : plan_study(spec).instances) {
    for (const PlannedRun& run : instance.runs) {
      const CurveKey curve = curve_of(instance, run);
      const std::string label = cell_label(curve, static_cast<std::int64_t>(instance.n));
      labels.insert(label);
      if (label != cell) continue;
      found.curve = curve;
      found.requested_n = instance.requested_n;
      found.instances = std::max(found.instances, instance.index + 1);
    }
  }
  if (found.instances > 0) return found;
  throw InputError(fmt::format("study '{}' has no cell '{}'{}", spec.name, cell,
                               did_you_mean(cell, {labels.begin(), labels.end()})));
}

/// "k=2;p=5" as ", k = 2, p = 5".
std::string toml_settings(std::string_view settings) {
  std::string toml = settings.empty() ? "" : ", ";
  for (const char c : settings) toml += c == '=' ? " = " : c == ';' ? ", " : std::string(1, c);
  return toml;
}

/// The study of one cell of another one: its graphs with their seeds, its algorithm and options.
/// @param cell  as cell_label() says it.
/// @param timed_repetitions  of every drawing; 0: none is timed.
/// @throws InputError naming the cell, and the nearest, if the study has no such cell, or if its
/// graphs are of a file or its algorithm is a program.
StudySpec study_of_cell(const StudySpec& spec, const std::string& cell, int timed_repetitions) {
  const PlannedCell found = find_cell(spec, cell);
  const std::string text = fmt::format(
      "study = \"{}\"\nseed = {}\n[[sweep]]\nfamilies = {{ family = \"{}\"{} }}\nsizes = {}\n"
      "algorithms = {{ algorithm = \"{}\"{} }}\nlevel = \"{}\"\ninstances = {}\n"
      "timed_repetitions = {}\n",
      spec.name, spec.seed, found.curve.family, toml_settings(found.curve.parameters),
      found.requested_n, found.curve.algorithm, toml_settings(found.curve.options),
      found.curve.level.empty() ? "extents" : found.curve.level, found.instances,
      timed_repetitions);
  try {
    return parse_study(text, "the study of the cell");
  } catch (const InputError& error) {
    throw InputError(fmt::format(
        "cell '{}' cannot be run by itself (its graphs are of a file, or its algorithm is a "
        "program, which `git bisect run` finds the commit of: docs/own-program.md): {}",
        cell, error.what()));
  }
}

/// A TOML file, a named study, or that of a results file. @throws InputError
StudySpec study_named(const std::string& name) {
  if (!name.ends_with(".h5")) return load_study(name);
  return recorded_study(ResultsReader(name, run_format()).identity(), name);
}

/// The whole search, with everything that it says.
class CommitSearch {
 public:
  explicit CommitSearch(const BisectArguments& arguments)
      : arguments_(arguments),
        checkout_(find_checkout()),
        folder_((fs::path(checkout_) / "build" / "compare").string()) {}

  /// @throws BisectStopped, InputError.
  int run() {
    const StudySpec spec = study_of_cell(study_named(arguments_.study), arguments_.cell,
                                         arguments_.measure == "time" ? kTimedRepetitions : 0);
    const std::string good = commit_of(checkout_, arguments_.good);
    commits_ = commits_between(checkout_, good, commit_of(checkout_, arguments_.bad));
    say("cell     {}\ncommits  {} to look among\n", arguments_.cell, commits_.size());
    judge_.emplace(build(good), spec, folder_, arguments_);
    const Shift whole = judge_->difference(build(commits_.back().hash), {});
    say("BAD      {}\n", text_of(whole, arguments_.measure));
    if (!differs(whole)) {
      say("NO CHANGE between GOOD and BAD that {} could show\n",
          arguments_.measure == "time" ? "these rounds" : "one run");
      return kInconclusive;
    }
    search(whole.estimate / 2);
    return conclude(whole);
  }

 private:
  std::string build(const std::string& commit) const {
    std::FILE* progress = arguments_.quiet ? nullptr : stderr;
    const auto program = build_reference(checkout_, commit, progress);
    if (!program) throw BisectStopped();
    return *program;
  }

  bool differs(const Shift& whole) const {
    const bool is_time = arguments_.measure == "time";
    const bool is_cycles = arguments_.measure == to_string(Measure::cycles);
    const double threshold = is_time     ? arguments_.threshold_percent / 100
                             : is_cycles ? kCycleThreshold
                                         : kInstructionThreshold;
    return std::abs(whole.estimate) > std::log1p(threshold) && !whole.interval.contains(0) &&
           std::isfinite(whole.interval.low);
  }

  void search(double boundary) {
    Bisection bisection(commits_.size());
    while (const std::optional<std::size_t> next = bisection.next()) {
      const Commit& commit = commits_[*next];
      const std::string name = commit.hash.substr(0, 12) + " " + printable(commit.subject);
      try {
        const Shift seen = judge_->difference(build(commit.hash), boundary);
        const bool is_open = seen.interval.contains(boundary) || !std::isfinite(seen.interval.low);
        const bool is_bad = boundary > 0 ? seen.estimate > boundary : seen.estimate < boundary;
        if (is_open) bisection.skip(*next);
        if (!is_open && is_bad) bisection.note_bad(*next);
        if (!is_open && !is_bad) bisection.note_good(*next);
        say("{}  {}: {}\n",
            is_open  ? "OPEN   "
            : is_bad ? "bad    "
                     : "good   ",
            name, text_of(seen, arguments_.measure));
      } catch (const InputError& error) {
        bisection.skip(*next);
        say("SKIPPED  {}: {}\n", name, printable(error.what()));
      }
      std::fflush(stdout);
    }
    first_ = bisection.first();
    last_ = bisection.last();
  }

  int conclude(const Shift& whole) const {
    for (std::size_t i = first_; i <= last_; ++i) {
      say("{} {} {}\n", first_ == last_ ? "FOUND   " : "PERHAPS ", commits_[i].hash,
          printable(commits_[i].subject));
    }
    if (first_ == last_) {
      say("         {} with BAD's level: {}\n", "the first commit",
          text_of(whole, arguments_.measure));
    }
    return first_ == last_ ? kPass : kInconclusive;
  }

  const BisectArguments& arguments_;
  std::string checkout_;
  std::string folder_;
  std::vector<Commit> commits_;
  std::optional<CellJudge> judge_;
  std::size_t first_ = 0;
  std::size_t last_ = 0;
};

int bisect(const BisectArguments& arguments) {
  const Interruptible interruptible(SecondSignal::is_ignored);  // to clean up in peace
  try {
    return CommitSearch(arguments).run();
  } catch (const BisectStopped&) {
    say(stderr, "ar3d: interrupted; the programs built so far are kept, nothing else is\n");
    return kInterrupted;
  }
}

}  // namespace

void add_bisect(CLI::App& app, int& exit_code) {
  CLI::App* verb =
      app.add_subcommand("bisect", "Which commit changed a cell? Builds and compares until found");
  const auto arguments = std::make_shared<BisectArguments>();
  verb->add_option("--good", arguments->good, "a git commit before the change")->required();
  verb->add_option("--bad", arguments->bad, "a git commit behind it");
  verb->add_option("--cell", arguments->cell,
                   "what changed, as `compare` and `history report` name it")
      ->required();
  verb->add_option("--study", arguments->study,
                   "that has the cell: a TOML file, a named study or a results file");
  verb->add_option("--measure", arguments->measure, "time, instructions, cycles, volume or bends")
      ->check(one_of({"time", "instructions", "cycles", "volume", "bends"}));
  verb->add_option("--rounds", arguments->rounds,
                   "turns of each program for one commit; up to four times as many if needed")
      ->check(whole_number(8, 1000));
  verb->add_option("--core", arguments->core, "core to run on; the last one if left out")
      ->check(whole_number(0, 1023));
  verb->add_option("--threshold", arguments->threshold_percent,
                   "percent of time that matter: less between GOOD and BAD is no change")
      ->check(number_between(0.1, 1000));
  verb->add_flag("-q,--quiet", arguments->quiet, "no progress on standard error");
  verb->footer(
      "Exit code 0: the commit was found; 6: GOOD and BAD do not differ, or several commits are "
      "left.\nExample: ar3d bisect --good HEAD~20 --bad HEAD --cell 'grid (effort=1) on cycle "
      "n=300'");
  verb->callback([arguments, &exit_code] { exit_code = bisect(*arguments); });
}

}  // namespace ar3d
