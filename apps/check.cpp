#include <fmt/format.h>

#include <memory>
#include <string>

#include "commands.h"
#include "study_rows.h"

namespace ar3d {

void add_check(CLI::App& app, int& exit_code) {
  CLI::App* verb = app.add_subcommand(
      "check", "Bounds and certificates of every row; the exit code is the verdict");
  const auto path = std::make_shared<std::string>();
  verb->add_option("RESULTS", *path, "results file (HDF5), or the journal of an unfinished study")
      ->required();
  verb->footer(
      "Exit code 0 pass, 4 violated, 5 incomplete or nothing measured.\nExample: ar3d check "
      "smoke.h5");
  verb->callback([path, &exit_code] {
    const StudyRows rows(*path);
    const CheckVerdict verdict = judge(rows.view(), *path).verdict;
    fmt::print("{}", summary(verdict));
    exit_code = verdict.exit_code();
  });
}

}  // namespace ar3d
