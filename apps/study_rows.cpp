// The rows of a study, wherever they are; `ar3d study status` and `ar3d check`, which judge them.
#include "study_rows.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <thread>

#include "ar3d/bench/keep/journaled_study.h"
#include "ar3d/bench/keep/study_files.h"
#include "ar3d/store/journal/journal_reader.h"
#include "commands.h"
#include "outputs.h"
#include "study.h"

namespace ar3d {
namespace {

// Rows that the study is complete with. Of one that times drawings until a precision is reached
// how many it will have is not known before: those that are there are looked at.
std::int64_t planned_rows(const std::string& file, const StudyIdentity& identity) {
  const JournaledStudy study = begun_study(file);
  const bool is_open =
      std::any_of(study.spec.sweeps.begin(), study.spec.sweeps.end(),
                  [](const Sweep& sweep) { return sweep.least_timed < sweep.most_timed; });
  if (!is_open) return identity.planned_rows;
  const StudyOutcome outcome = outcome_so_far(study);
  return static_cast<std::int64_t>(outcome.rows + outcome.missing);
}

struct StatusArguments {
  std::string file;
  std::string snapshot;
  bool force = false;
  bool watch = false;
};

// From its journals or its results file.
JournalStatus standing_now(const std::string& file) {
  const std::string results = results_path_of(file);
  JournalStatus standing;
  if (rows_are_in_results(results)) {
    const Rows rows(results);
    standing.identity = rows.identity();
    standing.rows = rows.size();
    return standing;
  }
  for (const std::string& path : existing_journals(results)) {
    const JournalStatus status = journal_status(path);
    if (standing.journals++ == 0) standing.identity = status.identity;
    standing.rows += status.rows;
    standing.not_ok += status.not_ok;
    standing.writers += status.writers;
  }
  return standing;
}

// Once more if a file went while it was read: a study that ends takes its journals away.
JournalStatus standing_of(const std::string& file) {
  try {
    return standing_now(file);
  } catch (const InputError&) {
    return standing_now(file);
  }
}

std::string line(const JournalStatus& standing) {
  std::string text = fmt::format("study {}", printable(standing.identity.study_id));
  const Shard& shard = standing.identity.shard;
  if (shard.count > 1) text += fmt::format(" shard {}/{}", shard.index, shard.count);
  text += fmt::format(": {} of {} rows", standing.rows, standing.identity.planned_rows);
  if (standing.not_ok > 0) text += fmt::format(" ({} not ok)", standing.not_ok);
  if (standing.writers > 0) {
    text +=
        fmt::format(", {} process{} at work", standing.writers, standing.writers == 1 ? "" : "es");
  } else {
    text += standing.complete() ? ", complete" : ", stopped";
  }
  return text;
}

nlohmann::ordered_json standing_json(const JournalStatus& standing) {
  const StudyIdentity& identity = standing.identity;
  return {{"study", identity.study_id},     {"shard", {identity.shard.index, identity.shard.count}},
          {"begun", identity.created},      {"source", identity.source_hash},
          {"rows", standing.rows},          {"planned_rows", identity.planned_rows},
          {"not_ok", standing.not_ok},      {"processes_at_work", standing.writers},
          {"complete", standing.complete()}};
}

void print_details(const JournalStatus& standing, const std::string& file) {
  print("{}\nbegun    {}\nsource   {}{}\n", line(standing), printable(standing.identity.created),
        printable(standing.identity.source_hash), standing.identity.dirty ? " and changes" : "");
  const std::string results = shell_word(results_path_of(file));
  if (standing.writers > 0) {
    log(stdout, "watch it with `ar3d study status --watch {}`\n", results);
  } else if (!standing.complete() || standing.journals > 0) {
    log(stdout, "go on with `ar3d study resume {}`\n", results);
  }
}

// One line per second until the writing has ended.
JournalStatus watch(const std::string& file) {
  const bool terminal = isatty(STDOUT_FILENO) == 1;
  const auto start = std::chrono::steady_clock::now();
  const JournalStatus first = standing_of(file);
  JournalStatus now = first;
  while (now.writers > 0) {
    std::string text = line(now);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    const double made = static_cast<double>(now.rows - first.rows);
    const double left =
        static_cast<double>(now.identity.planned_rows) - static_cast<double>(now.rows);
    if (made > 0 && left > 0) {
      text += fmt::format(", {:.0f} rows per second, about {:.0f} s left", made / elapsed.count(),
                          left * elapsed.count() / made);
    }
    if (terminal) std::fputs("\r", stdout);
    print("{}{}", text, terminal ? "" : "\n");
    if (terminal) std::fputs("\033[K", stdout);
    std::fflush(stdout);
    std::this_thread::sleep_for(std::chrono::seconds(1));
    now = standing_of(file);
  }
  if (terminal) print("\n");
  return now;
}

int show(const StatusArguments& arguments) {
  if (!arguments.snapshot.empty()) {
    refuse_unsafe_outputs({.inputs = {arguments.file, results_path_of(arguments.file)},
                           .outputs = {arguments.snapshot},
                           .force = arguments.force,
                           .streams = false});
    const StudyOutcome outcome = write_snapshot(begun_study(arguments.file), arguments.snapshot);
    log(stdout, "{} rows are in {}\n", outcome.rows, arguments.snapshot);
    return outcome.complete() ? kPass : kIncomplete;
  }
  JournalStatus standing = arguments.watch ? watch(arguments.file) : standing_of(arguments.file);
  if (standing.writers > 0) {
    if (is_json_output) print_json(standing_json(standing));
    if (!is_json_output) print_details(standing, arguments.file);
    return kIncomplete;
  }
  const Rows rows = rows_of_study(arguments.file);
  standing.rows = rows.size();
  standing.identity.planned_rows = rows.identity().planned_rows;
  const CheckVerdict verdict = judge(rows, arguments.file);
  if (!is_json_output) print_details(standing, arguments.file);
  nlohmann::ordered_json json = standing_json(standing);
  json["check"] = verdict_json(verdict, rows.identity());
  print_result(json, "{}{}", verdict_line(verdict), left_out_text(rows.identity()));
  return verdict.exit_code();
}

}  // namespace

nlohmann::ordered_json verdict_json(const CheckVerdict& verdict, const StudyIdentity& identity) {
  nlohmann::ordered_json skipped = nlohmann::ordered_json::array();
  for (const SkippedFile& file : side_records<SkippedFile>(identity)) {
    skipped.push_back({{"collection", file.name}, {"file", file.file}, {"reason", file.reason}});
  }
  const auto [files_read, files_given] = file_counts(identity);
  nlohmann::ordered_json findings = nlohmann::ordered_json::array();
  for (const Finding& one : verdict.findings) {
    findings.push_back({{"kind", to_string(one.kind)},
                        {"row", one.row ? nlohmann::ordered_json(*one.row) : nullptr},
                        {"message", one.message},
                        {"subject", one.subject},
                        {"command", one.command}});
  }
  return {{"verdict", verdict.word()},
          {"exit_code", verdict.exit_code()},
          {"rows", verdict.rows},
          {"proved", verdict.proved},
          {"violated", verdict.violated_rows},
          {"incomplete", verdict.incomplete_rows},
          {"refused", verdict.refused},
          {"not_proved", verdict.unproved},
          {"measured", verdict.measured},
          {"all_findings", verdict.all_findings},
          {"files_read", files_read},
          {"files_given", files_given},
          {"skipped_files", skipped},
          {"findings", findings}};
}

Rows rows_of_study(const std::string& file) {
  const std::string results = results_path_of(file);
  if (rows_are_in_results(results)) return Rows(results);
  try {
    Rows rows(existing_journals(results));
    rows.file = results;
    rows.identity().planned_rows = planned_rows(file, rows.identity());
    return rows;
  } catch (const InputError&) {  // a study that ends takes its journals away
    if (!rows_are_in_results(results)) throw;
    return Rows(results);
  }
}

std::string left_out_text(const StudyIdentity& identity) {
  const auto [read, given] = file_counts(identity);
  if (read == given) return "";
  return fmt::format("files    {} of {} were read; the report lists the others with the reason\n",
                     read, given);
}

CheckVerdict judge(const Rows& rows, const std::string& file) {
  CheckVerdict verdict = check(rows, file);
  if (verdict.unproved > 0) verdict.accepts_unproved = accepts_unproved(rows.identity().spec);
  return verdict;
}

void add_study_status(CLI::App& study, int& exit_code) {
  CLI::App* verb =
      study.add_subcommand("status", "Tells how far a study is, also while it is running");
  const auto arguments = std::make_shared<StatusArguments>();
  verb->add_option("FILE", arguments->file, "its results file or its journal")->required();
  verb->add_flag("--watch", arguments->watch, "print it every second until the study has ended");
  CLI::Option* const snapshot = verb->add_option(
      "--snapshot", arguments->snapshot, "write the rows so far as a results file of their own");
  add_json(*verb)->excludes(snapshot)->excludes(verb->get_option("--watch"));
  add_force(*verb, arguments->force);
  verb->footer(
      "Exit code as of `ar3d check`; 5 while the study is running.\nExample: ar3d study status "
      "--watch "
      "ar3d-quick.h5");
  verb->callback([arguments, &exit_code] { exit_code = show(*arguments); });
}

void add_check(CLI::App& app, int& exit_code) {
  CLI::App* verb = app.add_subcommand(
      "check", "Bounds and certificates of every row; the exit code is the verdict");
  const auto path = std::make_shared<std::string>();
  verb->add_option("RESULTS", *path, "results file (HDF5), or the journal of an unfinished study")
      ->required();
  const auto accepts_unproved = std::make_shared<bool>(false);
  add_json(*verb);
  verb->add_flag("--accept-unproved", *accepts_unproved,
                 "pass although rows were judged by another certificate than exact");
  verb->footer(
      "Exit code 0 pass, 4 violated, 5 incomplete, nothing measured, or rows that nothing "
      "proves.\nExample: ar3d check "
      "smoke.h5");
  verb->callback([path, accepts_unproved, &exit_code] {
    const Rows rows = rows_of_study(*path);
    CheckVerdict verdict = judge(rows, *path);
    verdict.accepts_unproved = verdict.accepts_unproved || *accepts_unproved;
    const StudyIdentity& identity = rows.identity();
    print_result(verdict_json(verdict, identity), "{}{}", summary(verdict),
                 left_out_text(identity));
    exit_code = verdict.exit_code();
  });
}

}  // namespace ar3d
