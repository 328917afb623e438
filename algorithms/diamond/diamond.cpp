#include "ar3d/algorithms/diamond/diamond.h"

#include <fmt/format.h>

#include "ar3d/algorithms/degree_limit.h"
#include "ar3d/algorithms/diamond/candidates.h"
#include "ar3d/algorithms/diamond/colouring.h"
#include "ar3d/algorithms/diamond/items.h"
#include "ar3d/algorithms/diamond/routes.h"
#include "ar3d/model/error.h"

namespace ar3d {
namespace {

using namespace theorem1;

void refuse_bad_graph(const Graph& graph) {
  refuse_larger_degrees("diamond", graph, 4);
  if (graph.num_vertices() > kMaxVertices) {
    throw InputError(fmt::format("diamond draws at most {} vertices, this graph has {}",
                                 kMaxVertices, graph.num_vertices()));
  }
}

Candidate choose(const Graph& graph, Items green, Items red, const DiamondOptions& options) {
  if (options.guaranteed) return guaranteed_candidate(graph, std::move(green), std::move(red));
  switch (options.effort) {
    case 0:
      return alternating_or_guaranteed(graph, std::move(green), std::move(red));
    case 1:
      return smallest_linear(graph, green, red);
    case 2:
      return smallest_annealed(graph, green, red);
    default:
      throw InputError(fmt::format("diamond has effort 0, 1 and 2, not {}", options.effort));
  }
}

}  // namespace

Drawing diamond(const Graph& graph, const DiamondOptions& options) {
  refuse_bad_graph(graph);
  auto [green, red] = [&] {
    const Slots slots = padded_slots(graph);
    const TwoColouring colours = two_colouring(graph, slots, balanced_orientation(slots));
    return std::pair{extract_items(colours.next[kGreen]), extract_items(colours.next[kRed])};
  }();
  Candidate chosen = choose(graph, std::move(green), std::move(red), options);
  expect(graph.num_vertices() == 0 || fits_theorem_box(chosen.tracks.extents, graph.num_vertices()),
         "the drawing keeps the theorem's box");
  Drawing drawing = lift(graph, chosen.placement, std::move(chosen.tracks));
  drawing.counters = std::move(chosen.counters);
  drawing.instance_bound = chosen.instance_bound;
  return drawing;
}

Algorithm diamond_row() {
  Algorithm row;
  row.name = "diamond";
  row.summary =
      "Degree at most 4, at most 3 bends an edge, all angles 109.47 degrees, diamond lattice.";
  row.source = "Theorem 1";
  row.guarantee = {
      .max_degree = 4,
      .max_bends = 3,
      .angle_rule = AngleRule::exactly,
      .cosine = {-1, 3},
      .lattice = kCubeLattice,
      .directions = {{1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {-1, 1, 1}},
      .vertices_in_plane = true,
      .bound = {"proved here", "docs/theorem1.md", {{{16, 3, 2, 0}, {16, 3, 2, 0}, {8, 1, 2, 0}}}},
      .published = {{"paper", "Theorem 1", {{{16, 3, 2, 0}, {16, 3, 2, 0}, {16, 1, 2, 0}}}}},
  };
  row.options = {
      {"effort", 0, 2, 0, "0: one linear pass; 1: the smallest of three; 2: also annealed"},
      {"guaranteed", 0, 1, 0, "1: the theorem's own mode alone, whatever the effort"},
  };
  row.draw = [](const Graph& graph, const OptionValues& values) {
    return diamond(graph, {.effort = static_cast<int>(option(values, "effort")),
                           .guaranteed = option(values, "guaranteed") != 0});
  };
  return row;
}

}  // namespace ar3d
