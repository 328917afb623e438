// The proof that a strip of O(sqrt n) columns is wide enough, as a program: a zone for each level
// of the order, with as many cells as Lemma D.9 can close and one eighth more. Random cells first,
// then all in turn, so that a place is found on every input: O(1) expected tries per vertex.
#include <algorithm>

#include "ar3d/algorithms/compact_120/fill.h"
#include "ar3d/algorithms/strips/search.h"
#include "ar3d/base/error.h"

namespace ar3d::compact_120 {
namespace {

std::int64_t quotient_up(std::int64_t a, std::int64_t b) { return (a + b - 1) / b; }

}  // namespace

std::int64_t most_closed_cells(std::int64_t n_k, std::int64_t rows) {
  const std::int64_t on_slope = quotient_up(2 * rows, 3);  // cells with one value of x0 + x1
  const std::int64_t on_steep = quotient_up(2 * rows, 5);  // cells with one value of x1
  return n_k - 1 + 3 * on_slope * rows + 2 * on_steep * rows;
}

Zones lay_out_zones(const std::vector<std::int64_t>& sizes) {
  std::int64_t n = 0;
  for (const std::int64_t n_k : sizes) n += n_k;
  const auto levels = std::max<std::int64_t>(static_cast<std::int64_t>(sizes.size()), 1);
  const std::int64_t rows = strips::square_root(2 * n / (7 * levels)) + 1;
  Zones zones;
  std::int64_t columns = 0;
  for (const std::int64_t n_k : sizes) {
    const std::int64_t cells = strips::cells_with_reserve(most_closed_cells(n_k, rows));
    if (columns > 0) columns += quotient_up(2 * rows, 3);
    zones.begin.push_back(static_cast<std::int32_t>(columns));
    zones.width.push_back(static_cast<std::int32_t>(quotient_up(cells, rows)));
    columns += zones.width.back();
  }
  zones.size = {static_cast<std::int32_t>(columns), static_cast<std::int32_t>(rows),
                static_cast<std::int32_t>(10 * columns)};
  return zones;
}

Strip fill_zones(const Order& levels, const Links& links, std::size_t num_edges,
                 RandomStream random, Census& census, bool random_trials) {
  const LongVector<std::uint16_t>& level = levels.rank;
  const Zones zones = lay_out_zones(strips::sizes_of(level));
  Strip strip(links, num_edges, zones.size, true);
  const auto rows = static_cast<std::uint32_t>(zones.size.rows);
  const int trials = random_trials ? strips::random_trials(level.size()) : 0;
  for (Vertex v = 0; v < level.size(); ++v) {
    const std::int32_t begin = zones.begin[level[v]];
    const auto accept = [&](std::uint32_t cell) {
      return strip.try_place(v, {begin + static_cast<std::int32_t>(cell / rows),
                                 static_cast<std::int32_t>(cell % rows), links.of[v]});
    };
    const std::uint32_t cells = static_cast<std::uint32_t>(zones.width[level[v]]) * rows;
    const bool placed = strips::place_in_turn(cells, trials, accept, random, census);
    expect(placed, "a zone has a cell for each of its vertices");
  }
  return strip;
}

}  // namespace ar3d::compact_120
