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
  const auto accepts_unproved = std::make_shared<bool>(false);
  verb->add_flag("--accept-unproved", *accepts_unproved,
                 "pass although rows were judged by another certificate than exact");
  verb->footer(
      "Exit code 0 pass, 4 violated, 5 incomplete, nothing measured, or rows that nothing "
      "proves.\nExample: ar3d check "
      "smoke.h5");
  verb->callback([path, accepts_unproved, &exit_code] {
    const StudyRows rows(*path);
    CheckVerdict verdict = judge(rows.view(), *path).verdict;
    verdict.accepts_unproved = verdict.accepts_unproved || *accepts_unproved;
    fmt::print("{}", summary(verdict));
    exit_code = verdict.exit_code();
  });
}

}  // namespace ar3d
