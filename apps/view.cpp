// Pages that show drawings in 3D: `ar3d view`.
#include "view.h"

#include <filesystem>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/error.h"
#include "commands.h"
#include "options.h"
#include "outputs.h"
#include "several_inputs.h"

namespace ar3d {
namespace {

struct ViewArguments {
  std::vector<std::string> inputs;
  std::string output;
  std::string algorithm;
  bool force = false;
};

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

/// Refuses what stands under a name that nobody gave, unless it is such a page.
void refuse_other_file(const std::string& page) {
  const std::string beginning = beginning_of(page);
  if (beginning.empty() || beginning.find(kViewerMark) != std::string::npos) return;
  throw InputError(
      fmt::format("{} exists and is no page of `ar3d view`; give another name with -o", page));
}

int view_drawings(const ViewArguments& arguments) {
  const std::string page = arguments.output.empty() ? page_of(arguments.inputs) : arguments.output;
  if (arguments.output.empty()) refuse_other_file(page);
  refuse_unsafe_outputs({.inputs = arguments.inputs,
                         .outputs = {},
                         .page = page,
                         .page_is = kViewerMark,
                         .force = arguments.force});
  refuse_foreign_ending(page, {".html", ".htm"});
  if (!arguments.algorithm.empty()) find_algorithm(arguments.algorithm);
  SeveralInputs<DrawingJsonlReader> inputs(arguments.inputs, [](const std::string& path) {
    return std::make_unique<DrawingJsonlReader>(path);
  });
  const NextDrawing next = [&]() -> std::optional<PlacedLine> {
    std::optional<DrawingJsonlReader::Line> line = inputs.next();
    if (!line) return std::nullopt;
    return PlacedLine{std::move(*line), inputs.reader().where()};
  };
  write_viewer_page(next, page, arguments.algorithm);
  if (page != "-") note(stdout, "wrote {}\n", page);
  return kPass;
}

}  // namespace

void add_view(CLI::App& app, int& exit_code) {
  CLI::App* verb = app.add_subcommand(
      "view", "Writes a page that shows drawings in 3D, to be opened in any browser");
  const auto arguments = std::make_shared<ViewArguments>();
  verb->add_option("FILE", arguments->inputs,
                   "drawings as JSON lines; - is standard input; several go on one page")
      ->required();
  verb->add_option("-o,--output", arguments->output,
                   "the page; the drawings' file with the ending .html if left out");
  verb->add_option("--algorithm", arguments->algorithm,
                   "whose guarantee to judge the drawings by; else the one that each names");
  add_force(*verb, arguments->force);
  verb->footer(
      "The page works from disk, without a network. Violations are listed in it; `ar3d verify` "
      "gives a "
      "verdict as exit code.\nExample: ar3d view drawing.jsonl");
  verb->callback([arguments, &exit_code] { exit_code = view_drawings(*arguments); });
}

}  // namespace ar3d
