// Pages that show drawings in 3D: `ar3d view`, and the format of drawings that the program adds.
#include "view.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/error.h"
#include "ar3d/base/say.h"
#include "ar3d/formats/catalog.h"
#include "ar3d/formats/drawings/catalog.h"
#include "ar3d/formats/drawings/drawing_html.h"
#include "ar3d/formats/drawings/drawing_jsonl.h"
#include "ar3d/formats/text/output.h"
#include "ar3d/verify/certificate.h"
#include "commands.h"
#include "drawing_summary.h"
#include "outputs.h"
#include "several_inputs.h"

namespace ar3d {
const Algorithm* known_algorithm(const std::string& name) {
  const auto found = std::ranges::find(algorithms(), name, &Algorithm::name);
  return found == algorithms().end() ? nullptr : &*found;
}

PageVerdict page_verdict(const Drawing& drawing, const Algorithm* algorithm) {
  PageVerdict verdict;
  if (algorithm == nullptr) {
    verdict.text = "no guarantee is known of this algorithm";
    return verdict;
  }
  std::optional<Graph> graph;
  try {
    graph = claimed_graph(drawing);
  } catch (const InputError&) {
    verdict.text = "the edges are not those of a simple graph";
    return verdict;
  }
  const Certificate certificate = certify(*graph, drawing, algorithm->guarantee);
  for (const Violation& violation : certificate.violations) {
    verdict.violations.push_back({to_string(violation.kind), violation.message, violation.vertices,
                                  violation.edges, violation.points});
  }
  if (certificate.measured && !certificate.violated()) {
    verdict.text = "made in a real type, so nothing is proved; ar3d verify measures what it misses";
    return verdict;
  }
  verdict.kind = certificate.valid() ? PageVerdict::PageJudgement::certified
                                     : PageVerdict::PageJudgement::violated;
  verdict.text =
      fmt::format("judged in exact integers against the guarantee of {}, on the edges drawn{}",
                  algorithm->name, certificate.complete ? "" : "; not all violations are listed");
  return verdict;
}

void write_viewer_page(const NextDrawing& next, const std::string& path,
                       const std::string& algorithm) {
  OutputFile file(path);
  ViewerPage page([&](std::string_view text) { file.append(text); });
  std::size_t number = 0;
  while (const std::optional<PlacedLine> placed = next()) {
    ++number;
    if (const auto* drawing = std::get_if<Drawing>(&placed->line)) {
      const Algorithm* const known =
          algorithm.empty() ? known_algorithm(drawing->algorithm()) : &find_algorithm(algorithm);
      page.add(placed->where, *drawing, known == nullptr ? nullptr : &known->guarantee,
               page_verdict(*drawing, known));
    } else {
      const auto& undrawn = std::get<UndrawnGraph>(placed->line);
      page.add_undrawn(placed->where, undrawn.n, undrawn.error);
    }
  }
  if (number == 0) throw InputError("the input has no graph");
  page.finish();
  file.commit();
}

void register_program_formats() {
  register_drawing_format(
      {"html",
       {".html", ".htm"},
       "a page that shows drawings in 3D, exact coordinates included; any number per file",
       true,
       [](const NextDrawing& next, const std::string& path, const ExportOptions&) {
         write_viewer_page(next, path);
       }});
}

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
  const std::string page = arguments.output.empty() ? page_of(arguments.inputs) : arguments.output;
  if (arguments.output.empty()) refuse_other_file(page);
  refuse_unsafe_outputs({.inputs = arguments.inputs,
                         .outputs = {},
                         .page = page,
                         .page_is = kViewerMark,
                         .force = arguments.force});
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
  if (page != "-") say("wrote {}\n", page);
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
