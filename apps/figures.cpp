// `ar3d figures`: the tables of a study, drawn for a paper by python/ar3d/figures.py, which stands in
// the program.
#include <fmt/format.h>
#include <sys/wait.h>

#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ar3d/analysis/report/report.h"
#include "ar3d/base/error.h"
#include "ar3d/base/new_file.h"
#include "ar3d/base/system_calls.h"
#include "ar3d_figures_script.h"
#include "commands.h"
#include "outputs.h"
#include "study_rows.h"

namespace ar3d {
namespace {

struct FiguresArguments {
  std::string results;
  std::string folder;
  std::string quantity = "side";
  std::string format = "pdf";
  std::vector<std::pair<std::string, std::string>> passed_on = {
      {"--algorithms", ""}, {"--families", ""},  {"--over", ""},
      {"--width", ""},      {"--font-size", ""}, {"--style", ""}};
  bool is_grid = false;
  bool force = false;
};

/// The files that the script is to write: DIR/QUANTITY.FORMAT, or one of all quantities.
std::vector<std::string> figure_files(const FiguresArguments& arguments) {
  std::vector<std::string> names = CLI::detail::split(arguments.quantity, ','), files;
  if (arguments.is_grid) names = {fmt::format("{}", fmt::join(names, "-"))};
  for (const std::string& name : names) {
    for (const std::string& format : CLI::detail::split(arguments.format, ',')) {
      files.push_back(fmt::format("{}/{}.{}", arguments.folder, name, format));
    }
  }
  return files;
}

/// The Python that Debian's python3-matplotlib belongs to.
constexpr const char* kPython = "/usr/bin/python3";

/// Runs the script in Python; its standard streams are ours. @return its exit code.
/// @throws InputError if there is no Python, or something ended it.
int run_script(std::vector<std::string> words) {
  words.insert(words.begin(), {kPython, "-c", std::string(kFiguresScript)});
  Child child = Child::of_program(std::move(words), {});
  if (child.run_error() != 0) {
    throw InputError(fmt::format("cannot run {} ({}): apt install python3-matplotlib", kPython,
                                 std::strerror(child.run_error())));
  }
  const int status = child.wait();
  if (!WIFEXITED(status)) throw InputError("python3 was ended before it had made the figures");
  return WEXITSTATUS(status);
}

int make_figures(const FiguresArguments& arguments) {
  const std::string tables = arguments.folder + "/tables.json";
  VerbFiles files{.inputs = {arguments.results},
                  .outputs = figure_files(arguments),
                  .force = arguments.force,
                  .streams = false};
  files.outputs.push_back(tables);
  refuse_unsafe_outputs(files);
  const Rows rows = rows_of_study(arguments.results);
  const StudyAnalysis analysis = analyse(rows);
  make_folder(arguments.folder);
  write_file_atomically(tables, analysis_json(analysis));
  std::vector<std::string> words = {
      tables,           "-o",     arguments.folder, "--quantity", arguments.quantity, "--format",
      arguments.format, "--force"};
  if (arguments.is_grid) words.emplace_back("--grid");
  for (const auto& [option, value] : arguments.passed_on) {
    if (!value.empty()) words.push_back(fmt::format("{}={}", option, value));
  }
  const int exit_code = run_script(std::move(words));
  if (exit_code != 0) std::remove(tables.c_str());
  return exit_code == 0 || exit_code == kUsage ? exit_code : kInternalError;
}

}  // namespace

void add_figures(CLI::App& app, int& exit_code) {
  CLI::App* verb = app.add_subcommand(
      "figures", "Figures for papers, with the size, fonts and formats that you choose");
  const auto arguments = std::make_shared<FiguresArguments>();
  verb->add_option("RESULTS", arguments->results,
                   "results file (HDF5), or the journal of an unfinished study")
      ->required();
  verb->add_option("-o,--output", arguments->folder,
                   "folder of the figures QUANTITY.FORMAT, and of tables.json, which they show")
      ->required();
  verb->add_option("--quantity", arguments->quantity,
                   "side, x, y, z, volume, bends, time, share, trade, profile, precision, scaling; "
                   "several with commas between");
  constexpr const char* kHelp[] = {
      "algorithms, or settings such as 'diamond (effort=1)', with commas between; all if left out",
      "a line for each of these families instead of a band over all",
      "divides quantities that grow with n by n to this power, such as 1.5",
      "of a figure: 84mm, 3.3in",
      "in points; 8 if left out",
      "a style sheet of matplotlib: a name or a file"};
  for (std::size_t i = 0; i < arguments->passed_on.size(); ++i) {
    auto& [option, value] = arguments->passed_on[i];
    verb->add_option(option, value, kHelp[i]);
  }
  verb->add_option("--format", arguments->format,
                   "pdf, svg, pgf, png; several with commas between");
  verb->add_flag("--grid", arguments->is_grid, "all quantities in one figure");
  add_force(*verb, arguments->force);
  verb->footer(
      "Needs python3-matplotlib. Exit code 2 if a figure cannot be made.\nExample: ar3d figures "
      "smoke.h5 -o figures --quantity side,volume --width 84mm --format pdf,png");
  verb->callback([arguments, &exit_code] { exit_code = make_figures(*arguments); });
}

}  // namespace ar3d
