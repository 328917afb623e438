// `ar3d study run`, `resume` and `merge`.
#include "study.h"

#include <fmt/ranges.h>

#include "ar3d/analysis/report/report.h"
#include "ar3d/bench/corpus/corpus.h"
#include "ar3d/bench/keep/journaled_study.h"
#include "ar3d/bench/keep/study_files.h"
#include "ar3d/bench/measure/processes.h"
#include "ar3d/bench/replay/replay_row.h"
#include "commands.h"
#include "outputs.h"
#include "study_rows.h"

namespace ar3d {
namespace {

struct RunArguments {
  StudyChoice chosen;              // of `run`
  std::string study;               // of `resume`: its results file or journal
  std::vector<std::string> parts;  // of `merge`: results files or journals
  std::string output;
  std::string shard;
  std::vector<std::string> again;
  int workers = 0;  // 0: workers_for() decides
  bool force = false;
  SessionPolicy policy;  // what the command line says of it
};

// "a, b, c, …", of names that may be anything.
std::string first_few(const std::vector<std::string>& names) {
  constexpr std::size_t kShown = 10;
  std::vector<std::string> shown;
  for (const std::string& name : names) shown.push_back(printable(name));
  if (shown.size() > kShown) shown.resize(kShown), shown.push_back("…");
  return fmt::format("{}", fmt::join(shown, ", "));
}

// Writes no report if another file has its name. That one was there before or has come meanwhile;
// the study goes on.
void write_report(const std::string& results, const StudyAnalysis& analysis) {
  const std::string page = report_path(results);
  try {
    refuse_foreign_page(page, results);
  } catch (const InputError&) {
    log(stdout,
        "report   not made: {} is no report of ar3d; `ar3d report {} -o OTHER.html` makes it\n",
        page, shell_word(results));
    return;
  }
  write_file_atomically(
      page, render_report(analysis, since_reference(analysis.rows, {}), shown_drawings(analysis)));
  log(stdout, "report   {}\n", page);
}

// Counts what no session before has counted. Where it cannot be, times alone are compared.
// @return false if it was interrupted.
bool count_drawings_of(const std::string& path) {
  if (is_interrupted()) return false;
  const Interruptible interruptible(/*ignores_second=*/true);  // to clean up in peace
  Results results = read_results(path);
  const auto is_counted = [](const RunRecord& run) { return run.counted_instructions >= 0; };
  if (std::any_of(results.runs.begin(), results.runs.end(), is_counted)) return true;
  try {
    const std::size_t drawings = fill_counts(results, kLargestCounted);
    if (is_interrupted()) {
      print(stderr, "ar3d: interrupted while counting; go on with `ar3d study resume {}`\n",
            shell_word(path));
      return false;
    }
    if (drawings == 0) return true;
    write_results(results, path);
    log(stdout, "counted  {} drawings\n", drawings);
  } catch (const InputError& error) {
    print(stderr, "ar3d: drawings are not counted: {}\n", printable(error.what()));
  }
  return true;
}

// The last lines of a study that is whole: the verdict and where everything is.
// @param made  the rows, in the order of the results file.
// @param unchanged  no row was made: the study had been whole before.
int conclude(const JournaledStudy& study, Rows made, bool force, bool unchanged) {
  if (study.spec.count && !count_drawings_of(study.results)) return kInterrupted;
  const Rows rows = study.spec.count ? Rows(study.results) : std::move(made);
  CheckVerdict verdict = judge(rows, study.results);
  int exit_code = verdict.exit_code();
  nlohmann::ordered_json json = verdict_json(verdict, rows.identity());
  json["results"] = study.results;
  print_result(json, "{}", summary(verdict));
  log(stdout, "results  {}\n", study.results);
  const bool is_timed = std::ranges::any_of(
      study.spec.sweeps, [](const Sweep& sweep) { return sweep.most_timed > 0; });
  if (!is_timed) log(stdout, "times    not measured: --timed N does\n");
  if (!is_json_output) print("{}", left_out_text(rows.identity()));
  if (study.shard.count > 1) {
    log(stdout, "shard {} of {}: when all are there, `ar3d study merge SHARDS… -o RESULTS.h5`\n",
        study.shard.index, study.shard.count);
  } else {
    write_report(study.results, analyse(rows, std::move(verdict)));
    if (study.spec.keep_drawings != KeptDrawings::none) {
      const int kept =
          keep_drawings_beside(study.results, rows, study.spec.keep_drawings, force, unchanged);
      if (exit_code == kPass) exit_code = kept;
    }
  }
  return exit_code;
}

// What the results of a study of files do not hold, and whether `resume` can change that.
void print_limits_of_files(const JournaledStudy& study, const StudyIdentity& identity) {
  const StoredGraphs held = stored_graphs(identity);
  bool is_held = true;
  std::set<std::string> seen;
  for (const StudyCorpus& corpus : corpora_of(study)) {
    if (held.contains(corpus.record.name) || !seen.insert(corpus.record.name).second) continue;
    is_held = false;
    print(stderr,
          "ar3d: the graphs of {} are more than graphs_bytes = {:.6g}, so the results do not "
          "hold them: its files have to stay as they are, and `resume` adds none\n",
          corpus.record.name, study.spec.graphs_bytes);
  }
  const std::vector<std::string> come = files_come_since(study);
  if (come.empty()) return;
  print(
      stderr, "ar3d: {} came after the files were listed at {}, and {} not in the results: {}{}\n",
      come.size() == 1 ? "1 file" : fmt::format("{} files", come.size()),
      time_with_zone(*study.open_files->listed), come.size() == 1 ? "is" : "are", first_few(come),
      is_held ? fmt::format("; `ar3d study resume {}` draws them", shell_word(study.results)) : "");
}

int run_to_the_end(JournaledStudy study, const RunArguments& arguments, const SessionPolicy& policy,
                   Ranks& ranks) {
  // A second signal ends the program at once: what is acknowledged is in the journal.
  const Interruptible interruptible;
  if (ranks.size() > 1 && ranks.is_first()) {
    log(stderr, "ar3d: {} ranks; `ar3d study status --watch {}` tells how far they are\n",
        ranks.size(), shell_word(study.results));
  }
  const bool was_whole = ranks.is_first() && study.seed_from_results && study.again.empty() &&
                         study.spec.keep_drawings != KeptDrawings::none &&
                         outcome_so_far(study).complete();
  StudyOutcome outcome = run_journaled(study, policy, ranks);
  if (!ranks.is_first()) return kPass;
  study.results = outcome.results;
  if (!is_quiet_output) print_limits_of_files(study, outcome.in_hand->identity());
  if (outcome.complete()) {
    return conclude(study, std::move(*outcome.in_hand), arguments.force, was_whole);
  }
  print(stderr, "ar3d: {}; {} rows are in {}, {} are missing; go on with `ar3d study resume {}`\n",
        is_interrupted() ? "interrupted" : "not finished", outcome.rows, study.results,
        outcome.missing, shell_word(study.results));
  if (is_interrupted() && !is_json_output) return kInterrupted;
  const CheckVerdict verdict = judge(*outcome.in_hand, study.results);
  if (is_json_output) print_json(verdict_json(verdict, outcome.in_hand->identity()));
  return is_interrupted() ? kInterrupted : verdict.exit_code();
}

// Why a study has ended early. @param rank  that speaks for itself; nothing: it speaks for all.
void print_failure(std::optional<int> rank, const std::string& what,
                   const std::optional<std::string>& to_be_resumed) {
  print(stderr, "ar3d: {}{}\n", rank ? fmt::format("rank {}: ", *rank) : "", printable(what));
  if (!to_be_resumed) return;
  print(stderr, "ar3d: the rows before are safe; go on with `ar3d study resume {}`\n",
        shell_word(*to_be_resumed));
}

// What was assumed of files that leave a choice.
void log_reading(const Study& study) {
  std::set<const Corpus*> seen;
  for (const StudyCorpus& corpus : corpora_of(study)) {
    const Corpus& graphs = *corpus.corpus;
    if (seen.insert(&graphs).second) log_notes(graphs.notes());
  }
}

// Begins and makes a study on all ranks; the first one speaks for all, but where one fails on its
// own, which ends them all.
int make_study(const RunArguments& arguments, const std::function<JournaledStudy()>& begin) {
  const std::unique_ptr<Ranks> ranks = join_ranks();
  SessionPolicy policy = arguments.policy;
  policy.workers = workers_for(arguments.workers, ranks->size());
  policy.ranks = ranks.get();
  if (!is_quiet_output && ranks->size() == 1) policy.progress = stderr;
  std::string remarks;
  const auto begin_possible = [&] {
    JournaledStudy begun = begin();
    remarks = refuse_impossible_study(begun, policy);
    return begun;
  };
  std::optional<std::string> results;
  const auto ends_all = [&](const std::exception& error, int exit_code) {
    // Said before the ranks part: mpirun ends all of them as soon as one has left with an error.
    const bool all_know = ranks->size() == 1 || ranks->have_failed;
    if (!all_know || ranks->is_first()) {
      print_failure(all_know ? std::nullopt : std::optional(ranks->rank()), error.what(),
                    exit_code == kIncomplete ? results : std::nullopt);
    }
    if (!all_know) ranks->abort_all(exit_code);
    return exit_code;
  };
  try {
    const JournaledStudy study = begin_together(*ranks, begin_possible);
    results = study.results;
    if (ranks->is_first()) {
      log_reading(study);
      log(stderr, "{}", remarks);
    }
    return run_to_the_end(study, arguments, policy, *ranks);
  } catch (const JournalFull& error) {
    return ends_all(error, kIncomplete);
  } catch (const InputError& error) {
    return ends_all(error, kUsage);
  } catch (const std::exception& error) {
    if (ranks->size() > 1) ends_all(error, kInternalError);
    throw;
  }
}

void add_common(CLI::App& verb, RunArguments& arguments) {
  verb.add_option(
          "--threads", arguments.workers,
          "rows made at the same time; as many as cores if left out, one on each of several "
          "ranks")
      ->default_str("")
      ->check(whole_number(1, 1024));
  add_json(verb);
  verb.add_flag("--isolate", arguments.policy.isolate,
                "make rows in processes of their own: a crash is one row's status");
  verb.add_flag("--force-timing", arguments.policy.force_timing,
                "time even in a debug or sanitised build (its rows are marked)");
}

Shard shard_of(const std::string& text) {
  if (const std::optional<Shard> shard = parse_shard(text)) return *shard;
  throw InputError(fmt::format("'{}' is no shard: i/N with 1 <= i <= N <= 1000000", text));
}

JournaledStudy begin_new(const RunArguments& arguments, const Shard& shard) {
  JournaledStudy study = new_study(chosen_study(arguments.chosen), shard, arguments.output);
  const std::string page = report_path(study.results);
  std::vector<std::string> inputs = {arguments.chosen.study};
  for (std::string& file : graph_files_of(study)) inputs.push_back(std::move(file));
  refuse_foreign_page(page, study.results);
  std::vector<std::string> outputs = {study.results};
  if (study.spec.keep_drawings != KeptDrawings::none && shard.count == 1) {
    outputs.push_back(drawings_path(study.results));
  }
  refuse_unsafe_outputs({.inputs = inputs,
                         .outputs = outputs,
                         .page = page,
                         .force = arguments.force,
                         .streams = false});
  refuse_foreign_ending(arguments.output, {".h5", ".hdf5"});
  for (const std::string& output : outputs) require_writable(output);
  return study;
}

void add_run(CLI::App& study, int& exit_code) {
  CLI::App* verb = study.add_subcommand("run", "Runs a study and writes its results and report");
  const auto arguments = std::make_shared<RunArguments>();
  add_study_choice(*verb, arguments->chosen);
  verb->add_option("-o,--output", arguments->output, "results file; ar3d-NAME.h5 if left out");
  verb->add_option("--shard", arguments->shard,
                   "i/N: only the i-th of N parts of the study, to be merged later");
  add_force(*verb, arguments->force);
  add_common(*verb, *arguments);
  verb->footer(
      "Rows go to a journal beside the results file as they are made; whatever ends the study, "
      "`ar3d study resume` goes on.\nExample: ar3d study run smoke --threads 2 -o "
      "smoke.h5\nExample: ar3d study run "
      "--graphs 'nets/*.s6' --algorithm diamond");
  verb->callback([arguments, &exit_code] {
    const Shard shard = arguments->shard.empty() ? Shard() : shard_of(arguments->shard);
    exit_code = make_study(*arguments, [&] { return begin_new(*arguments, shard); });
  });
}

// Which files of the study's are not as they were; what results hold of them stays.
void print_growth(const Study& study) {
  const auto print_files = [](const std::string& name, const std::vector<std::string>& files,
                              const char* what) {
    if (files.empty()) return;
    print(stderr, "ar3d: {}: {} file{} {}: {}\n", name, files.size(), files.size() == 1 ? "" : "s",
          what, first_few(files));
  };
  std::set<std::string> seen;
  for (const StudyCorpus& corpus : corpora_of(study)) {
    if (!seen.insert(corpus.record.name).second) continue;
    const auto& [added, changed, gone] = corpus.corpus->growth();
    print_files(corpus.record.name, added, "new, to be drawn");
    print_files(corpus.record.name, changed, "changed, to be drawn beside the rows that are there");
    print_files(corpus.record.name, gone, "gone, whose rows and graphs stay in the results");
    std::vector<std::string> reasons;
    if (!corpus.entry->skip) {
      for (const SkippedFile& file : corpus.corpus->skipped()) reasons.push_back(file.reason);
    }
    print_files(corpus.record.name, reasons, "without a graph, left out");
  }
}

// Whose rows are worth making again.
constexpr RunStatus kToMakeAgain[] = {RunStatus::timeout, RunStatus::out_of_memory,
                                      RunStatus::crashed, RunStatus::refused, RunStatus::violated};

void add_resume(CLI::App& study, int& exit_code) {
  CLI::App* verb = study.add_subcommand("resume", "Goes on with a study that was ended early");
  const auto arguments = std::make_shared<RunArguments>();
  verb->add_option("FILE", arguments->study, "its results file or its journal")->required();
  std::vector<std::string> names;
  for (const RunStatus status : kToMakeAgain) names.emplace_back(to_string(status));
  verb->add_option("--again", arguments->again,
                   "make rows with this status again; may be given several times")
      ->check(one_of(names));
  add_common(*verb, *arguments);
  verb->footer("Rows that are there stay as they are.\nExample: ar3d study resume ar3d-quick.h5");
  verb->callback([arguments, &exit_code] {
    std::vector<RunStatus> again;
    std::ranges::copy_if(kToMakeAgain, std::back_inserter(again), [&](RunStatus status) {
      return std::ranges::count(arguments->again, to_string(status)) > 0;
    });
    exit_code = make_study(*arguments, [&] {
      JournaledStudy study = begun_study(arguments->study);
      study.again = again;
      study.rescan = true;
      print_growth(study);
      return study;
    });
  });
}

int merge(const RunArguments& arguments) {
  refuse_unsafe_outputs({.inputs = arguments.parts,
                         .outputs = {arguments.output},
                         .force = arguments.force,
                         .streams = false});
  refuse_foreign_ending(arguments.output, {".h5", ".hdf5"});
  const StudyOutcome outcome = merge_study(arguments.parts, arguments.output);
  if (is_json_output) {
    print_json({{"rows", outcome.rows},
                {"files", arguments.parts.size()},
                {"missing", outcome.missing},
                {"missing_shards", outcome.missing_shards},
                {"results", outcome.complete() ? arguments.output : ""}});
  }
  if (outcome.complete()) {
    log(stdout, "{} rows of {} files are in {}\n", outcome.rows, arguments.parts.size(),
        arguments.output);
    return kPass;
  }
  print(stderr, "ar3d: {} rows are missing, row {} for one{}; nothing was written\n",
        outcome.missing, outcome.first_missing,
        outcome.missing_shards.empty()
            ? ""
            : fmt::format(" (no file of shard {})", outcome.missing_shards));
  return kIncomplete;
}

void add_merge(CLI::App& study, int& exit_code) {
  CLI::App* verb = study.add_subcommand("merge", "Makes one results file of a study's shards");
  const auto arguments = std::make_shared<RunArguments>();
  verb->add_option("PART", arguments->parts, "results files or journals, in any order")->required();
  verb->add_option("-o,--output", arguments->output, "results file")->required();
  add_json(*verb);
  add_force(*verb, arguments->force);
  verb->footer(
      "Exit code 2 if the parts do not belong together, 5 if rows are missing; then nothing is "
      "written.\nExample: ar3d study merge ar3d-quick.shard-*.h5 -o quick.h5");
  verb->callback([arguments, &exit_code] { exit_code = merge(*arguments); });
}

}  // namespace

void add_study(CLI::App& app, int& exit_code) {
  CLI::App* verb = app.add_subcommand(
      "study", "Runs certified, timed sweeps over families, sizes and algorithms");
  verb->require_subcommand(1);
  add_run(*verb, exit_code);
  add_resume(*verb, exit_code);
  add_study_status(*verb, exit_code);
  add_merge(*verb, exit_code);
  add_study_plan(*verb, exit_code);
  add_study_count(*verb, exit_code);
}

}  // namespace ar3d
