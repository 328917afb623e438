// What each effort keeps: the placements of Steps 1.3 to 1.6 and 1.8 to 1.10 as candidates,
// compared by the volume of their boxes. A candidate that passes the theorem's box is dropped; the
// guaranteed one never does (Lemma 1.6). O(n) for each candidate, six of them at most.
#include "ar3d/algorithms/diamond/candidates.h"

#include <utility>

#include "ar3d/algorithms/diamond/anneal.h"
#include "ar3d/algorithms/diamond/guaranteed.h"
#include "ar3d/algorithms/diamond/joint_rotation.h"
#include "ar3d/algorithms/diamond/parity_placement.h"

namespace ar3d::diamond {
namespace {

__extension__ using Volume = unsigned __int128;

/// Number of grid points in the box; extents are below 2^32, so it is below 2^97.
Volume volume(const Candidate& candidate) {
  Volume product = 1;
  for (const std::int64_t extent : candidate.tracks.extents)
    product *= static_cast<Volume>(extent + 1);
  return product;
}

std::optional<Candidate> parity_candidate(const Graph& graph, Mode mode,
                                          std::optional<ParityPlacement> placed) {
  if (!placed) return std::nullopt;
  Candidate result;
  result.placement = std::move(placed->placement);
  result.tracks = choose_tracks(graph, result.placement);
  if (!fits_theorem_box(result.tracks.extents, graph.num_vertices())) return std::nullopt;
  result.counters = {{"mode", static_cast<std::int64_t>(mode)},
                     {"m_green", count_cycles(result.placement.green)},
                     {"m_red", count_cycles(result.placement.red)},
                     {"hits", placed->hits}};
  return result;
}

std::optional<Candidate> alternating(const Graph& graph, Items green, Items red, Mode mode) {
  return parity_candidate(
      graph, mode,
      place_by_parity(graph, std::move(green), std::move(red), ParityPattern::alternating));
}

bool fits(const std::array<std::int64_t, 3>& extents, const std::array<std::int64_t, 3>& bound) {
  return extents[0] <= bound[0] && extents[1] <= bound[1] && extents[2] <= bound[2];
}

/// The box that the guaranteed mode proves for this very graph stays with a smaller candidate that
/// keeps it, and so does its H.
void keep_smaller(Candidate& best, std::optional<Candidate> other) {
  if (!other || volume(*other) >= volume(best)) return;
  if (best.instance_bound && fits(other->tracks.extents, *best.instance_bound)) {
    other->instance_bound = best.instance_bound;
    other->counters.push_back(best.counters.back());
  }
  best = std::move(*other);
}

}  // namespace

bool fits_theorem_box(const std::array<std::int64_t, 3>& extents, std::uint64_t n) {
  const auto size = static_cast<std::int64_t>(n);
  return 3 * extents[0] <= 16 * size && 3 * extents[1] <= 16 * size && extents[2] <= 8 * size;
}

Candidate guaranteed_candidate(const Graph& graph, Items green, Items red) {
  GuaranteedPlacement placed = place_guaranteed(graph, std::move(green), std::move(red));
  const GapCount& gaps = placed.gaps;
  Candidate result;
  result.placement = std::move(placed.placement);
  result.tracks = choose_tracks(graph, result.placement);
  result.counters = {{"mode", static_cast<std::int64_t>(Mode::guaranteed)},
                     {"m_green", gaps.m_green},
                     {"m_red", gaps.m_red},
                     {"contained", gaps.contained},
                     {"rho", gaps.rho},
                     {"green_gaps", gaps.green_gaps},
                     {"red_gaps", gaps.red_gaps},
                     {"bumps", gaps.bumps},
                     {"offsets", gaps.offsets},
                     {"H", gaps.H()}};
  if (graph.num_vertices() >= 2) {
    const std::int64_t n = graph.num_vertices();
    const std::int64_t side = 4 * n + 2 * gaps.H();
    result.instance_bound = {side, side, 6 * n + 3 * gaps.H() - 4};
  }
  return result;
}

std::optional<Candidate> alternating_candidate(const Graph& graph, Items green, Items red) {
  return alternating(graph, std::move(green), std::move(red), Mode::alternating);
}

Candidate smallest(const Graph& graph, const Items& green, const Items& red) {
  Candidate best = guaranteed_candidate(graph, green, red);
  keep_smaller(best, alternating(graph, green, red, Mode::alternating));
  keep_smaller(best, parity_candidate(graph, Mode::pairs,
                                      place_by_parity(graph, green, red, ParityPattern::pairs)));
  const auto anneal = [&](const Items& g, const Items& r) {
    keep_smaller(best, parity_candidate(graph, Mode::annealed,
                                        place_by_parity(graph, g, r, annealed_parity(g, r))));
  };
  anneal(green, red);
  Items rotated_green = green;
  Items rotated_red = red;
  if (rotate_jointly(rotated_green, rotated_red)) {
    keep_smaller(best, alternating(graph, rotated_green, rotated_red, Mode::joint));
    anneal(rotated_green, rotated_red);
  }
  return best;
}

}  // namespace ar3d::diamond
