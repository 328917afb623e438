// Pages that show drawings in 3D and judge what they show: a format of drawings for program and
// Python package.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/error.h"
#include "ar3d/formats/text/output.h"
#include "ar3d/verify/certificate.h"
#include "batches.h"
#include "view.h"

namespace ar3d {
Graph claimed_graph(const Drawing& drawing) {
  std::vector<Edge> edges;
  edges.reserve(drawing.num_edges());
  for (EdgeId e = 0; e < drawing.num_edges(); ++e) edges.push_back(drawing.edge(e));
  return Graph(drawing.num_vertices(), std::move(edges));
}

std::uint64_t weight_of(const DrawingJsonlReader::Line& line) {
  const auto* drawing = std::get_if<Drawing>(&line);
  return drawing == nullptr ? 0 : std::uint64_t{drawing->num_vertices()} + drawing->num_edges();
}

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
  bool is_empty = true;
  const auto entry_of = [&](const PlacedLine& placed) {
    if (const auto* undrawn = std::get_if<UndrawnGraph>(&placed.line)) {
      return page_entry(placed.where, undrawn->n, undrawn->error);
    }
    const auto& drawing = std::get<Drawing>(placed.line);
    const Algorithm* const known =
        algorithm.empty() ? known_algorithm(drawing.algorithm()) : &find_algorithm(algorithm);
    return page_entry(placed.where, drawing, known == nullptr ? nullptr : &known->guarantee,
                      page_verdict(drawing, known));
  };
  in_batches<PlacedLine>(
      next, [](const PlacedLine& placed) { return weight_of(placed.line); }, entry_of,
      [&](const PageEntry& entry) {
        is_empty = false;
        page.add(entry);
      });
  if (is_empty) throw InputError("the input has no graph");
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

}  // namespace ar3d
