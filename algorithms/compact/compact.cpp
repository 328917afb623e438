// Five bends per edge in volume O(n^1.5): decomposition, a strip, routes. Up to eight narrow
// strips, each a tenth wider than the one before, then the zones of the proof, which never fail
// (Lemma C.7). A strip whose own box (Lemma C.6) passes the theorem's is not tried, so the
// guarantee holds for every input. Cost: O(n + m) cells tried, each in O(1) expected.
#include "ar3d/algorithms/compact/compact.h"

#include "ar3d/algorithms/efforts.h"
#include "ar3d/algorithms/strips/routes.h"

namespace ar3d::compact {

namespace {

constexpr std::uint64_t kZoneStream = 1000;

const SizeBound& size_bound() {
  static const SizeBound bound = {"proved here",
                                  "docs/compact.md",
                                  {sqrt_n(726) + 1800, sqrt_n(726) + 1800, sqrt_n(724) + 1800}};
  return bound;
}

constexpr std::array<Tightness, 2> kNarrow = {
    {{}, {.cells = 95, .rows = 107, .reach = 57, .extra_columns = 2, .ejections = 200}}};

/// The first of some ever wider strips that can be filled, if it keeps the guarantee's box.
std::optional<Placement> fill_some_narrow_strip(const Graph& graph, const Decomposition& links,
                                                Tightness first, std::uint64_t seed,
                                                Census& census) {
  return strips::fill_ever_wider(
      first,
      [&](const Tightness& tightness) {
        const StripSize size = narrow_size(graph.num_vertices(), tightness);
        return size_bound().holds(box_of(size), graph.num_vertices());
      },
      [&](const Tightness& tightness, std::uint64_t i) {
        return fill_narrow_strip(links, graph.num_edges(), tightness, seed, i, census);
      },
      census);
}

/// @param code  whether the edge is red, and from bit 1 on its variant.
void append_bends(unsigned code, const Point& at_tail, const Point& at_head,
                  std::vector<Point>& out) {
  const Site tail = site_of(at_tail);
  const Site head = site_of(at_head);
  const Word word =
      word_of({(code & 1) != 0, tail.type, head.type, head.column > tail.column, code >> 1});
  const Letters from = letters_of(tail);
  append_bends_of(word, from, long_lengths(word, from, letters_of(head)), out);
}

std::vector<std::uint8_t> codes(const Graph& graph, const Decomposition& links,
                                const Placement& placement) {
  std::vector<std::uint8_t> code(graph.num_edges());
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    for (const ColourRole role : {kGreenOut, kRedOut}) {
      const HalfEdge edge = links.at[v][role];
      if (edge.to == kNobody) continue;
      const unsigned variant = placement.variant[edge.edge];
      code[edge.edge] =  // first ends have smaller numbers
          strips::code_of(v > edge.to, variant << 1 | (is_red(role) ? 1u : 0u));
    }
  }
  return code;
}

Drawing draw_alone(const Graph& graph, const Options& options) {
  return draw_from(graph, strips::first_tightness("compact", options.effort, kNarrow));
}

}  // namespace

Drawing draw(const Graph& graph, const Options& options) {
  return smallest_of_efforts(graph, options, draw_alone);
}

Drawing draw_from(const Graph& graph, const std::optional<Tightness>& first) {
  refuse_larger_degrees("compact", graph, 4);
  refuse_more_vertices("compact", graph, kMaxVertices);
  const Decomposition links = decompose(graph);
  const std::uint64_t seed = mix_seed(graph.num_vertices(), graph.num_edges());
  Census census;
  std::optional<Placement> strip;
  if (first) strip = fill_some_narrow_strip(graph, links, *first, seed, census);
  const bool zones = !strip;
  if (zones) strip = fill_zones(graph, links, RandomStream(seed, kZoneStream), census);
  Drawing drawing = lift(graph, links, *strip);
  const StripSize& size = strip->size;
  drawing.counters = strips::counters_of(census, zones, size.columns, size.rows);
  drawing.counters.push_back({"reach", size.reach});
  if (graph.num_vertices() > 0) drawing.instance_bound = box_of(size);
  return drawing;
}

Algorithm row() {
  return strips::row_of<draw>(
      "compact", "degree at most 4, 5 bends per edge, all angles 109.47 degrees, volume O(n^1.5)",
      {
          .max_degree = 4,
          .max_bends = 5,
          .angle_rule = AngleRule::exactly,
          .cosine = {-1, 3},
          .lattice = kCubeLattice,
          .directions = {{1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {-1, 1, 1}},
          .vertices_in_plane = true,
          .bound = size_bound(),
          .published = {},
      });
}

// Lemma C.6, and the drawing in space. The sites of the two ends and one byte per edge give the
// word and with it all five bends, so bends are computed when they are read, in O(1).

std::array<std::int64_t, 3> box_of(const StripSize& size) {
  // U stays within 4 of the vertices' range 0 .. 4 columns - 2, and V within span/2 + 2 of -2 .. 4
  // rows - 4. Green edges rise at most span + 6, red ones fall at most span + 4 (Lemma C.6).
  const std::int64_t span = 4 * std::int64_t{std::min(size.reach, size.columns - 1)} + 2;
  const std::int64_t side = 4 * (std::int64_t{size.columns} + size.rows) + span + 8;
  return {side, side, 2 * span + 10};
}

Drawing lift(const Graph& graph, const Decomposition& links, const Placement& placement) {
  const Vertex n = graph.num_vertices();
  Coordinates vertices(n, 4 * (std::int64_t{placement.size.columns} + placement.size.rows) + 4);
  for (Vertex v = 0; v < n; ++v) vertices.set(v, to_point(placement.places[v]));
  return Drawing(
      "compact", kCubeLattice, std::move(vertices), graph.shared_edges(),
      std::make_shared<strips::CodedBends<append_bends>>(codes(graph, links, placement)));
}

}  // namespace ar3d::compact
