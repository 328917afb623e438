// Smallest boxes that are known: the closed rows of results/reference/optima.csv, found again under
// any labels by the least name of the graph, which is the least number whose bits are the edges of a
// relabelled copy.
#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "ar3d/verify/metrics/volume_bound.h"
#include "ar3d_known_optima.h"

namespace ar3d {
namespace {

constexpr std::uint32_t kMostNamed = 7;  // vertices

/// Bit v (v - 1) / 2 + u is the edge uv with u < v, as in graph6.
std::uint32_t least_name(std::uint32_t n, const std::vector<Edge>& edges) {
  std::array<Vertex, kMostNamed> names{};
  std::iota(names.begin(), names.end(), 0);
  std::uint32_t least = ~0u;
  do {
    std::uint32_t bits = 0;
    for (const Edge& edge : edges) {
      const auto [u, v] = std::minmax(names[edge.u], names[edge.v]);
      bits |= 1u << (v * (v - 1) / 2 + u);
    }
    least = std::min(least, bits);
  } while (std::next_permutation(names.begin(), names.begin() + n));
  return least;
}

/// Steps, most bends, vertices, least name.
using OptimumKey = std::tuple<DrawnSteps, std::uint32_t, std::uint32_t, std::uint32_t>;

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

std::map<OptimumKey, std::int64_t> read_known_optima() {
  std::map<OptimumKey, std::int64_t> all;
  std::istringstream lines(kKnownOptima);
  std::string line;
  for (std::getline(lines, line); std::getline(lines, line);) {  // without the head
    std::istringstream text(line);
    std::array<std::string, 10> cells;  // from set to volume
    for (std::string& cell : cells) std::getline(text, cell, ',');
    const auto n = static_cast<std::uint32_t>(cells[1].at(0) - 63);
    if (n > kMostNamed || cells[7] != "0" || cells[8] != cells[9]) continue;
    const DrawnSteps steps =
        cells[5] == "120" ? DrawnSteps::face_diagonals : DrawnSteps::body_diagonals;
    const auto bends = static_cast<std::uint32_t>(std::stoul(cells[6]));
    all[{steps, bends, n, least_name(n, edges_of_graph6(cells[1]))}] = std::stoll(cells[9]);
  }
  return all;
}

}  // namespace

std::int64_t known_optimum(const Graph& graph, const Guarantee& guarantee) {
  static const std::map<OptimumKey, std::int64_t> known = read_known_optima();
  const DrawnSteps steps = steps_of(guarantee);
  const std::uint32_t n = graph.num_vertices();
  if (n < 2 || n > kMostNamed || steps == DrawnSteps::any) return -1;
  const auto of_n = known.lower_bound({steps, guarantee.max_bends, n, 0});
  if (of_n == known.end() || std::get<2>(of_n->first) != n) return -1;  // a name costs n! steps
  const auto found =
      known.find({steps, guarantee.max_bends, n, least_name(n, *graph.shared_edges())});
  return found == known.end() ? -1 : found->second;
}

}  // namespace ar3d
