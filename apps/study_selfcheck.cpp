#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <memory>
#include <string>

#include "ar3d/bench/measure/environment.h"
#include "ar3d/bench/replay/replay_row.h"
#include "ar3d/bench/replay/selfcheck.h"
#include "ar3d/store/run_storage.h"
#include "commands.h"
#include "numbers.h"
#include "study.h"

namespace ar3d {
namespace {

struct SelfcheckArguments {
  std::string results;
  std::size_t sample = 20;
  std::uint64_t seed = 1;
};

void print_irreproducible(const Results& results, const IrreproducibleRow& row) {
  const RunRecord& run = results.runs[row.row];
  std::string columns;
  for (const std::string& name : row.columns) columns += " " + name;
  fmt::print("row {} ({} n={} with {} {}) differs in{}\n", row.row, run.family, run.n,
             run.algorithm, run.options, columns);
}

int check_a_sample(const SelfcheckArguments& arguments) {
  const Results results = read_results(arguments.results);
  const std::vector<std::size_t> places =
      sample_of_rows(results.runs, arguments.sample, arguments.seed);
  if (results.source_hash != source_hash()) {
    fmt::print(stderr, "ar3d: the rows were made by source {}, this is {}\n", results.source_hash,
               source_hash());
  }
  std::size_t done = 0;
  const bool terminal = isatty(fileno(stderr)) == 1;
  const SelfCheck check = selfcheck(results.runs, places, study_origin(results), [&](std::size_t) {
    if (terminal) fmt::print(stderr, "\r{} of {} rows made again", ++done, places.size());
  });
  if (terminal) fmt::print(stderr, "\n");
  for (const IrreproducibleRow& row : check.irreproducible) print_irreproducible(results, row);
  fmt::print("{} of {} rows made again: {} equal bit for bit, {} not, {} violated\n",
             check.replayed, results.runs.size(), check.replayed - check.irreproducible.size(),
             check.irreproducible.size(), check.violated);
  if (check.violated > 0) return kViolated;
  if (!check.irreproducible.empty()) return kRegression;
  return check.replayed > 0 ? kPass : kIncomplete;
}

}  // namespace

void add_study_selfcheck(CLI::App& study, int& exit_code) {
  CLI::App* verb =
      study.add_subcommand("selfcheck", "Makes a random sample of rows again, bit for bit");
  const auto arguments = std::make_shared<SelfcheckArguments>();
  verb->add_option("RESULTS", arguments->results, "results file (HDF5)")->required();
  verb->add_option("--sample", arguments->sample, "number of rows, default 20")
      ->check(whole_number(1, 10000000));
  verb->add_option("--seed", arguments->seed, "of the sample, default 1")->check(whole_number(0));
  verb->footer(
      "Exit code 3 if a row is not reproduced, 4 if a drawing is violated, 5 if there is no row to "
      "make again.\nExample: ar3d study selfcheck smoke.h5 --sample 50 --seed 2");
  verb->callback([arguments, &exit_code] { exit_code = check_a_sample(*arguments); });
}

}  // namespace ar3d
