// `ar3d report`: the page, and its tables and figures as files of their own.
#include "ar3d/analysis/report.h"

#include <fmt/format.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ar3d/analysis/export.h"
#include "ar3d/analysis/google_benchmark.h"
#include "ar3d/base/error.h"
#include "ar3d/base/new_file.h"
#include "ar3d/base/say.h"
#include "ar3d/bench/keep/study_files.h"
#include "commands.h"
#include "outputs.h"
#include "report_page.h"
#include "study_rows.h"

namespace ar3d {
namespace {

/// The figures, after a look at where they go: DIRECTORY/NAME.svg, .pdf, .csv, .py and
/// -pgfplots.tex.
/// @throws InputError if one would replace a file unasked.
std::vector<Figure> figures_for(const StudyAnalysis& analysis, const std::string& directory,
                                bool force) {
  if (directory.empty()) return {};
  std::vector<Figure> figures = report_figures(analysis);
  VerbFiles files{.inputs = {}, .outputs = {}, .force = force};
  for (const Figure& figure : figures) {
    for (const char* ending : {".svg", ".pdf", ".csv", ".py", "-pgfplots.tex"}) {
      files.outputs.push_back(directory + "/" + figure.name + ending);
    }
  }
  refuse_unsafe_outputs(files);
  return figures;
}

/// Converts a file with rsvg-convert (Debian: librsvg2-bin); equal pictures give equal bytes.
/// @throws InputError if the program is missing or fails.
void convert_svg_to_pdf(const std::string& svg_path, const std::string& pdf_path) {
  setenv("SOURCE_DATE_EPOCH", "0", 0);  // else the PDF holds the time of day
  std::array<std::string, 6> words = {"rsvg-convert", "--format=pdf", "-o",
                                      pdf_path,       "--",           svg_path};
  std::array<char*, 7> arguments{};
  for (std::size_t i = 0; i < words.size(); ++i) arguments[i] = words[i].data();
  pid_t process = 0;
  const int error =
      posix_spawnp(&process, "rsvg-convert", nullptr, nullptr, arguments.data(), environ);
  if (error != 0) {
    throw InputError(fmt::format("cannot run rsvg-convert ({}); it is in Debian's librsvg2-bin",
                                 std::strerror(error)));
  }
  int status = 0;
  if (waitpid(process, &status, 0) != process || status != 0) {
    throw InputError(fmt::format("rsvg-convert cannot write {}", pdf_path));
  }
}

/// @throws InputError if one cannot be written.
void write_figures(const std::vector<Figure>& figures, const std::string& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) throw InputError(fmt::format("cannot create {}: {}", directory, error.message()));
  for (const Figure& figure : figures) {
    const std::string stem = directory + "/" + figure.name;
    write_file_atomically(stem + ".svg", figure.svg);
    write_file_atomically(stem + ".csv", figure.csv);
    write_file_atomically(stem + ".py", figure.matplotlib);
    write_file_atomically(stem + "-pgfplots.tex", figure.pgfplots);
    convert_svg_to_pdf(stem + ".svg", stem + ".pdf");
  }
  say("figures  {}\n", directory);
}

/// A file that is written piece by piece, whole or not at all. @throws InputError
void write_in_pieces(const std::string& path, const std::function<void(const TextSink&)>& make) {
  constexpr std::size_t kPiece = 1 << 20;
  NewFile file(path);
  std::string pending;
  make([&](std::string_view text) {
    pending += text;
    if (pending.size() < kPiece) return;
    file.write_all(pending);
    pending.clear();
  });
  file.write_all(pending);
  file.become_target();
}

struct ReportArguments {
  std::string results;
  std::string output;
  std::string csv;
  std::string json;
  std::string rows;
  std::string growth;
  std::string figures;
  std::string benchmark_json;
  std::string reference;
  bool force = false;
};

int write_report(const ReportArguments& arguments) {
  const std::string results = results_path_of(arguments.results);
  const std::string path = arguments.output.empty() ? report_path(results) : arguments.output;
  if (arguments.output.empty()) refuse_foreign_page(path, results);
  refuse_unsafe_outputs({.inputs = {arguments.results, results, arguments.reference},
                         .outputs = {arguments.csv, arguments.json, arguments.rows,
                                     arguments.growth, arguments.benchmark_json},
                         .page = path,
                         .force = arguments.force,
                         .streams = false});
  const StudyRows rows(arguments.results);
  const RowView& view = rows.view();
  const StudyAnalysis analysis = analyse(view, judge(view, arguments.results));
  const SinceReference since = since_reference(view, arguments.reference);
  const ShownDrawings drawings = shown_drawings(analysis);
  const std::vector<Figure> figures = figures_for(analysis, arguments.figures, arguments.force);
  const auto write = [](const std::string& to, const auto& make) {
    if (!to.empty()) write_file_atomically(to, make());
  };
  write(path, [&] { return render_report(analysis, since, drawings); });
  write(arguments.csv, [&] { return bounds_csv(analysis); });
  write(arguments.json, [&] { return analysis_json(analysis); });
  write(arguments.growth, [&] { return scaling_csv(analysis); });
  if (!arguments.rows.empty()) {
    write_in_pieces(arguments.rows, [&](const TextSink& sink) { rows_csv(view, sink); });
  }
  if (!arguments.benchmark_json.empty()) {
    write_in_pieces(arguments.benchmark_json,
                    [&](const TextSink& sink) { google_benchmark_json(view, sink); });
  }
  if (!arguments.figures.empty()) write_figures(figures, arguments.figures);
  say("{}report   {}\n", verdict_line(analysis.verdict), path);
  if (view.count == 0) {
    say(stderr, "ar3d: {}: nothing measured: the file has no rows\n", arguments.results);
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
                   "also write bounds table and growth models as JSON to this file");
  verb->add_option("--growth", arguments->growth,
                   "also write the growth models as CSV to this file");
  verb->add_option("--rows", arguments->rows,
                   "also write metrics and bounds of every row as CSV to this file");
  verb->add_option("--figures", arguments->figures,
                   "also write the figures as SVG, PDF and CSV, with matplotlib and pgfplots "
                   "scripts, into this directory");
  verb->add_option("--benchmark-json", arguments->benchmark_json,
                   "also write the timed rows as a Google Benchmark report to this file");
  verb->add_option("--reference", arguments->reference,
                   "results file of the same study to say what changed since; the youngest of "
                   "results/reference in a checkout if left out");
  add_force(*verb, arguments->force);
  verb->footer(
      "The reference does not change the exit code: `ar3d compare` does.\nExit code as of `ar3d "
      "check`.\nExample: ar3d report smoke.h5 -o smoke.html --figures "
      "figures");
  verb->callback([arguments, &exit_code] { exit_code = write_report(*arguments); });
}

}  // namespace ar3d
