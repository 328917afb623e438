#include "ar3d/analysis/check.h"

#include <fmt/format.h>

#include <memory>
#include <string>

#include "commands.h"

namespace ar3d {

void add_check(CLI::App& app, int& exit_code) {
  CLI::App* verb = app.add_subcommand(
      "check", "Bounds and certificates of every row; the exit code is the verdict");
  const auto path = std::make_shared<std::string>();
  verb->add_option("RESULTS", *path, "results file (HDF5)")->required();
  verb->footer(
      "Exit code 0 pass, 4 violated, 5 incomplete or nothing measured.\nExample: ar3d check "
      "smoke.h5");
  verb->callback([path, &exit_code] {
    RunReader reader(*path);
    const RowView rows = view_of(reader);  // millions of rows need not fit into memory
    require_one_study(rows, *path);
    const CheckVerdict verdict = check(rows);
    fmt::print("{}", summary(verdict, rows));
    exit_code = verdict.exit_code();
  });
}

}  // namespace ar3d
