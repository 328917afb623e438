#include <fmt/format.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "ar3d/analysis/check.h"
#include "ar3d/analysis/report.h"
#include "ar3d/bench/plan.h"
#include "ar3d/bench/run_study.h"
#include "ar3d/bench/study_spec.h"
#include "ar3d/results/atomic_file.h"
#include "ar3d/results/run.h"
#include "commands.h"

namespace ar3d {
namespace {

struct StudyArguments {
  std::string study;
  std::string output;
  int threads = 0;
  bool quiet = false;
};

std::atomic<bool> g_stop{false};
static_assert(std::atomic<bool>::is_always_lock_free);  // so that a signal handler may set it

void ask_to_stop(int) { g_stop = true; }

std::string report_path(const std::string& results) {
  return std::filesystem::path(results).replace_extension(".html").string();
}

int run_and_report(const StudyArguments& arguments) {
  const StudySpec spec = load_study(arguments.study);
  const std::string path = arguments.output.empty() ? default_results_path(spec) : arguments.output;
  require_writable(path);
  std::signal(SIGINT, ask_to_stop);
  std::signal(SIGTERM, ask_to_stop);
  const Results results = run_study(spec, {.threads = arguments.threads,
                                           .progress = arguments.quiet ? nullptr : stderr,
                                           .stop = &g_stop});
  write_results(results, path);
  if (g_stop) {
    fmt::print(stderr, "ar3d: interrupted; {} rows are in {}\n", results.runs.size(), path);
    return kInterrupted;
  }
  const std::string page = render_report(results);
  write_file_atomically(report_path(path), page);
  const CheckVerdict verdict = check(results);
  fmt::print("{}", summary(verdict, results));
  fmt::print("results  {}\nreport   {}\n", path, report_path(path));
  return verdict.exit_code();
}

void add_run(CLI::App& study, int& exit_code) {
  CLI::App* verb = study.add_subcommand("run", "Runs a study and writes its results and report");
  const auto arguments = std::make_shared<StudyArguments>();
  verb->add_option("STUDY", arguments->study, "a TOML file or a study of `ar3d list studies`")
      ->required();
  verb->add_option("-o,--output", arguments->output, "results file; ar3d-NAME.h5 if left out");
  verb->add_option("--threads", arguments->threads, "number of threads; all cores if left out")
      ->check(CLI::Range(1, 1024));
  verb->add_flag("-q,--quiet", arguments->quiet, "no progress on standard error");
  verb->footer("Example: ar3d study run smoke --threads 2 -o smoke.h5");
  verb->callback([arguments, &exit_code] { exit_code = run_and_report(*arguments); });
}

void add_plan(CLI::App& study, int&) {
  CLI::App* verb = study.add_subcommand("plan", "Shows what a study would do");
  const auto name = std::make_shared<std::string>();
  verb->add_option("STUDY", *name, "a TOML file or a study of `ar3d list studies`")->required();
  verb->footer("Example: ar3d study plan quick");
  verb->callback([name] {
    const StudyPlan plan = plan_study(load_study(*name));
    for (const PlannedInstance& instance : plan.instances) {
      fmt::print("{} {} n={} instance {} seed {}: {} rows\n", instance.choice.family->name,
                 instance.parameters, instance.n, instance.index, instance.seed,
                 instance.runs.size());
    }
    fmt::print("{} instances, {} rows\n", plan.instances.size(), plan.rows);
  });
}

}  // namespace

void add_study(CLI::App& app, int& exit_code) {
  CLI::App* verb = app.add_subcommand(
      "study", "Runs certified, timed sweeps over families, sizes and algorithms");
  verb->require_subcommand(1);
  add_run(*verb, exit_code);
  add_plan(*verb, exit_code);
}

}  // namespace ar3d
