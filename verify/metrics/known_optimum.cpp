// Smallest boxes that are known: the closed rows of results/reference/optima.csv, found again under
// any labels.
#include <array>
#include <numeric>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "ar3d/model/isomorphism.h"
#include "ar3d/verify/metrics/volume_bound.h"
#include "ar3d_known_optima.h"

namespace ar3d {
namespace {

constexpr std::uint32_t kMostKnown = 7;

/// Steps, most bends, graph, volume.
using KnownOptimum = std::tuple<DrawnSteps, std::uint32_t, Graph, std::int64_t>;

std::vector<Edge> edges_of_graph6(const std::string& word) {
  std::vector<Edge> edges;
  const auto n = static_cast<std::uint32_t>(word[0] - 63);
  for (Vertex v = 1, i = 0; v < n; ++v) {
    for (Vertex u = 0; u < v; ++u, ++i) {
      if (((word[1 + i / 6] - 63) >> (5 - i % 6) & 1) != 0) edges.push_back({u, v});
    }
  }
  return edges;
}

std::vector<KnownOptimum> read_known_optima() {
  std::vector<KnownOptimum> all;
  std::istringstream lines(kKnownOptima);
  std::string line;
  for (std::getline(lines, line); std::getline(lines, line);) {  // without the head
    std::istringstream text(line);
    std::array<std::string, 10> cells;  // from set to volume
    for (std::string& cell : cells) std::getline(text, cell, ',');
    const auto n = static_cast<std::uint32_t>(cells[1].at(0) - 63);
    if (n > kMostKnown || cells[7] != "0" || cells[8] != cells[9]) continue;
    const DrawnSteps steps =
        cells[5] == "120" ? DrawnSteps::face_diagonals : DrawnSteps::body_diagonals;
    all.emplace_back(steps, std::stoul(cells[6]), Graph(n, edges_of_graph6(cells[1])),
                     std::stoll(cells[9]));
  }
  return all;
}

}  // namespace

std::int64_t known_optimum(const Graph& graph, const Guarantee& guarantee) {
  static const std::vector<KnownOptimum> known = read_known_optima();
  const DrawnSteps steps = steps_of(guarantee);
  if (graph.num_vertices() < 2 || graph.num_vertices() > kMostKnown) return -1;
  std::vector<Vertex> order(graph.num_vertices());
  std::iota(order.begin(), order.end(), 0);
  for (const auto& [of, bends, drawn, volume] : known) {
    if (of != steps || bends != guarantee.max_bends) continue;
    if (find_isomorphism(graph, drawn, order)) return volume;
  }
  return -1;
}

}  // namespace ar3d
