// Theorem 3 as the paper builds it: stages of a chordless cycle and its closure (Steps G.1 and
// G.2), each drawn as the lemma "add flat cycle" says, with the fifteen repairs of
// docs/theorem3-paper.md. It is there to be measured: the paper's order of growth is attained by
// graphs full of triangles, and `grid` gains two powers of n over it. Cost: see draw().
#include "ar3d/algorithms/grid_paper/grid_paper.h"

#include "ar3d/algorithms/grid_paper/builder.h"

namespace ar3d::grid_paper {
namespace {

/// Lemma G.5 with c cycles and l vertices on them, from skewed extents x, y and z to Cartesian
/// ones.
std::array<std::int64_t, 3> own_bound(std::int64_t n, std::int64_t c, std::int64_t l) {
  const std::int64_t x = 4 * n, y = (4 * n + 3) * n + 8 * l;
  const std::int64_t z = (4 * n * n + 11 * n + 7) * c + 2 * n;
  return {y + z, x + y, x + z};
}

}  // namespace

Drawing draw(const Graph& graph, const Options& options, const RepairSwitches& repairs) {
  refuse_larger_degrees("grid-paper", graph, 3);
  refuse_more_vertices("grid-paper", graph, kMostVertices);
  DrawingBuilder builder(graph, options, repairs);
  for (const auto& [vertices, stages] : grow(graph, options.any_cycle, repairs)) {
    builder.begin_component();
    for (const GrowthStage& stage : stages) {
      if (!stage.cycle.empty()) builder.add_cycle(stage);
      for (const Vertex u : stage.closure) builder.add_vertex(u);
    }
    builder.end_component(vertices);
  }
  Drawing drawing = builder.finish();
  if (graph.num_vertices() > 0) {
    const CaseCensus& census = builder.census();
    drawing.instance_bound = own_bound(graph.num_vertices(), census.cycles, census.on_cycles);
  }
  return drawing;
}

Algorithm row() {
  const AxisBound paper = cubic(1);
  return {.name = "grid-paper",
          .summary =
              "Theorem 3 as the paper builds it, repaired: degree at most 3, at most 3 bends per "
              "edge, all angles 120 degrees, O(n^3) x O(n^2) x O(n^3)",
          .source = "Theorem 3",
          .guarantee =
              {.max_degree = 3,
               .max_bends = 3,
               .angle_rule = AngleRule::exactly,
               .cosine = {-1, 2},
               .lattice = kCubeLattice,
               .directions = {{1, 1, 0}, {1, -1, 0}, {1, 0, 1}, {1, 0, -1}, {0, 1, 1}, {0, 1, -1}},
               .bound = {"proved here",
                         "docs/theorem3-paper.md",
                         {cubic(2) + 273, quadratic(5) + 56, cubic(2) + 50}},
               .published = {{"paper; order only, constant 1 assumed",
                              "Theorem 3",
                              {paper, paper, paper}}}},
          .options =
              {{"spread", 0, 2, 1,
                "of a flat cycle, 0: columns of their own; 1: columns where the nearest place is "
                "taken; 2: the nearest free place"},
               {"gap", 0, 1, 0, "below a cycle, 0: for any connection; 1: for those there are"},
               {"cycle", 0, 1, 0, "to draw next, 0: a shortest one; 1: the first a walk closes"}},
          .draw =
              [](const Graph& graph, const Settings& values) {
                return draw(graph, {static_cast<Spread>(value_of(values, "spread")),
                                    value_of(values, "gap") != 0, value_of(values, "cycle") != 0});
              },
          .by_name_only = true};
}

}  // namespace ar3d::grid_paper
