// Theorem 1: colouring, items, placement, tracks, routes. The outline of docs/theorem1.md as a
// function, the theorem as data in the catalogue's row, and the refusals of the public entry. Cost:
// O(n + m).
#include "ar3d/algorithms/diamond/diamond.h"

#include <tuple>
#include <utility>

#include "ar3d/algorithms/degree_limit.h"
#include "ar3d/algorithms/diamond/candidates.h"
#include "ar3d/algorithms/diamond/in_threads.h"
#include "ar3d/algorithms/diamond/interleaved.h"
#include "ar3d/algorithms/diamond/routes.h"
#include "ar3d/base/error.h"

namespace ar3d::diamond {
namespace {

constexpr int kHighestEffort = 2;

void refuse_bad_input(const Graph& graph, const Options& options) {
  check_effort("diamond", options.effort, kHighestEffort);
  refuse_larger_degrees("diamond", graph, 4);
  refuse_more_vertices("diamond", graph, kMaxVertices);
}

/// The green and the red items.
std::pair<Items, Items> items_of(const Graph& graph) {
  TwoColouring colours = colouring_of(graph);
  const bool many = graph.num_vertices() >= kManyInItems;
  std::pair<Items, Items> items;
  const auto extract = [&](Colour c) {
    const std::vector<HalfEdge> next = std::move(colours.next[c]);  // not beyond this
    (c == kGreen ? items.first : items.second) =
        many ? interleaved_items(next, walk_sizes(next.size())) : extract_items(next);
  };
  in_two_threads(
      graph.num_vertices(), [&] { extract(kGreen); }, [&] { extract(kRed); });
  return items;
}

Candidate choose(const Graph& graph, int effort) {
  auto [green, red] = items_of(graph);
  if (effort == 2) return smallest(graph, green, red);
  if (effort == 1) {
    auto compact = alternating_candidate(graph, std::move(green), std::move(red));
    if (compact) return std::move(*compact);
    std::tie(green, red) = items_of(graph);  // found again rather than kept: no input needed them
  }
  return guaranteed_candidate(graph, std::move(green), std::move(red));
}

}  // namespace

Drawing draw(const Graph& graph, const Options& options) {
  refuse_bad_input(graph, options);
  Candidate chosen = choose(graph, options.effort);
  expect(graph.num_vertices() == 0 || fits_theorem_box(chosen.tracks.extents, graph.num_vertices()),
         "the drawing keeps the theorem's box");
  chosen.placement.green = chosen.placement.red = {};  // what follows needs the places alone
  Drawing drawing = lift(graph, chosen.placement, std::move(chosen.tracks));
  drawing.counters = std::move(chosen.counters);
  drawing.instance_bound = chosen.instance_bound;
  return drawing;
}

Algorithm row() {
  Algorithm row;
  row.name = "diamond";
  row.summary =
      "degree at most 4, at most 3 bends per edge, all angles 109.47 degrees, diamond lattice";
  row.source = "Theorem 1";
  row.guarantee = {
      .max_degree = 4,
      .max_bends = 3,
      .angle_rule = AngleRule::exactly,
      .cosine = {-1, 3},
      .lattice = kCubeLattice,
      .directions = {{1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {-1, 1, 1}},
      .vertices_in_plane = true,
      .bound = {"proved here", "docs/theorem1.md", {linear(16, 3), linear(16, 3), linear(8)}},
      .published = {{"paper", "Theorem 1", {linear(16, 3), linear(16, 3), linear(16)}}},
  };
  row.options = {effort_option(
      kHighestEffort,
      "0: the proof's construction; 1: one linear pass; 2: the smallest of many, also annealed")};
  row.draw = [](const Graph& graph, const Settings& values) {
    return draw(graph, {.effort = static_cast<int>(value_of(values, "effort"))});
  };
  return row;
}

}  // namespace ar3d::diamond
