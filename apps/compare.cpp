// `ar3d compare`: two results files, two settings of one, or two versions of something that take
// turns.
#include "ar3d/analysis/compare/compare.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/scope_exit.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ar3d/base/error.h"
#include "ar3d/base/new_file.h"
#include "ar3d/base/printable.h"
#include "ar3d/bench/compare/interleave.h"
#include "ar3d/bench/keep/journaled_study.h"
#include "ar3d/bench/measure/cores.h"
#include "ar3d/bench/measure/processes.h"
#include "ar3d/bench/plan/plan.h"
#include "ar3d/bench/replay/replay_row.h"
#include "ar3d/bench/spec/study_spec.h"
#include "ar3d/generators/catalog.h"
#include "commands.h"
#include "options.h"
#include "outputs.h"
#include "study_rows.h"

namespace ar3d {
namespace {

namespace fs = std::filesystem;

struct CompareArguments {
  std::vector<std::string> files;
  bool reference = false;
  std::vector<std::string> settings;
  std::vector<std::string> turns;
  std::string build;
  std::string output;
  bool count = false;
  std::string base;
  std::string study = "regression";
  std::size_t rounds = 0;
  int core = -1;
  double threshold_percent = 5;
  std::string json;
  std::string markdown;
  bool force = false;
  CompareOptions options;
};

constexpr const char* kThisProgram = "/proc/self/exe";

int report_verdict(const CompareArguments& arguments, const Comparison& comparison) {
  const bool is_on_stdout = arguments.markdown == "-";
  if (!arguments.markdown.empty()) {
    const std::string text = comparison_markdown(comparison, arguments.options);
    if (is_on_stdout) print("{}", text);
    if (!is_on_stdout) write_file_atomically(arguments.markdown, text);
  }
  if (!is_on_stdout && !is_json_output) print("{}", summary(comparison, arguments.options));
  if (!arguments.json.empty()) {
    write_json(arguments.json, comparison_json(comparison, arguments.options));
  }
  return comparison.exit_code();
}

/// A named study, a TOML file, or the study of a results file.
Study study_to_run(const std::string& name) {
  const bool is_results = name.ends_with(".h5") || name.ends_with(".hdf5");
  return is_results ? recorded_study(Rows(name).identity(), name) : load_study(name);
}

bool knows_commit(const std::string& commit) {
  return commit.size() >= 40 &&
         !ask_git({"rev-parse", "--verify", "--quiet", commit.substr(0, 40) + "^{commit}"}).empty();
}

/// The command of a study's one program as --turns takes it; empty: it has none, or needs quotes.
std::string command_in_turns(const StudySpec& spec) {
  constexpr auto is_plain = [](char c) { return c > ' ' && c <= '~' && c != '"' && c != '\\'; };
  if (spec.programs.size() != 1) return "";
  for (const std::string& word : spec.programs.front()->command) {
    const bool is_bare = std::ranges::all_of(word, is_plain) && std::ranges::count(word, '\'') == 0;
    if (word.empty() || !is_bare) return "";
  }
  return fmt::format("{}", fmt::join(spec.programs.front()->command, " "));
}

/// A sentence with a command that takes turns and can be given where this one was; empty: there is
/// none.
std::string remedy(const Results& base, const std::string& base_path, const Results& now,
                   const std::string& now_path) {
  const auto command = [&](const std::string& sides) {
    return fmt::format("`ar3d compare {} --study {}`", sides, shell_word(now_path));
  };
  const auto commit = [](const std::string& hash) { return hash.substr(0, 12); };
  StudySpec spec, before;
  try {
    spec = recorded_study(now, now_path).spec;
    before = recorded_study(base, base_path).spec;
  } catch (const InputError&) {
    return "";  // another version's: this one cannot run it
  }
  if (spec.programs.empty()) {
    if (!knows_commit(base.source_hash) || checkout_here().empty()) return "";
    return "To know more: " + command("--base " + commit(base.source_hash)) + " takes turns";
  }
  const std::string a = command_in_turns(before), b = command_in_turns(spec);
  if (!a.empty() && !b.empty() && a != b) {
    return "To know more: " + command(fmt::format("--turns '{}' '{}'", a, b)) + " takes turns";
  }
  for (const EnvironmentEntry& entry : base.environment) {
    const bool is_commit = entry.name.starts_with("version_") && entry.value.size() == 40;
    if (!is_commit || !knows_commit(entry.value)) continue;  // or it was changed since its commit
    return fmt::format("To know more: {} takes turns (`true`: there is nothing to build)",
                       command(fmt::format("--turns {} . --build true", commit(entry.value))));
  }
  return spec.programs.size() == 1
             ? "To know more, keep the program of BASE under another name, and say the commands of "
               "both for A and B: " +
                   command("--turns A B")
             : "To know more, write two specifications with the commands of BASE and of NEW: "
               "`ar3d compare --turns BASE.toml NEW.toml`";
}

int compare_settings_of(const CompareArguments& arguments) {
  if (arguments.files.size() != 1) throw InputError("compare --settings takes one results file");
  const Results results = read_results(arguments.files.front());
  std::vector<CurveKey> settings;
  for (const RunRecord& run : results.runs) {
    const CurveKey key{run.algorithm, run.options, {}, {}};
    if (std::ranges::count(settings, key) == 0) settings.push_back(key);
  }
  const CurveKey base = find_setting(settings, arguments.settings[0]);
  const CurveKey now = find_setting(settings, arguments.settings[1]);
  const std::string name = algorithm_label(base) + " -> " + algorithm_label(now);
  return report_verdict(arguments,
                        compare_settings(results, {{name, base, now}}, arguments.options));
}

int compare_files(const CompareArguments& arguments) {
  if (!arguments.settings.empty()) return compare_settings_of(arguments);
  const std::size_t wanted = arguments.reference ? 1 : 2;
  if (arguments.files.size() != wanted) {
    throw InputError(arguments.reference
                         ? "compare --reference takes one results file (see ar3d compare --help)"
                         : "compare takes two results files, or --turns A B, or --base GIT_REF "
                           "(see ar3d compare --help)");
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
  log(to, "base {} ({})\nnew  {} ({})\n", base_path, base.created, arguments.files.back(),
      now.created);
  Comparison comparison = compare(base, now, arguments.options);
  if (comparison.count(Verdict::inconclusive) > 0) {
    comparison.remedy = remedy(base, base_path, now, arguments.files.back());
  }
  return report_verdict(arguments, comparison);
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
  return std::max<std::size_t>(15, fewest_pairs(arguments.options, cells_of(study)) + 1);
}

int say_interrupted(const std::string& where) {
  print(stderr, "ar3d: interrupted {}; nothing was left behind\n", where);
  return kInterrupted;
}

int compare_builds(const CompareArguments& arguments) {
  if (!arguments.files.empty()) throw InputError("--base takes no results files");
  const Interruptible interruptible(/*ignores_second=*/true);  // to clean up in peace
  std::FILE* progress = is_quiet_output ? nullptr : stderr;
  const Study study = study_to_run(arguments.study);
  for (const std::string& output : {arguments.json, arguments.markdown}) {
    if (!output.empty() && output != "-") require_writable(output);
  }
  const std::string checkout = find_checkout();
  const std::string folder = (fs::path(checkout) / "build" / "compare").string();
  const std::optional<std::string> base = build_reference(checkout, arguments.base, progress);
  if (!base) return say_interrupted("while building " + arguments.base);
  const InterleaveOptions options{rounds_of(arguments, study), arguments.core, progress,
                                  study.spec.count && counting_problem().empty()};
  const auto [before, now] = run_interleaved(*base, kThisProgram, study, folder, options);
  if (const std::size_t done = std::min(before.size(), now.size()); done < options.rounds) {
    return say_interrupted(fmt::format("in round {} of {}", done + 1, options.rounds));
  }
  return report_verdict(arguments, compare_rounds(before, now, arguments.options));
}

/// What takes turns; empty: it was interrupted. @param compared  takes the setting of each, if these
/// are settings.
std::vector<Study> turns_sides(const CompareArguments& arguments, const std::string& scratch,
                               std::vector<CurveKey>& compared) {
  std::vector<Study> sides;
  if (std::ranges::all_of(arguments.turns,
                          [](const auto& side) { return side.ends_with(".toml"); })) {
    for (const std::string& side : arguments.turns) sides.push_back(load_study(side));
    return sides;
  }
  const Study study = study_to_run(arguments.study);
  if (!arguments.build.empty()) {
    for (const std::string& ref : arguments.turns) {
      std::optional<std::string> folder = fs::current_path().string();  // as it is
      if (ref != ".") {
        log(stderr, "building {}\n", ref);
        folder = build_own(ref, arguments.build, fmt::format("{}/{}", scratch, sides.size()));
      }
      if (!folder) return {};
      sides.push_back(with_folder(study, *folder));
    }
    return sides;
  }
  const std::vector<CurveKey> settings = settings_of(study.spec);
  const auto is_setting = [&](const std::string& side) {
    return std::ranges::any_of(settings, [&](const CurveKey& key) {
      return side == key.algorithm || side.starts_with(key.algorithm + " ");
    });
  };
  const bool has_settings = std::ranges::any_of(arguments.turns, is_setting);
  for (const std::string& side : arguments.turns) {
    if (is_setting(side) && fs::exists(side)) {
      throw InputError(fmt::format("'{0}' is a setting and a file; './{0}' is the program", side));
    }
    if (has_settings) compared.push_back(find_setting(settings, side));
    sides.push_back(has_settings ? study : with_command(study, side));
  }
  if (has_settings && compared[0] == compared[1]) {
    throw InputError(
        fmt::format("'{}' and '{}' are one setting", arguments.turns[0], arguments.turns[1]));
  }
  return sides;
}

int compare_in_turns(const CompareArguments& arguments) {
  if (!arguments.files.empty()) throw InputError("--turns takes no results files");
  const Interruptible interruptible(/*ignores_second=*/true);  // to clean up in peace
  const std::string scratch = new_temporary_folder("ar3d-turns");
  BOOST_SCOPE_EXIT_ALL(&) { remove_folder(scratch); };
  std::vector<CurveKey> settings;
  const std::vector<Study> sides = turns_sides(arguments, scratch, settings);
  if (sides.empty()) return say_interrupted("while building");
  const auto [turns, pairs, remarks] =
      turns_of(sides, settings, arguments.rounds, rounds_of(arguments, sides[0]));
  const std::string output =
      arguments.output.empty() ? default_results_path(turns.spec) : arguments.output;
  refuse_unsafe_outputs(
      {.inputs = {}, .outputs = {output}, .force = arguments.force, .streams = false});
  refuse_foreign_ending(output, {".h5", ".hdf5"});
  require_writable(output);
  const JournaledStudy study = new_study(turns, {}, scratch + "/turns.h5");
  const Pinning pinning(arguments.core);
  const SessionPolicy policy{.workers = workers_for(0),
                             .force_timing = true,  // its rows are marked
                             .progress = is_quiet_output ? nullptr : stderr};
  run_journaled(study, policy, *join_ranks());
  if (is_interrupted()) return say_interrupted("while drawing");
  Results results = read_results(study.results);
  if (arguments.count) fill_counts(results, kLargestCounted);
  if (is_interrupted()) return say_interrupted("while counting");
  write_results(results, output);
  log(arguments.markdown == "-" ? stderr : stdout, "results  {}\n", output);
  Comparison comparison = compare_settings(results, pairs, arguments.options);
  for (const std::string& remark : remarks) comparison.remarks.push_back(remark);
  return report_verdict(arguments, comparison);
}

void add_options(CLI::App& verb, CompareArguments& a) {
  verb.add_option("FILE", a.files, "BASE and NEW: results files (HDF5)");
  verb.add_flag("--reference", a.reference,
                "compare NEW with the youngest results/reference/*.h5 of its study");
  verb.add_option("--settings", a.settings, "compare these two settings of one FILE")->expected(2);
  verb.add_option("--turns", a.turns,
                  "run A and B in turns: settings of --study, two specifications, two commands of "
                  "its program, or two commits (--build)")
      ->expected(2);
  verb.add_option("--build", a.build,
                  "A and B are commits of the repository here: the command that builds one; '.' is "
                  "the working tree as it is");
  verb.add_flag("--count", a.count, "count instructions of both sides, too (valgrind)");
  verb.add_option("-o,--output", a.output,
                  "results file of --turns; ar3d-NAME-turns.h5 if left out");
  verb.add_option("--base", a.base,
                  "build this git commit and run it and this program in turns instead");
  verb.add_option("--study", a.study,
                  "what runs: a TOML file, a named study, or that of a results file");
  verb.add_option("--rounds", a.rounds,
                  "turns of each program; at least 15, and enough for the number of cells, if left "
                  "out")
      ->default_str("")
      ->check(whole_number(1, 1000));
  verb.add_option("--core", a.core, "core to run on; the last one if left out")
      ->check(whole_number(0, 1023));
  verb.add_option("--threshold", a.threshold_percent, "percent of time that matter")
      ->check(number_between(0.1, 1000));
  verb.add_option("--significance", a.options.significance, "largest p-value of one cell")
      ->check(number_between(1e-12, 0.5));
  verb.add_option("--fdr", a.options.false_discovery_rate, "false discovery rate over all cells")
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
      "compare",
      "Did a change make drawings worse or slower? Two results, or two versions in turns");
  const auto arguments = std::make_shared<CompareArguments>();
  add_options(*verb, *arguments);
  verb->footer(
      "Exit code 0 pass or improved (everything was judged), 3 regression, 4 violated, 5 "
      "incomplete "
      "or nothing measured, 6 inconclusive, 7 times not judged (unlike environments).\nExample: "
      "ar3d compare before.h5 after.h5\n         ar3d compare --base main\n"
      "         ar3d compare --turns v1.0 HEAD --build make --study own.toml");
  verb->callback([arguments, &exit_code] {
    is_json_output = arguments->json == "-";
    if (is_json_output && arguments->markdown == "-") {
      throw InputError("--json - and --markdown - : standard output takes one of them");
    }
    refuse_unsafe_outputs({.inputs = arguments->files,
                           .outputs = {arguments->json, arguments->markdown},
                           .force = arguments->force});
    arguments->options.threshold = arguments->threshold_percent / 100;
    exit_code = !arguments->turns.empty()  ? compare_in_turns(*arguments)
                : !arguments->base.empty() ? compare_builds(*arguments)
                                           : compare_files(*arguments);
  });
}

}  // namespace ar3d
