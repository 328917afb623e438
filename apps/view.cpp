#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/error.h"
#include "ar3d/formats/catalog.h"
#include "ar3d/formats/drawings/drawing_html.h"
#include "ar3d/formats/drawings/drawing_jsonl.h"
#include "commands.h"
#include "outputs.h"
#include "viewer_page.h"

namespace ar3d {
namespace {

struct ViewArguments {
  std::string input;
  std::string output;
  std::string algorithm;
  bool force = false;
};

/// The input's name with the ending .html. @throws InputError for standard input.
std::string page_of(const std::string& input) {
  if (input == "-") throw InputError("a page of standard input needs a name: give one with -o");
  return std::filesystem::path(input).replace_extension(".html").string();
}

/// What stands under a name that nobody gave may be replaced only if it is such a page.
void refuse_other_file(const std::string& page) {
  std::ifstream in(page, std::ios::binary);
  if (!in) return;
  std::string beginning(1024, '\0');
  in.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  if (beginning.find(kViewerMark) != std::string::npos) return;
  throw InputError(
      fmt::format("{} exists and is no page of `ar3d view`; give another name with -o", page));
}

int view_drawings(const ViewArguments& arguments) {
  const std::string page = arguments.output.empty() ? page_of(arguments.input) : arguments.output;
  if (arguments.output.empty()) refuse_other_file(page);
  refuse_unsafe_outputs({.inputs = {arguments.input},
                         .outputs = {},
                         .page = page,
                         .page_is = kViewerMark,
                         .force = arguments.force});
  if (!arguments.algorithm.empty()) find_algorithm(arguments.algorithm);
  DrawingJsonlReader reader(arguments.input);
  const NextDrawing next = [&]() -> std::optional<PlacedLine> {
    std::optional<DrawingJsonlReader::Line> line = reader.next();
    if (!line) return std::nullopt;
    return PlacedLine{std::move(*line), reader.where()};
  };
  write_viewer_page(next, page, arguments.algorithm);
  if (page != "-") fmt::print("wrote {}\n", page);
  return kPass;
}

}  // namespace

void add_view(CLI::App& app, int& exit_code) {
  CLI::App* verb = app.add_subcommand(
      "view", "Writes a page that shows drawings in 3D, to be opened in any browser");
  const auto arguments = std::make_shared<ViewArguments>();
  verb->add_option("FILE", arguments->input, "drawings as JSON lines; - is standard input")
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
