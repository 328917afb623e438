// `ar3d compare`: two results files, or two builds that run in turns.
#include "ar3d/analysis/compare/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ar3d/base/error.h"
#include "ar3d/base/new_file.h"
#include "ar3d/bench/compare/commits.h"
#include "ar3d/bench/compare/interleave.h"
#include "ar3d/bench/measure/processes.h"
#include "ar3d/bench/plan/plan.h"
#include "ar3d/bench/replay/count_instructions.h"
#include "ar3d/bench/spec/study_spec.h"
#include "commands.h"
#include "options.h"
#include "outputs.h"
#include "report_page.h"

namespace ar3d {
namespace {

namespace fs = std::filesystem;

struct CompareArguments {
  std::vector<std::string> files;
  bool reference = false;
  std::string base;
  std::string study = "regression";
  std::size_t rounds = 0;
  int core = -1;
  bool calibrate = false;
  double threshold_percent = 5;
  std::string json;
  std::string markdown;
  bool force = false;
  CompareOptions options;
};

constexpr const char* kThisProgram = "/proc/self/exe";

int report_verdict(const CompareArguments& arguments, const Comparison& comparison,
                   const Calibration* calibration) {
  const bool is_on_stdout = arguments.markdown == "-";
  if (!arguments.markdown.empty()) {
    const std::string text = comparison_markdown(comparison, arguments.options);
    if (is_on_stdout) say("{}", text);
    if (!is_on_stdout) write_file_atomically(arguments.markdown, text);
  }
  if (!is_on_stdout && !manner.json) say("{}", summary(comparison, arguments.options));
  if (!arguments.json.empty()) {
    write_json(arguments.json, comparison_json(comparison, arguments.options, calibration));
  }
  return comparison.exit_code();
}

int compare_files(const CompareArguments& arguments) {
  const std::size_t wanted = arguments.reference ? 1 : 2;
  if (arguments.files.size() != wanted) {
    throw InputError(arguments.reference
                         ? "compare --reference takes one results file (see ar3d compare --help)"
                         : "compare takes two results files, or --base GIT_REF (see ar3d compare "
                           "--help)");
  }
  const Results now = read_results(arguments.files.back());
  const std::string base_path =
      arguments.reference ? committed_reference(now.study_id) : arguments.files.front();
  if (arguments.reference && base_path.empty()) {
    throw InputError(
        fmt::format("no results of study '{}' in results/reference of the checkout", now.study_id));
  }
  const Results base = read_results(base_path);
  std::FILE* const to = arguments.markdown == "-" ? stderr : stdout;
  note(to, "base {} ({})\nnew  {} ({})\n", base_path, base.created, arguments.files.back(),
       now.created);
  return report_verdict(arguments, compare(base, now, arguments.options), nullptr);
}

/// Curves at one size.
std::size_t cells_of(const Study& study) {
  std::set<std::string> cells;
  for (const PlannedInstance& instance : plan_study(study).instances) {
    for (const PlannedRun& run : instance.runs) {
      cells.insert(fmt::format("{} {} {} {} {} {}", instance.choice.family->name,
                               instance.parameters, instance.n, run.choice.algorithm->name,
                               run.options, to_string(run.choice.level)));
    }
  }
  return cells.size();
}

/// As many as one cell among all needs, and one to spare; at least 15.
std::size_t rounds_of(const CompareArguments& arguments, const Study& study) {
  if (arguments.rounds > 0) return arguments.rounds;
  return std::max<std::size_t>(15, fewest_pairs(arguments.options.time, cells_of(study)) + 1);
}

int say_interrupted(const std::string& where) {
  say(stderr, "ar3d: interrupted {}; nothing was left behind\n", where);
  return kInterrupted;
}

/// @return nothing if it was interrupted, which has been said then.
std::optional<Comparison> take_turns(const std::string& base, const Study& study,
                                     const std::string& folder, const InterleaveOptions& options,
                                     const CompareOptions& rule) {
  const InterleavedRounds rounds = run_interleaved(base, kThisProgram, study, folder, options);
  if (!rounds.interrupted) return compare_rounds(rounds.base, rounds.now, rule);
  say_interrupted(fmt::format("in round {} of {}",
                              std::min(rounds.base.size(), rounds.now.size()) + 1, options.rounds));
  return {};
}

int compare_builds(const CompareArguments& arguments) {
  if (!arguments.files.empty()) throw InputError("--base and --calibrate take no results files");
  const Interruptible interruptible(SecondSignal::is_ignored);  // to clean up in peace
  std::FILE* progress = manner.quiet ? nullptr : stderr;
  const Study study = load_study(arguments.study);
  for (const std::string& output : {arguments.json, arguments.markdown}) {
    if (!output.empty() && output != "-") require_writable(output);
  }
  const std::string checkout = find_checkout();
  const std::string folder = (fs::path(checkout) / "build" / "compare").string();
  std::optional<std::string> base;
  if (!arguments.base.empty()) {
    base = build_reference(checkout, arguments.base, progress);
    if (!base) return say_interrupted("while building " + arguments.base);
  }
  InterleaveOptions options{rounds_of(arguments, study), arguments.core, progress};
  Calibration calibration;
  std::optional<Comparison> comparison;
  if (arguments.calibrate) {
    comparison = take_turns(kThisProgram, study, folder, options, arguments.options);
    if (!comparison) return kInterrupted;
    std::vector<std::vector<double>> ratios;
    for (const CellComparison& cell : comparison->cells) ratios.push_back(cell.log_ratios);
    calibration = calibrate(ratios, arguments.options.time);
    note(arguments.markdown == "-" ? stderr : stdout, "{}",
         summary(calibration, arguments.options.time));
  }
  if (base) {
    options.count = study.spec.count && counting_problem().empty();
    comparison = take_turns(*base, study, folder, options, arguments.options);
    if (!comparison) return kInterrupted;
  }
  return report_verdict(arguments, *comparison, arguments.calibrate ? &calibration : nullptr);
}

void add_options(CLI::App& verb, CompareArguments& a) {
  verb.add_option("FILE", a.files, "BASE and NEW: results files (HDF5)");
  verb.add_flag("--reference", a.reference,
                "compare NEW with the youngest results/reference/*.h5 of its study");
  verb.add_option("--base", a.base,
                  "build this git commit and run it and this program in turns instead");
  verb.add_option("--study", a.study,
                  "what --base and --calibrate run: a TOML file or named study");
  verb.add_option("--rounds", a.rounds,
                  "turns of each program; at least 15, and enough for the number of cells, if left "
                  "out")
      ->default_str("")
      ->check(whole_number(1, 1000));
  verb.add_option("--core", a.core, "core to run on; the last one if left out")
      ->check(whole_number(0, 1023));
  verb.add_flag("--calibrate", a.calibrate,
                "first run this program against itself: false-alarm rate, smallest visible effect");
  verb.add_option("--threshold", a.threshold_percent, "percent of time that matter")
      ->check(number_between(0.1, 1000));
  verb.add_option("--significance", a.options.time.significance, "largest p-value of one cell")
      ->check(number_between(1e-12, 0.5));
  verb.add_option("--fdr", a.options.time.false_discovery_rate,
                  "false discovery rate over all cells")
      ->check(number_between(1e-12, 0.5));
  verb.add_flag("--time-always", a.options.time_always, "judge times of unlike environments too");
  verb.add_flag("--drawings-only", a.options.drawings_only,
                "judge status, certificate, graph, volume, bends and instructions, and no times");
  verb.add_option(
      "--json", a.json,
      "also write the verdict as JSON to this file; -: to standard output instead of the text");
  verb.add_option("--markdown", a.markdown,
                  "also write the verdict as Markdown to this file; -: to standard output instead "
                  "of the text");
  add_force(verb, a.force);
}

}  // namespace

void add_compare(CLI::App& app, int& exit_code) {
  CLI::App* verb = app.add_subcommand(
      "compare", "Did a change make drawings worse or slower? Two results, or two builds in turns");
  const auto arguments = std::make_shared<CompareArguments>();
  add_options(*verb, *arguments);
  verb->footer(
      "Exit code 0 pass or improved (everything was judged), 3 regression, 4 violated, 5 "
      "incomplete "
      "or nothing measured, 6 inconclusive, 7 times not judged (unlike environments).\nExample: "
      "ar3d compare before.h5 after.h5\n         ar3d compare --base main "
      "--calibrate");
  verb->callback([arguments, &exit_code] {
    manner.json = arguments->json == "-";
    if (manner.json && arguments->markdown == "-") {
      throw InputError("--json - and --markdown - : standard output takes one of them");
    }
    refuse_unsafe_outputs({.inputs = arguments->files,
                           .outputs = {arguments->json, arguments->markdown},
                           .force = arguments->force});
    arguments->options.time.threshold = arguments->threshold_percent / 100;
    const bool builds = !arguments->base.empty() || arguments->calibrate;
    exit_code = builds ? compare_builds(*arguments) : compare_files(*arguments);
  });
}

}  // namespace ar3d
