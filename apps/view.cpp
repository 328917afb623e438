// Pages that show drawings in 3D: `ar3d view`.
#include "view.h"

#include <filesystem>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/error.h"
#include "batches.h"
#include "commands.h"
#include "options.h"
#include "outputs.h"

namespace ar3d {
namespace {

/// The input's name with the ending .html. @throws InputError for standard input and several.
std::string page_of(const std::vector<std::string>& inputs) {
  if (inputs.size() > 1) {
    throw InputError("a page of several files needs a name: give one with -o");
  }
  if (inputs[0] == "-") {
    throw InputError("a page of standard input needs a name: give one with -o");
  }
  return std::filesystem::path(inputs[0]).replace_extension(".html").string();
}

/// Refuses what stands under a name that was not given, unless it is such a page.
void refuse_other_file(const std::string& page) {
  const std::string beginning = beginning_of(page);
  if (beginning.empty() || beginning.find(kViewerMark) != std::string::npos) return;
  throw InputError(
      fmt::format("{} exists and is no page of `ar3d view`; give another name with -o", page));
}

int view_drawings(VerbFiles files, const std::string& algorithm) {
  if (files.page.empty()) {
    files.page = page_of(files.inputs);
    refuse_other_file(files.page);
  }
  files.page_is = kViewerMark;
  refuse_unsafe_outputs(files);
  refuse_foreign_ending(files.page, {".html", ".htm"});
  if (!algorithm.empty()) find_algorithm(algorithm);
  SeveralInputs<DrawingJsonlReader> inputs(files.inputs, [](const std::string& path) {
    return std::make_unique<DrawingJsonlReader>(path);
  });
  const NextDrawing next = [&]() -> std::optional<PlacedLine> {
    std::optional<DrawingJsonlReader::Line> line = inputs.next();
    if (!line) return std::nullopt;
    return PlacedLine{std::move(*line), inputs.reader().where()};
  };
  write_viewer_page(next, files.page, algorithm);
  if (files.page != "-") log(stdout, "wrote {}\n", files.page);
  return kPass;
}

}  // namespace

void add_view(CLI::App& app, int& exit_code) {
  CLI::App* verb = app.add_subcommand(
      "view", "Writes a page that shows drawings in 3D, to be opened in any browser");
  const auto files = std::make_shared<VerbFiles>();
  const auto algorithm = std::make_shared<std::string>();
  verb->add_option("FILE", files->inputs,
                   "drawings as JSON lines; - is standard input; several go on one page")
      ->required();
  verb->add_option("-o,--output", files->page,
                   "the page; the drawings' file with the ending .html if left out");
  verb->add_option("--algorithm", *algorithm,
                   "whose guarantee to judge the drawings by; else the one that each names");
  add_force(*verb, files->force);
  verb->footer(
      "The page works from disk, without a network. Violations are listed in it; `ar3d verify` "
      "gives a "
      "verdict as exit code.\nExample: ar3d view drawing.jsonl");
  verb->callback([files, algorithm, &exit_code] { exit_code = view_drawings(*files, *algorithm); });
}

}  // namespace ar3d
