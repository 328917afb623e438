// `ar3d report`: the page, and its tables as files of their own.
#include "ar3d/analysis/report/report.h"

#include "ar3d/bench/keep/study_files.h"
#include "ar3d/formats/text/output.h"
#include "commands.h"
#include "options.h"
#include "outputs.h"
#include "study_rows.h"

namespace ar3d {
namespace {

struct ReportArguments {
  std::string results;
  std::string output;
  std::string csv;
  std::string json;
  std::string rows;
  std::string growth;
  std::string reference;
  bool force = false;
};

int write_report(const ReportArguments& arguments) {
  const std::string results = results_path_of(arguments.results);
  is_json_output = arguments.json == "-";
  const std::string path = arguments.output.empty() ? report_path(results) : arguments.output;
  if (arguments.output.empty()) refuse_foreign_page(path, results);
  refuse_unsafe_outputs({.inputs = {arguments.results, results, arguments.reference},
                         .outputs = {arguments.csv, is_json_output ? "" : arguments.json,
                                     arguments.rows, arguments.growth},
                         .page = path,
                         .force = arguments.force,
                         .streams = false});
  refuse_foreign_ending(path, {".html", ".htm"});
  for (const std::string* csv : {&arguments.csv, &arguments.growth, &arguments.rows}) {
    refuse_foreign_ending(*csv, {".csv", ".txt"});
  }
  refuse_foreign_ending(arguments.json, {".json"});
  const Rows rows = rows_of_study(arguments.results);
  const StudyAnalysis analysis = analyse(rows, judge(rows, arguments.results));
  const SinceReference since = since_reference(rows, arguments.reference);
  const ShownDrawings drawings = shown_drawings(analysis);
  const auto write = [](const std::string& to, const auto& make) {
    if (!to.empty()) write_file_atomically(to, make());
  };
  write(path, [&] { return render_report(analysis, since, drawings); });
  write(arguments.csv, [&] { return bounds_csv(analysis); });
  if (!arguments.json.empty()) write_json(arguments.json, analysis_json(analysis, since));
  write(arguments.growth, [&] { return scaling_csv(analysis); });
  if (!arguments.rows.empty()) {
    OutputFile file(arguments.rows);
    rows_csv(rows, [&](std::string_view text) { file.append(text); });
    file.commit();
  }
  if (!is_json_output) print("{}", verdict_line(analysis.verdict));
  log(stdout, "report   {}\n", path);
  if (rows.size() == 0) {
    print(stderr, "ar3d: {}: nothing measured: the file has no rows\n", arguments.results);
  }
  return analysis.verdict.exit_code();
}

}  // namespace

void add_report(CLI::App& app, int& exit_code) {
  CLI::App* verb = app.add_subcommand(
      "report", "Bounds table, scaling models and figures as one offline HTML file");
  const auto arguments = std::make_shared<ReportArguments>();
  verb->add_option("RESULTS", arguments->results,
                   "results file (HDF5), or the journal of an unfinished study")
      ->required();
  verb->add_option("-o,--output", arguments->output,
                   "HTML file; the results file's name with .html if left out");
  verb->add_option("--csv", arguments->csv, "also write the bounds table as CSV to this file");
  verb->add_option("--json", arguments->json,
                   "also write all tables as JSON to this file: what the page and `ar3d figures` "
                   "show; -: to standard output instead of the text");
  verb->add_option("--growth", arguments->growth,
                   "also write the growth models as CSV to this file");
  verb->add_option("--rows", arguments->rows,
                   "also write metrics and bounds of every row as CSV to this file");
  verb->add_option("--reference", arguments->reference,
                   "results file of the same study to say what changed since; the youngest of "
                   "results/reference in a checkout if left out");
  add_force(*verb, arguments->force);
  verb->footer(
      "The reference does not change the exit code: `ar3d compare` does.\nExit code as of `ar3d "
      "check`.\nExample: ar3d report smoke.h5 -o smoke.html --json tables.json");
  verb->callback([arguments, &exit_code] { exit_code = write_report(*arguments); });
}

}  // namespace ar3d
