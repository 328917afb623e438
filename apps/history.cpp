// `ar3d history`: results of one commit after the other in a folder, and what changed between them.
#include "ar3d/analysis/history/history.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "ar3d/analysis/report/report.h"
#include "ar3d/base/error.h"
#include "ar3d/base/new_file.h"
#include "ar3d/base/number.h"
#include "ar3d/base/printable.h"
#include "ar3d/bench/measure/processes.h"
#include "commands.h"
#include "options.h"
#include "outputs.h"

namespace ar3d {
namespace {

constexpr const char* kFolder = "ar3d-history";
constexpr std::size_t kHashDigits = 12;  // of a commit's name

struct HistoryArguments {
  std::string folder = kFolder;
  std::string results;  // of `add`, as the next two
  std::int64_t index = -1;
  std::string name;
  std::string output;  // of `report`, as the next two
  std::string json;
  double threshold_percent = 5;
  bool force = false;
};

bool is_commit(const std::string& hash) {
  return hash.size() == 40 && hash.find_first_not_of("0123456789abcdef") == std::string::npos;
}

/// The version of the study's own program that the results are of; empty if it has none, or several
/// programs of different versions. A commit may have "-dirty" behind it.
std::string program_version_of(const std::vector<EnvironmentEntry>& environment) {
  std::string version;
  for (const EnvironmentEntry& entry : environment) {
    if (!entry.name.starts_with("version_")) continue;
    if (!version.empty() && version != entry.value) return "";
    version = entry.value;
  }
  return version;
}

/// Returns the commit, or the name, of what the results are a measurement of.
/// @throws InputError if they stand for no commit as a whole.
std::string measured_version(const HistoryArguments& arguments, const Rows& rows) {
  constexpr std::string_view kDirty = "-dirty";
  const StudyIdentity& study = rows.identity();
  std::string version = program_version_of(rows.environment());
  const bool is_ours = version.empty();
  const bool is_dirty = is_ours ? study.dirty : version.ends_with(kDirty);
  if (is_ours) version = study.source_hash;
  if (!is_ours && is_dirty) version.resize(version.size() - kDirty.size());
  const auto count = static_cast<std::int64_t>(rows.size());
  if (count == 0) throw InputError(fmt::format("{} has no rows", arguments.results));
  if (study.planned_rows > count) {
    throw InputError(fmt::format("{} is of a study that is not finished: {} of {} rows",
                                 arguments.results, count, study.planned_rows));
  }
  if (is_dirty && arguments.name.empty()) {
    throw InputError(
        fmt::format("{} was measured by a program with changes to commit {}: give it a --name",
                    arguments.results, printable(version.substr(0, kHashDigits))));
  }
  return version;
}

/// How many commits there are up to this one: more than up to each of its ancestors.
std::int64_t index_of(const HistoryArguments& arguments, const std::string& version) {
  if (arguments.index >= 0) return arguments.index;
  std::vector<std::string> count;
  if (is_commit(version)) count = ask_git({"rev-list", "--count", version, "--"});
  if (const auto index = integer_of<std::int64_t>(count.empty() ? "" : count[0])) return *index;
  throw InputError(
      fmt::format("git in the working directory does not know the commit '{}' of {}: say with "
                  "--place where it stands in the order",
                  printable(version.substr(0, 40)), arguments.results));
}

/// One result is one measurement, whatever it is called.
/// @param target  may be a copy: it is replaced. @throws InputError
void refuse_copies(const std::string& results, const std::string& folder,
                   const std::string& target) {
  const auto size = std::filesystem::file_size(results);
  std::error_code error, ignored;
  for (const std::string& file : results_files(folder, ignored)) {
    if (file == target || std::filesystem::file_size(file, error) != size || error) continue;
    if (read_file(file) == read_file(results)) {
      throw InputError(fmt::format("{} is in the history already, as {}", results, file));
    }
  }
}

int add_results(const HistoryArguments& arguments) {
  const Rows rows(arguments.results);
  const StudyIdentity& study = rows.identity();
  const std::string own = measured_version(arguments, rows);
  const std::int64_t index = index_of(arguments, own);
  const std::string name = !arguments.name.empty() ? arguments.name
                           : is_commit(own)        ? own.substr(0, kHashDigits)
                                                   : own;
  const std::string path =
      arguments.folder + "/" + history_file_name(index, name, study, rows.environment());
  refuse_unsafe_outputs({.inputs = {arguments.results},
                         .outputs = {path},
                         .force = arguments.force,
                         .streams = false});
  refuse_copies(arguments.results, arguments.folder, path);
  make_folder(arguments.folder);
  write_file_atomically(path, read_file(arguments.results));
  if (is_json_output) print_json({{"added", path}});
  log(stdout, "added    {}\n", path);
  return kPass;
}

int report_history(const HistoryArguments& arguments) {
  const std::string page =
      arguments.output.empty() ? arguments.folder + "/history.html" : arguments.output;
  is_json_output = arguments.json == "-";
  std::error_code ignored;
  refuse_unsafe_outputs({.inputs = results_files(arguments.folder, ignored),
                         .outputs = {is_json_output ? "" : arguments.json},
                         .page = page,
                         .page_is = "<title>ar3d history: ",
                         .force = arguments.force,
                         .streams = false});
  for (const std::string& output : {page, arguments.json}) {
    if (std::filesystem::path(output).extension() == ".h5") {
      throw InputError(
          fmt::format("{}: .h5 is the ending of results files; the next report would "
                      "read it as one",
                      output));
    }
  }
  CompareOptions rule;
  rule.threshold = arguments.threshold_percent / 100;
  const History history = read_history(arguments.folder, rule);
  for (const std::string& output : {page, arguments.json}) {
    if (!output.empty() && output != "-") require_writable(output);
  }
  const std::vector<Table> tables = history_tables(history, arguments.folder);
  write_file_atomically(page, render_page("history", arguments.folder, tables));
  if (!arguments.json.empty()) write_json(arguments.json, tables_json(tables));
  if (!is_json_output) print("{}", summary(history));
  log(stdout, "page     {}\n", page);
  for (const HistoryLine& line : history.lines) {
    if (line.is_judged) return kPass;
  }
  print(stderr, "ar3d: {}: nothing was judged: every line is too short\n", arguments.folder);
  return kIncomplete;
}

void add_add(CLI::App& history, int& exit_code) {
  CLI::App* verb = history.add_subcommand("add", "Copies a results file into the folder");
  const auto arguments = std::make_shared<HistoryArguments>();
  verb->add_option("RESULTS", arguments->results, "results file (HDF5) of a finished study")
      ->required();
  verb->add_option("--folder", arguments->folder, "where the history is; made if it is not there");
  verb->add_option("--place", arguments->index,
                   "where the results stand in the order; the number of commits up to the "
                   "program's, by git, if left out")
      ->check(whole_number(0, 999999999));
  verb->add_option("--name", arguments->name,
                   "of the release, say v1.2; the first digits of the commit if left out")
      ->check([](const std::string& name) { return std::string(name.empty() ? "is empty" : ""); });
  add_json(*verb);
  add_force(*verb, arguments->force);
  verb->footer("Example: ar3d study run regression -o now.h5; ar3d history add now.h5");
  verb->callback([arguments, &exit_code] { exit_code = add_results(*arguments); });
}

void add_history_report(CLI::App& history, int& exit_code) {
  CLI::App* verb = history.add_subcommand(
      "report", "Every cell over the commits, and what changed where, as one offline HTML file");
  const auto arguments = std::make_shared<HistoryArguments>();
  verb->add_option("--folder", arguments->folder, "where the history is");
  verb->add_option("-o,--output", arguments->output, "HTML file; FOLDER/history.html if left out");
  verb->add_option("--json", arguments->json,
                   "also write all tables of the page as JSON to this file; -: to standard output "
                   "instead of the text");
  verb->add_option("--threshold", arguments->threshold_percent, "percent of time that matter")
      ->check(number_between(0.1, 1000));
  add_force(*verb, arguments->force);
  verb->footer(
      "Exit code 0: lines were judged, whatever changed; 5: none was long enough.\nExample: ar3d "
      "history report --folder ar3d-history -o history.html");
  verb->callback([arguments, &exit_code] { exit_code = report_history(*arguments); });
}

}  // namespace

void add_history(CLI::App& app, int& exit_code) {
  CLI::App* verb = app.add_subcommand(
      "history", "Results of many commits: every cell over time, and where it changed");
  verb->require_subcommand(1);
  add_add(*verb, exit_code);
  add_history_report(*verb, exit_code);
}

}  // namespace ar3d
