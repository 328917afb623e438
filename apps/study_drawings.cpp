#include "study_drawings.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>

#include "ar3d/base/error.h"
#include "ar3d/base/printable.h"
#include "ar3d/bench/keep/study_files.h"
#include "ar3d/bench/replay/keep_drawings.h"
#include "ar3d/formats/drawings/catalog.h"
#include "ar3d/formats/text/output.h"
#include "commands.h"
#include "outputs.h"
#include "study.h"
#include "study_rows.h"
#include "words.h"

namespace ar3d {
namespace {

int write_drawings(const std::string& path, const RowView& rows, KeptDrawings kept) {
  OutputFile file(path);
  const ReadableRows readable{rows.count, [&rows](std::size_t row) { return rows.read(row); }};
  const KeptOutcome outcome = write_kept_drawings(readable, *rows.identity, kept, file);
  for (const std::string& problem : outcome.problems) {
    fmt::print(stderr, "ar3d: {}\n", printable(problem));
  }
  if (!outcome.problems.empty() && outcome.kept == 0) {
    fmt::print(stderr, "ar3d: no drawing could be made again; {} is not written\n", path);
    return kRegression;
  }
  file.commit();
  fmt::print(path == "-" ? stderr : stdout, "drawings {}: {} kept ({})\n",
             path == "-" ? "standard output" : path, outcome.kept, to_string(kept));
  return outcome.problems.empty() ? kPass : kRegression;
}

/// Is there nothing, or a file that begins as drawings do?
bool may_be_replaced(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::string head(5, '\0');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  return in.gcount() == 0 || head == "{\"n\":";
}

struct DrawingsArguments {
  std::string results;
  std::string keep = "worst";
  std::string output;
  bool force = false;
};

int keep(const DrawingsArguments& arguments) {
  const std::string path =
      arguments.output.empty() ? drawings_path(arguments.results) : arguments.output;
  refuse_unsafe_outputs(
      {.inputs = {arguments.results}, .outputs = {path}, .force = arguments.force});
  const StudyRows rows(arguments.results);
  refuse_unsafe_outputs({.inputs = files_of_study(*rows.view().identity, arguments.results),
                         .outputs = {path},
                         .force = arguments.force});
  if (const std::string format = drawing_format("", path).name; format != "jsonl") {
    throw InputError(fmt::format(
        "-o {}: JSON lines are written, not {}; `ar3d draw` and `replay` write other formats", path,
        format));
  }
  return write_drawings(path, rows.view(), parse_kept_drawings(arguments.keep));
}

}  // namespace

int keep_drawings_beside(const std::string& results, const RowView& rows, KeptDrawings kept,
                         bool force, bool unchanged) {
  const std::string path = drawings_path(results);
  if (unchanged && std::filesystem::exists(path) && may_be_replaced(path)) {
    fmt::print("drawings {}: as it was, no row is new\n", path);
    return kPass;
  }
  if (!force && !may_be_replaced(path)) {
    fmt::print(stderr,
               "ar3d: {} is no file of drawings and stays as it is; `ar3d study drawings {} --keep "
               "{} -o OTHER.jsonl` writes them\n",
               path, shell_word(results), to_string(kept));
    return kRegression;
  }
  return write_drawings(path, rows, kept);
}

void add_study_drawings(CLI::App& study, int& exit_code) {
  CLI::App* verb = study.add_subcommand("drawings", "Draws chosen rows again and writes drawings");
  const auto arguments = std::make_shared<DrawingsArguments>();
  verb->add_option("RESULTS", arguments->results, "results file (HDF5)")->required();
  verb->add_option("--keep", arguments->keep,
                   "worst: of each algorithm and family the drawing with the largest share of a "
                   "bound; violated: those that were proved wrong; all")
      ->check(one_of({"worst", "violated", "all"}));
  verb->add_option("-o,--output", arguments->output,
                   "JSON lines, as `ar3d draw` writes them; RESULTS.drawings.jsonl if left out");
  add_force(*verb, arguments->force);
  verb->footer(
      "A drawing is written only if its hash is its row's; exit code 3 if one is not.\n"
      "Example: ar3d study drawings smoke.h5 --keep worst -o worst.jsonl");
  verb->callback([arguments, &exit_code] { exit_code = keep(*arguments); });
}

}  // namespace ar3d
