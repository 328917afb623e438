// Deep nests of figures in two-bend-paper: from which depth on misses pass limits, as the condition
// of the drawing in 237 bits predicts, and as seen.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "ar3d/algorithms/two_bend_paper/two_bend_paper.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/model/real_points.h"
#include "ar3d/verify/assessment/real_assessment.h"
#include "real_types.h"
#include "tables.h"

namespace ar3d::precision {
namespace {

using two_bend_paper::RealType;

constexpr std::array<double, 4> kLimits = {1e-9, 1e-6, 1e-2, 1};

/// The graph with a triangle in place of its vertex 0, and of a corner of that again and again. A
/// corner of a triangle that stands for a vertex of degree 3 has degree 3, so hexagons are nested;
/// one that stands for a vertex of degree 2 leaves two corners of degree 3 and a last one of degree
/// 2, in which heptagons go on. @param heptagons  levels that go on in a last corner.
Graph nest(const Graph& graph, int levels, int heptagons) {
  auto size = static_cast<Vertex>(graph.num_vertices());
  std::vector<Edge> edges(graph.edges().begin(), graph.edges().end());
  Vertex v = 0;
  for (int level = 0; level < levels; ++level) {
    const std::array<Vertex, 3> corners = {v, size, size + 1};
    size += 2;
    std::size_t next = 0;
    for (Edge& e : edges) {  // the edges at v go to the corners, one to each
      if (e.u == v || e.v == v) (e.u == v ? e.u : e.v) = corners.at(next++);
    }
    for (std::size_t i = 0; i < 3; ++i) edges.push_back({corners[i], corners[(i + 1) % 3]});
    v = corners[level < heptagons ? 2 : 0];
  }
  return {size, std::move(edges)};
}

Graph complete_graph_of_four() { return {4, {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}}; }

Graph cube() {
  std::vector<Edge> edges;
  for (Vertex v = 0; v < 8; ++v) {
    for (const Vertex axis : {1u, 2u, 4u}) {
      if ((v & axis) == 0) edges.push_back({v, v | axis});
    }
  }
  return {8, std::move(edges)};
}

/// The assessments of one nest by depth.
struct Depths {
  std::vector<double> conditions;                                       ///< in 237 bits
  std::array<std::vector<RealAssessment>, kMeasuredTypes.size()> seen;  ///< by type
};

/// @param heptagons  how many of so many levels go on in a last corner.
template <class Heptagons>
Depths depths_of(const Graph& core, int most, Heptagons&& heptagons) {
  Depths depths;
  for (int level = 0; level <= most; ++level) {
    const Graph graph = nest(core, level, heptagons(level));
    depths.conditions.push_back(
        assess(graph, two_bend_paper::draw_real(graph, RealType::reference)).condition);
    for (std::size_t t = 0; t < kMeasuredTypes.size(); ++t) {
      depths.seen[t].push_back(
          assess(graph, two_bend_paper::draw_real(graph, static_cast<RealType>(t))));
    }
  }
  return depths;
}

/// The least depth at which holds(depth).
template <class Holds>
std::string first(std::size_t count, Holds&& holds) {
  for (std::size_t depth = 0; depth < count; ++depth) {
    if (holds(depth)) return fmt::format("{}", depth);
  }
  return fmt::format("> {}", count - 1);
}

void add_rows(const std::string& name, const Depths& depths,
              std::vector<std::vector<std::string>>& rows) {
  const std::size_t count = depths.conditions.size();
  for (std::size_t t = 0; t < kMeasuredTypes.size(); ++t) {
    const auto& seen = depths.seen[t];
    for (const double limit : kLimits) {
      const auto predicted = [&](double kappa) {
        return first(count, [&](std::size_t d) {
          return predicted_miss(depths.conditions[d], kMeasuredTypes[t].bits, kappa) > limit;
        });
      };
      const std::string early = predicted(kHighKappa), late = predicted(kMedianKappa);
      const std::string at =
          first(count, [&](std::size_t d) { return seen[d].largest_miss > limit; });
      if (at == late && (at == "0" || at[0] == '>')) continue;
      rows.push_back({name, kMeasuredTypes[t].name, fmt::format("{:g}", limit),
                      early == late ? late : fmt::format("{} to {}", early, late), at});
    }
    rows.push_back({name, kMeasuredTypes[t].name, "broken", "",
                    first(count, [&](std::size_t d) { return seen[d].is_broken(); })});
  }
}

}  // namespace

void nest_table(int most) {
  const auto half = [](int levels) { return levels / 2; };
  const auto all = [](int levels) { return levels; };
  const Graph cycle(5, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {0, 4}});
  const Graph random = generate(find_family("random-cubic"), 100, 1);
  std::vector<std::vector<std::string>> rows;
  add_rows("hexagons in K4", depths_of(complete_graph_of_four(), most, all), rows);
  add_rows("hexagons in the cube", depths_of(cube(), most, all), rows);
  add_rows("hexagons in a random cubic graph, n = 100", depths_of(random, most, all), rows);
  add_rows("heptagons in C5", depths_of(cycle, most, all), rows);
  add_rows("heptagons, then as many hexagons, in C5", depths_of(cycle, most, half), rows);
  fmt::print(
      "The least depth of a nest at which a drawing misses by more than a limit, predicted with "
      "kappa from {} to {}, and seen, up to depth {}:\n\n",
      kHighKappa, kMedianKappa, most);
  print_table({"nest", "type", "degrees", "predicted", "seen"}, rows);
}

}  // namespace ar3d::precision
