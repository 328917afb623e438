#include "ar3d/generators/shuffled_labels.h"

#include <numeric>
#include <span>
#include <vector>

namespace ar3d {

Graph shuffled_labels(const Graph& graph, RandomStream& random) {
  std::vector<Vertex> names(graph.num_vertices());
  std::iota(names.begin(), names.end(), Vertex{0});
  random.shuffle(std::span<Vertex>(names));
  return relabelled(graph, names);
}

}  // namespace ar3d
