#include "ar3d/analysis/report.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>

#include "ar3d/analysis/check.h"
#include "ar3d/analysis/export.h"
#include "ar3d/analysis/google_benchmark.h"
#include "ar3d/bench/keep/study_files.h"
#include "ar3d/model/error.h"
#include "ar3d/records/run_storage.h"
#include "ar3d/results/atomic_file.h"
#include "commands.h"
#include "outputs.h"
#include "svg_to_pdf.h"

namespace ar3d {
namespace {

/// DIRECTORY/NAME.svg and .pdf for every figure. @throws InputError if one cannot be written.
void write_figures(const Results& results, const std::string& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) throw InputError(fmt::format("cannot create {}: {}", directory, error.message()));
  for (const Figure& figure : report_figures(results)) {
    const std::string stem = directory + "/" + figure.name;
    write_file_atomically(stem + ".svg", figure.svg);
    convert_svg_to_pdf(stem + ".svg", stem + ".pdf");
  }
  fmt::print("figures  {}\n", directory);
}

}  // namespace

void add_report(CLI::App& app, int& exit_code) {
  CLI::App* verb = app.add_subcommand(
      "report", "Bounds table, scaling models and figures as one offline HTML file");
  struct Arguments {
    std::string results;
    std::string output;
    std::string csv;
    std::string json;
    std::string rows;
    std::string growth;
    std::string figures;
    std::string benchmark_json;
  };
  const auto arguments = std::make_shared<Arguments>();
  verb->add_option("RESULTS", arguments->results, "results file (HDF5)")->required();
  verb->add_option("-o,--output", arguments->output,
                   "HTML file; the results file's name with .html if left out");
  verb->add_option("--csv", arguments->csv, "also write the bounds table as CSV to this file");
  verb->add_option("--json", arguments->json,
                   "also write bounds table and growth models as JSON to this file");
  verb->add_option("--growth", arguments->growth,
                   "also write the growth models as CSV to this file");
  verb->add_option("--rows", arguments->rows,
                   "also write metrics and bounds of every row as CSV to this file");
  verb->add_option("--figures", arguments->figures,
                   "also write the figures as SVG and PDF into this directory");
  verb->add_option("--benchmark-json", arguments->benchmark_json,
                   "also write the timed rows as a Google Benchmark report to this file");
  verb->footer("Example: ar3d report smoke.h5 -o smoke.html --figures figures");
  verb->callback([arguments, &exit_code] {
    const std::string path =
        arguments->output.empty() ? report_path(arguments->results) : arguments->output;
    refuse_unsafe_outputs({.inputs = {arguments->results},
                           .outputs = {path, arguments->csv, arguments->json, arguments->rows,
                                       arguments->growth, arguments->benchmark_json}});
    if (arguments->output.empty()) refuse_foreign_page(path, arguments->results);
    const Results results = read_results(arguments->results);
    require_one_study(view_of(results), arguments->results);
    write_file_atomically(path, render_report(results));
    if (!arguments->csv.empty()) write_file_atomically(arguments->csv, bounds_csv(results));
    if (!arguments->json.empty()) write_file_atomically(arguments->json, analysis_json(results));
    if (!arguments->rows.empty()) write_file_atomically(arguments->rows, rows_csv(results));
    if (!arguments->growth.empty()) write_file_atomically(arguments->growth, scaling_csv(results));
    if (!arguments->figures.empty()) write_figures(results, arguments->figures);
    if (!arguments->benchmark_json.empty()) {
      write_file_atomically(arguments->benchmark_json, google_benchmark_json(results));
    }
    fmt::print("report   {}\n", path);
    if (results.runs.empty()) {
      fmt::print(stderr, "ar3d: {}: nothing measured: the file has no rows\n", arguments->results);
      exit_code = kIncomplete;
    }
  });
}

}  // namespace ar3d
