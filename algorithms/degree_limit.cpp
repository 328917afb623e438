#include "ar3d/algorithms/degree_limit.h"

#include <fmt/format.h>

#include "ar3d/base/error.h"

namespace ar3d {

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
