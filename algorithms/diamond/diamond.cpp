// Theorem 1: colouring, items, placement, tracks, routes. The outline of docs/theorem1.md as a
// function, and the theorem as data in the catalogue's row. Efforts keep the placements of
// Steps 1.3 to 1.6 and 1.8 to 1.10 as candidates, compared by the volume of their boxes; one that
// passes the theorem's box is dropped, which the guaranteed one never does (Lemma 1.6). Cost: O(n +
// m) for each candidate, six of them at most.
#include "ar3d/algorithms/diamond/diamond.h"

#include <tuple>

#include "ar3d/algorithms/diamond/fast/fast.h"
#include "ar3d/algorithms/diamond/guaranteed.h"
#include "ar3d/algorithms/diamond/parity.h"
#include "ar3d/algorithms/diamond/routes.h"
#include "ar3d/algorithms/efforts.h"
#include "ar3d/base/error.h"
#include "ar3d/base/parallel.h"

namespace ar3d::diamond {
namespace {

constexpr int kHighestEffort = 2;

// Values of the counter `mode`.
constexpr std::int64_t kGuaranteed = 0, kAlternating = 1, kPairs = 2, kJoint = 3, kAnnealed = 4;

struct ModeCandidate {
  Placement placement;
  Tracks tracks;
  std::vector<Counter> counters;
  std::optional<std::array<std::int64_t, 3>> instance_bound;
};

/// Extents are below 2^32.
Volume volume(const ModeCandidate& candidate) { return volume_of(candidate.tracks.extents); }

std::optional<ModeCandidate> parity_candidate(
    const Graph& graph, std::int64_t mode,
    std::optional<std::pair<Placement, std::int64_t>> placed) {
  if (!placed) return std::nullopt;
  ModeCandidate result;
  result.placement = std::move(placed->first);
  result.tracks = choose_tracks(graph, result.placement);
  if (!fits_theorem_box(result.tracks.extents, graph.num_vertices())) return std::nullopt;
  result.counters = {{"mode", mode},
                     {"m_green", count_cycles(result.placement.green)},
                     {"m_red", count_cycles(result.placement.red)},
                     {"hits", placed->second}};
  return result;
}

/// Alternating parity; nothing if it passes the theorem's box.
std::optional<ModeCandidate> alternating(const Graph& graph, Items green, Items red,
                                         std::int64_t mode) {
  return parity_candidate(graph, mode, place_alternating(graph, std::move(green), std::move(red)));
}

bool fits(const std::array<std::int64_t, 3>& extents, const std::array<std::int64_t, 3>& bound) {
  return extents[0] <= bound[0] && extents[1] <= bound[1] && extents[2] <= bound[2];
}

/// The box that the guaranteed mode proves for this very graph stays with a smaller candidate that
/// keeps it, and so does its H.
void keep_smaller(ModeCandidate& best, std::optional<ModeCandidate> other) {
  if (!other || volume(*other) >= volume(best)) return;
  if (best.instance_bound && fits(other->tracks.extents, *best.instance_bound)) {
    other->instance_bound = best.instance_bound;
    other->counters.push_back(best.counters.back());
  }
  best = std::move(*other);
}

/// Always fits the theorem's box (n >= 1).
ModeCandidate guaranteed_candidate(const Graph& graph, Items green, Items red) {
  ModeCandidate result;
  GapCount gaps;
  std::tie(result.placement, gaps) = place_guaranteed(graph, std::move(green), std::move(red));
  result.tracks = choose_tracks(graph, result.placement);
  result.counters = {{"mode", kGuaranteed},       {"m_green", gaps.m_green},
                     {"m_red", gaps.m_red},       {"contained", gaps.contained},
                     {"rho", gaps.rho},           {"green_gaps", gaps.green_gaps},
                     {"red_gaps", gaps.red_gaps}, {"bumps", gaps.bumps},
                     {"offsets", gaps.offsets},   {"H", gaps.H()}};
  if (graph.num_vertices() >= 2) {
    const std::int64_t n = graph.num_vertices();
    const std::int64_t side = 4 * n + 2 * gaps.H();
    result.instance_bound = {side, side, 6 * n + 3 * gaps.H() - 4};
  }
  return result;
}

/// The candidate of least volume among the guaranteed mode, alternating parity, pairs, joint
/// rotation, and annealed parity with and without it.
ModeCandidate smallest(const Graph& graph, const Items& green, const Items& red) {
  ModeCandidate best = guaranteed_candidate(graph, green, red);
  keep_smaller(best, alternating(graph, green, red, kAlternating));
  keep_smaller(best, parity_candidate(graph, kPairs, place_in_pairs(graph, green, red)));
  const auto anneal = [&](const Items& g, const Items& r) {
    keep_smaller(best, parity_candidate(graph, kAnnealed,
                                        place_by_parity(graph, g, r, annealed_parity(g, r))));
  };
  anneal(green, red);
  Items rotated_green = green;
  Items rotated_red = red;
  if (rotate_jointly(rotated_green, rotated_red)) {
    keep_smaller(best, alternating(graph, rotated_green, rotated_red, kJoint));
    anneal(rotated_green, rotated_red);
  }
  return best;
}

/// The green and the red items.
std::pair<Items, Items> items_of(const Graph& graph) {
  TwoColouring colours = fast::colouring(graph);
  std::pair<Items, Items> items;
  const auto extract = [&](Colour c) {
    const std::vector<HalfEdge> next = std::move(colours[c]);  // not beyond this
    (c == kGreen ? items.first : items.second) = fast::items(next);
  };
  for_each_in_threads(threads_for(graph.num_vertices()), 2,
                      [&](std::uint32_t, std::size_t i) { extract(i == 0 ? kGreen : kRed); });
  return items;
}

ModeCandidate choose(const Graph& graph, int effort) {
  auto [green, red] = items_of(graph);
  if (effort == 2) return smallest(graph, green, red);
  if (effort == 1) {
    auto compact = alternating(graph, std::move(green), std::move(red), kAlternating);
    if (compact && graph.num_vertices() > kMostCompared) return std::move(*compact);
    std::tie(green, red) = items_of(graph);  // found again rather than kept: large graphs end here
    ModeCandidate guaranteed = guaranteed_candidate(graph, std::move(green), std::move(red));
    if (compact && volume(*compact) <= volume(guaranteed)) return std::move(*compact);
    return guaranteed;
  }
  return guaranteed_candidate(graph, std::move(green), std::move(red));
}

}  // namespace

Drawing draw(const Graph& graph, const Options& options) {
  check_effort("diamond", options.effort, kHighestEffort);
  refuse_larger_degrees("diamond", graph, 4);
  refuse_more_vertices("diamond", graph, kMaxVertices);
  ModeCandidate chosen = choose(graph, options.effort);
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
  row.draw = draw_with_effort<draw>;
  return row;
}

}  // namespace ar3d::diamond
