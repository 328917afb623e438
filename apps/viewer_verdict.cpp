// What a page says of the drawings that it shows, and whose guarantee they are judged by.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/error.h"
#include "ar3d/verify/certificate.h"
#include "view.h"

namespace ar3d {

Graph claimed_graph(const Drawing& drawing) {
  std::vector<Edge> edges;
  edges.reserve(drawing.num_edges());
  for (EdgeId e = 0; e < drawing.num_edges(); ++e) edges.push_back(drawing.edge(e));
  return Graph(drawing.num_vertices(), std::move(edges));
}

const Algorithm* known_algorithm(const std::string& name) {
  const auto found = std::ranges::find(algorithms(), name, &Algorithm::name);
  return found == algorithms().end() ? nullptr : &*found;
}

PageVerdict page_verdict(const Drawing& drawing, const Algorithm* algorithm, const Graph* given) {
  PageVerdict verdict;
  if (algorithm == nullptr) {
    verdict.text = "no guarantee is known of this algorithm";
    return verdict;
  }
  std::optional<Graph> graph;
  try {
    if (given == nullptr) given = &graph.emplace(claimed_graph(drawing));
  } catch (const InputError&) {
    verdict.text = "the edges are not those of a simple graph";
    return verdict;
  }
  const Certificate certificate = certify(*given, drawing, algorithm->guarantee);
  for (const Violation& violation : certificate.violations) {
    verdict.violations.push_back({to_string(violation.kind), violation.message, violation.vertices,
                                  violation.edges, violation.points});
  }
  if (certificate.measured && !certificate.violated()) {
    verdict.text = "made in a real type, so nothing is proved; ar3d verify measures what it misses";
    return verdict;
  }
  verdict.kind = certificate.valid() ? "certified" : "violated";
  verdict.text = fmt::format("judged in exact integers against the guarantee of {}, on the {}{}",
                             algorithm->name, graph ? "edges drawn" : "graph given",
                             certificate.complete ? "" : "; not all violations are listed");
  return verdict;
}

}  // namespace ar3d
