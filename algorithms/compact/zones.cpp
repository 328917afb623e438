// The proof that a strip of O(sqrt n) columns is wide enough, as a program: a zone for each colour
// of a greedy vertex colouring, with as many cells as Lemma C.7 can close and one eighth more.
// Random cells first, then all in turn, so that a place is found on every input: O(1) expected
// tries per vertex.
#include <bit>

#include "ar3d/algorithms/compact/fill.h"
#include "ar3d/algorithms/strips/search.h"
#include "ar3d/base/error.h"

namespace ar3d::compact {

std::vector<std::uint8_t> greedy_colours(const Graph& graph) {
  std::vector<std::uint8_t> colours(graph.num_vertices());
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    unsigned used = 0;
    for (const HalfEdge& edge : graph.incident(v)) {
      if (edge.to < v) used |= 1u << colours[edge.to];
    }
    colours[v] = static_cast<std::uint8_t>(std::countr_one(used));
  }
  return colours;
}

std::int64_t most_closed_cells(std::int64_t n_k, std::int64_t n, std::int64_t rows,
                               std::int64_t cap) {
  return n_k - 1 + n                          // cells taken, arrival lines on stored lines
         + (rows + 1) * (2 * rows + cap + 1)  // green in-edge and red out-edge: stored lines
         + 2 * (rows + 1) * rows              // green out-edge and red in-edge: stored lines
         + (n / cap) * (3 * rows + 1);        // values closed by the cap rule
}

Zones lay_out_zones(const std::vector<std::int64_t>& sizes) {
  std::int64_t n = 0;
  for (const std::int64_t n_k : sizes) n += n_k;
  const std::int64_t rows = strips::square_root(27 * n / 100) + 1;
  const std::int64_t cap = strips::square_root(3 * n) + 1;
  Zones zones;
  std::int64_t columns = 0;
  for (const std::int64_t n_k : sizes) {
    const std::int64_t closed = most_closed_cells(n_k, n, rows, cap);
    const std::int64_t cells = strips::cells_with_reserve(closed);
    const std::int64_t width = 2 * ((cells + rows - 1) / rows);
    if (columns > 0) columns += rows + 3;
    zones.begin.push_back(static_cast<std::int32_t>(columns));
    zones.width.push_back(static_cast<std::int32_t>(width));
    columns += width;
  }
  zones.size = {static_cast<std::int32_t>(columns), static_cast<std::int32_t>(rows),
                static_cast<std::int32_t>(columns)};
  zones.cap = static_cast<std::int32_t>(cap);
  return zones;
}

Placement fill_zones(const Graph& graph, const Decomposition& links, RandomStream random,
                     Census& census, bool random_trials) {
  const Vertex n = graph.num_vertices();
  const std::vector<std::uint8_t> colours = greedy_colours(graph);
  const Zones zones = lay_out_zones(strips::sizes_of(colours));
  Strip strip(links, graph.num_edges(), zones.size, zones.cap);
  const auto rows = static_cast<std::uint32_t>(zones.size.rows);
  const int trials = random_trials ? strips::random_trials(n) : 0;
  for (Vertex v = 0; v < n; ++v) {
    const Vertex head = links.at[v][kGreenOut].to;
    const std::int32_t type = head != kNobody && colours[head] < colours[v] ? 1 : 0;
    const std::int32_t begin = zones.begin[colours[v]];
    const auto accept = [&](std::uint32_t cell) {
      const auto row = static_cast<std::int32_t>(cell % rows);
      const auto pair = static_cast<std::int32_t>(cell / rows);
      return strip.try_place(v, {begin + 2 * pair + ((begin ^ row) & 1), row, type});
    };
    const std::uint32_t cells = static_cast<std::uint32_t>(zones.width[colours[v]]) / 2 * rows;
    const bool placed = strips::place_in_turn(cells, trials, accept, random, census);
    expect(placed, "a zone has a cell for each of its vertices");
  }
  return strip.placement();
}

}  // namespace ar3d::compact
