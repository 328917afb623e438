// Rows made again: one, a sample, all, or those whose drawings are kept.
#include <fmt/ranges.h>
#include <unistd.h>

#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include "ar3d/base/error.h"
#include "ar3d/base/number.h"
#include "ar3d/base/printable.h"
#include "ar3d/bench/measure/environment.h"
#include "ar3d/bench/replay/replay_row.h"
#include "ar3d/bench/run/session.h"
#include "ar3d/formats/drawings/catalog.h"
#include "ar3d/store/columns/run_columns.h"
#include "ar3d/store/rows.h"
#include "commands.h"
#include "options.h"
#include "outputs.h"
#include "study.h"

namespace ar3d {
namespace {

struct ReplayArguments {
  std::string results;
  std::optional<std::string> row;
  std::string output;
  std::string format;
  std::string graphs;
  bool force = false;
  bool all = false;
  std::optional<std::size_t> sample;
  std::uint64_t seed = 1;  // of the sample
  std::optional<std::string> keep;
};

/// @throws InputError if the row was drawn by a program of the study's own that is another one now.
void refuse_changed_program(StudySpec spec, const RunRecord& row, const Results& results,
                            const std::string& path) {
  std::erase_if(spec.programs,
                [&](const auto& program) { return program->row.name != row.algorithm; });
  std::vector<EnvironmentEntry> then = results.environment;
  std::erase_if(then, [&](const EnvironmentEntry& entry) { return entry.session != row.session; });
  refuse_changed_programs(spec, then, path);
}

int replay_row(const ReplayArguments& arguments) {
  if (is_json_output && arguments.output == "-") {
    throw InputError("--json and -o - : standard output takes one of them");
  }
  const Results results = read_results(arguments.results);
  const RunRecord& then = find_row(results, *arguments.row, arguments.results);
  std::vector<std::string> inputs = files_of_study(results, arguments.results);
  inputs.push_back(arguments.graphs);
  refuse_unsafe_outputs(
      {.inputs = inputs, .outputs = {arguments.output}, .force = arguments.force});
  const DrawingFormat& format = drawing_format(arguments.format, arguments.output);
  StudyOrigin origin = study_origin(results);
  origin.moved_graphs = arguments.graphs;
  if (origin.study) refuse_changed_program(origin.study->spec, then, results, arguments.results);
  const RunRecord now = replayed(then, origin);
  const std::string which =
      fmt::format("{} {} n={} seed {}", then.family, then.parameters, then.n, then.seed);
  if (!arguments.output.empty()) {
    write_drawing(format, redrawn(then, origin), which, arguments.output);
  }
  const std::vector<std::string> differing = differing_columns(then, now);
  if (is_json_output) {
    print_json({{"row_key", then.row_key},
                {"status", to_string(now.status)},
                {"message", now.message},
                {"differing_columns", differing}});
  }
  std::string text = fmt::format("{} with {} {}: {}\n", which, then.algorithm, then.options,
                                 to_string(now.status));
  if (!now.message.empty() && now.message != then.message) text += printable(now.message) + "\n";
  for (const std::string& column : differing)
    text += fmt::format("column {} differs from the recorded row\n", column);
  if (differing.empty()) text += "every non-timing column is equal, bit for bit\n";
  // Never amid the drawing.
  if (!is_json_output) print(arguments.output == "-" ? stderr : stdout, "{}", text);
  if (now.status == RunStatus::violated) return kViolated;
  return differing.empty() ? kPass : kRegression;
}

int replay_rows(const ReplayArguments& arguments) {
  const Results results = read_results(arguments.results);
  const std::vector<std::size_t> rows = sample_of_rows(
      results.runs, arguments.all ? results.runs.size() : *arguments.sample, arguments.seed);
  if (results.source_hash != source_hash()) {
    log(stderr, "ar3d: the rows were made by source {}, this is {}\n", results.source_hash,
        source_hash());
  }
  std::size_t done = 0;
  const bool terminal = isatty(fileno(stderr)) == 1 && !is_quiet_output;
  const StudyOrigin origin = study_origin(results);
  std::size_t violated = 0;
  std::map<std::size_t, std::vector<std::string>> irreproducible;  // columns, by row
  for (const std::size_t row : rows) {
    const RunRecord now = replayed(results.runs[row], origin);
    violated += now.status == RunStatus::violated;
    const std::vector<std::string> columns = differing_columns(results.runs[row], now);
    if (!columns.empty()) irreproducible.emplace(row, columns);
    if (terminal) std::fprintf(stderr, "\r%zu of %zu rows made again", ++done, rows.size());
  }
  if (terminal) print(stderr, "\n");
  nlohmann::ordered_json differing = nlohmann::ordered_json::array();
  for (const auto& [row, columns] : irreproducible) {
    differing.push_back({{"row", row}, {"columns", columns}});
    const RunRecord& run = results.runs[row];
    log(stdout, "row {} ({} n={} with {} {}) differs in {}\n", row, run.family, run.n,
        run.algorithm, run.options, fmt::join(columns, " "));
  }
  print_result({{"rows", results.runs.size()},
                {"replayed", rows.size()},
                {"violated", violated},
                {"differing", differing}},
               "{} of {} rows made again: {} equal bit for bit, {} not, {} violated\n", rows.size(),
               results.runs.size(), rows.size() - irreproducible.size(), irreproducible.size(),
               violated);
  if (violated > 0) return kViolated;
  if (!irreproducible.empty()) return kRegression;
  return !rows.empty() ? kPass : kIncomplete;
}

int replay(const ReplayArguments& arguments) {
  if (int{arguments.row.has_value()} + int{arguments.all} + int{arguments.sample.has_value()} +
          int{arguments.keep.has_value()} !=
      1) {
    throw InputError("what is made again: a ROW, --all, --sample K or --keep WHICH, one of them");
  }
  if (arguments.row) return replay_row(arguments);
  if (!arguments.keep) return replay_rows(arguments);
  return keep_drawings(arguments.results, parse_kept_drawings(*arguments.keep), arguments.output,
                       arguments.force);
}

}  // namespace

const RunRecord& find_row(const Results& results, const std::string& row, const std::string& path) {
  const auto found = std::ranges::find(results.runs, row, &RunRecord::row_key);
  if (found != results.runs.end()) return *found;
  const auto number = integer_of<std::size_t>(row);
  if (!number || *number >= results.runs.size()) {
    throw InputError(fmt::format("{}: no row '{}'; rows are 0..{} or row keys", path, row,
                                 static_cast<std::int64_t>(results.runs.size()) - 1));
  }
  return results.runs[*number];
}

void add_replay(CLI::App& app, int& exit_code) {
  CLI::App* verb = app.add_subcommand(
      "replay", "Regenerates, draws and certifies rows again and compares them bit for bit");
  const auto arguments = std::make_shared<ReplayArguments>();
  verb->add_option("RESULTS", arguments->results, "results file (HDF5)")->required();
  verb->add_option("ROW", arguments->row, "a row key, or a row number from 0");
  CLI::Option* const all = verb->add_flag("--all", arguments->all, "every row");
  CLI::Option* const sample =
      verb->add_option("--sample", arguments->sample, "so many rows, chosen at random")
          ->check(whole_number(1, 10000000));
  verb->add_option("--seed", arguments->seed, "of the sample")
      ->check(whole_number(0))
      ->needs(sample);
  CLI::Option* const keep =
      verb->add_option("--keep", arguments->keep,
                       "write the drawings of rows. worst: of each algorithm and family the one "
                       "with the largest share of a bound; violated: those that were proved wrong; "
                       "all")
          ->check(one_of({"worst", "violated", "all"}));
  verb->add_option("-o,--output", arguments->output,
                   "the drawing of ROW, or those of --keep (JSON lines; RESULTS.drawings.jsonl if "
                   "left out), to this file; - is standard output")
      ->excludes(all)
      ->excludes(sample);
  add_force(*verb, arguments->force);
  add_json(*verb)->excludes(keep);
  for (CLI::Option* option :
       {verb->add_option("--format", arguments->format,
                         "of ROW's drawing, a format of `ar3d help draw`; by the file's ending, "
                         "jsonl without one"),
        verb->add_option("--graphs", arguments->graphs,
                         "the file that ROW's graph is in, if it is not where the study found "
                         "it")}) {
    option->excludes(all)->excludes(sample)->excludes(keep);
  }
  verb->footer(
      "Exit code 3 if a row is not reproduced, 4 if a drawing is violated, 5 if there is no row to "
      "make again. A drawing is kept only if its hash is its row's.\n"
      "Example: ar3d replay smoke.h5 0\n"
      "         ar3d replay smoke.h5 --sample 50 --seed 2");
  verb->callback([arguments, &exit_code] { exit_code = replay(*arguments); });
}

}  // namespace ar3d
