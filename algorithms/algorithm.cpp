// What all algorithms do alike before they draw: complete their options, and refuse efforts, degrees
// and numbers of vertices that their proofs do not cover. It stands apart from the catalogue, so
// that no algorithm knows of the others.
#include "ar3d/algorithms/algorithm.h"

#include <fmt/format.h>

#include "ar3d/base/error.h"

namespace ar3d {

Settings complete_options(const Algorithm& algorithm, const Settings& given) {
  return complete_settings(fmt::format("algorithm {}", algorithm.name), "option", algorithm.options,
                           given);
}

Drawing draw(const Algorithm& algorithm, const Graph& graph, const Settings& given) {
  refuse_larger_degrees(algorithm.name, graph, algorithm.guarantee.max_degree);
  return algorithm.draw(graph, complete_options(algorithm, given));
}

SettingSpec effort_option(int highest, std::string_view description) {
  return {"effort", 0, highest, kDefaultEffort, std::string(description)};
}

void check_effort(std::string_view algorithm, int effort, int highest) {
  if (effort >= 0 && effort <= highest) return;
  throw InputError(fmt::format("{} has efforts 0 to {}, not {}", algorithm, highest, effort));
}

void refuse_larger_degrees(std::string_view algorithm, const Graph& graph, std::uint32_t limit) {
  if (graph.max_degree() <= limit) return;
  Vertex v = 0;
  while (graph.degree(v) <= limit) ++v;
  throw InputError(fmt::format(
      "{} draws graphs of maximum degree {}, but vertex {} has degree {} (vertices count from 0)",
      algorithm, limit, v, graph.degree(v)));
}

void refuse_more_vertices(std::string_view algorithm, const Graph& graph, std::uint32_t limit) {
  if (graph.num_vertices() <= limit) return;
  throw InputError(fmt::format("{} draws at most {} vertices, this graph has {}", algorithm, limit,
                               graph.num_vertices()));
}

}  // namespace ar3d
