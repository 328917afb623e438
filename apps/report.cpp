#include "ar3d/analysis/report.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>

#include "ar3d/analysis/export.h"
#include "ar3d/results/atomic_file.h"
#include "ar3d/results/run.h"
#include "commands.h"

namespace ar3d {

void add_report(CLI::App& app, int&) {
  CLI::App* verb = app.add_subcommand(
      "report", "Bound ledger, scaling models and figures as one offline HTML file");
  struct Arguments {
    std::string results;
    std::string output;
    std::string csv;
    std::string json;
  };
  const auto arguments = std::make_shared<Arguments>();
  verb->add_option("RESULTS", arguments->results, "results file (HDF5)")->required();
  verb->add_option("-o,--output", arguments->output,
                   "HTML file; the results file's name with .html if left out");
  verb->add_option("--csv", arguments->csv, "also write the bound ledger as CSV to this file");
  verb->add_option("--json", arguments->json,
                   "also write ledger and growth models as JSON to this file");
  verb->footer("Example: ar3d report smoke.h5 -o smoke.html");
  verb->callback([arguments] {
    const Results results = read_results(arguments->results);
    const std::string path =
        arguments->output.empty()
            ? std::filesystem::path(arguments->results).replace_extension(".html").string()
            : arguments->output;
    write_file_atomically(path, render_report(results));
    if (!arguments->csv.empty()) write_file_atomically(arguments->csv, ledger_csv(results));
    if (!arguments->json.empty()) write_file_atomically(arguments->json, analysis_json(results));
    fmt::print("report   {}\n", path);
  });
}

}  // namespace ar3d
