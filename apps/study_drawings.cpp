// What is made of finished rows: drawings that are kept, and `ar3d study count`.
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>
#include <string>

#include "ar3d/base/error.h"
#include "ar3d/base/new_file.h"
#include "ar3d/base/printable.h"
#include "ar3d/bench/keep/study_files.h"
#include "ar3d/bench/measure/processes.h"
#include "ar3d/bench/replay/replay_row.h"
#include "ar3d/bench/run/row_maker.h"
#include "ar3d/formats/drawings/catalog.h"
#include "ar3d/formats/text/output.h"
#include "ar3d/store/rows.h"
#include "commands.h"
#include "options.h"
#include "outputs.h"
#include "study.h"
#include "study_rows.h"

namespace ar3d {
namespace {

int write_drawings(const std::string& path, const Rows& rows, KeptDrawings kept) {
  OutputFile file(path);
  const auto [written, repeated, problems] = write_kept_drawings(rows, kept, file);
  for (const std::string& problem : problems) print(stderr, "ar3d: {}\n", printable(problem));
  if (!problems.empty() && written == 0) {
    print(stderr, "ar3d: no drawing could be made again; {} is not written\n", path);
    return kRegression;
  }
  file.commit();
  log(path == "-" ? stderr : stdout, "drawings {}: {} kept ({}{})\n",
      path == "-" ? "standard output" : path, written, to_string(kept),
      repeated == 0 ? "" : fmt::format("; {} more rows have one of these", repeated));
  return problems.empty() ? kPass : kRegression;
}

/// Is there nothing, or a file that begins as drawings do?
bool may_be_replaced(const std::string& path) {
  const std::string head = beginning_of(path);
  return head.empty() || head.starts_with("{\"n\":");
}

struct CountArguments {
  std::string results;
  std::string output;
  std::int64_t max_n = kLargestCounted;
  bool force = false;
};

int count(const CountArguments& arguments) {
  const std::string path = arguments.output.empty() ? arguments.results : arguments.output;
  Results results = read_results(arguments.results);
  if (!arguments.output.empty()) {
    refuse_unsafe_outputs({.inputs = files_of_study(results, arguments.results),
                           .outputs = {path},
                           .force = arguments.force,
                           .streams = false});
  }
  require_writable(path);
  const Interruptible interruptible(/*ignores_second=*/true);  // to clean up in peace
  const std::size_t counted = fill_counts(results, arguments.max_n);
  if (is_interrupted()) return kInterrupted;
  if (counted == 0) {
    print(stderr, "ar3d: {} has no drawing of ours up to n = {}\n", arguments.results,
          arguments.max_n);
    return kIncomplete;
  }
  std::set<std::string> seen;
  nlohmann::ordered_json drawings = nlohmann::ordered_json::array();
  for (const RunRecord& run : results.runs) {
    if (run.counted_instructions < 0) continue;
    const std::string line =
        fmt::format("{}\t{}\t{}\t{}\t{}\t{}\t{}\n", run.family, run.n, run.seed, run.algorithm,
                    run.options, run.counted_instructions, run.estimated_cycles);
    if (!seen.insert(line).second) continue;
    log(stdout, "{}", line);
    drawings.push_back({{"family", run.family},
                        {"n", run.n},
                        {"seed", run.seed},
                        {"algorithm", run.algorithm},
                        {"options", run.options},
                        {"counted_instructions", run.counted_instructions},
                        {"estimated_cycles", run.estimated_cycles}});
  }
  if (is_json_output) print_json({{"drawings", drawings}});
  write_results(results, path);
  return kPass;
}

void add_draw_counted(CLI::App& study) {
  CLI::App* verb = study.add_subcommand(kDrawCountedVerb, "Draws graphs, for callgrind")->group("");
  const auto file = std::make_shared<std::string>();
  verb->add_option("FILE", *file)->required();
  verb->callback([file] { draw_for_counting(*file); });
}

}  // namespace

int keep_drawings(const std::string& results, KeptDrawings kept, const std::string& output,
                  bool force) {
  const std::string path = output.empty() ? drawings_path(results) : output;
  const Rows rows = rows_of_study(results);
  refuse_unsafe_outputs(
      {.inputs = files_of_study(rows.identity(), results), .outputs = {path}, .force = force});
  if (const std::string format = drawing_format("", path).name; format != "jsonl") {
    throw InputError(fmt::format(
        "-o {}: JSON lines are written, not {}; `ar3d draw` and `replay` of a ROW write others",
        path, format));
  }
  return write_drawings(path, rows, kept);
}

int keep_drawings_beside(const std::string& results, const Rows& rows, KeptDrawings kept,
                         bool force, bool unchanged) {
  const std::string path = drawings_path(results);
  if (unchanged && std::filesystem::exists(path) && may_be_replaced(path)) {
    log(stdout, "drawings {}: as it was, no row is new\n", path);
    return kPass;
  }
  if (!force && !may_be_replaced(path)) {
    print(stderr,
          "ar3d: {} is no file of drawings and stays as it is; `ar3d replay {} --keep {} "
          "-o OTHER.jsonl` writes them\n",
          path, shell_word(results), to_string(kept));
    return kRegression;
  }
  return write_drawings(path, rows, kept);
}

void add_study_count(CLI::App& study, int& exit_code) {
  CLI::App* verb = study.add_subcommand(
      "count", "Counts instructions and simulated cache of every drawing with callgrind: no noise");
  const auto arguments = std::make_shared<CountArguments>();
  verb->add_option("RESULTS", arguments->results, "results file (HDF5)")->required();
  verb->add_option("-o,--output", arguments->output,
                   "results file with the counts; RESULTS itself if left out");
  add_json(*verb);
  add_force(*verb, arguments->force);
  verb->add_option("--max-n", arguments->max_n, "largest n to count")
      ->check(whole_number(0, 100000000));
  verb->footer(
      "Needs valgrind; drawing takes about 50 times as long under it. Fills the columns\n"
      "counted_instructions and estimated_cycles.\nExample: ar3d study count smoke.h5 --max-n 20 "
      "-o counted.h5");
  verb->callback([arguments, &exit_code] { exit_code = count(*arguments); });
  add_draw_counted(study);
}

}  // namespace ar3d
