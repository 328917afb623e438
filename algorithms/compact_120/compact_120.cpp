// Five bends per edge at 120 degrees in volume O(n^1.5): order, owners, arms, a strip, routes. Up
// to eight narrow strips, each a tenth wider than the one before, then the zones of the proof,
// which never fail (Lemma D.9). A strip whose own box (Lemma D.10) passes the theorem's is not
// tried, so the guarantee holds for every input. Cost: O(n + m) cells tried, each in O(1) expected.
#include "ar3d/algorithms/compact_120/compact_120.h"

#include "ar3d/algorithms/efforts.h"
#include "ar3d/algorithms/strips/routes.h"

namespace ar3d::compact_120 {

namespace {

constexpr std::uint64_t kZoneStream = 1000;
constexpr std::uint64_t kOrderStream = 1001;

const SizeBound& size_bound() {
  static const SizeBound bound = {"proved here",
                                  "docs/compact-120.md",
                                  {sqrt_n(580) + 13000, sqrt_n(580) + 13000, sqrt_n(725) + 16200}};
  return bound;
}

constexpr std::array<Tightness, 2> kNarrow = {
    {{.cells = 90, .rows = 110, .reach = 15, .ejections = 200},
     {.cells = 78, .rows = 112, .reach = 12, .extra_columns = 2, .ejections = 600}}};

/// @param order  of a narrow strip; null: the strip is in zones.
Drawing finished(const Graph& graph, const Strip& strip, const NarrowOrder* order,
                 const Census& census) {
  Drawing drawing = lift(graph, strip);
  const StripSize& size = strip.size();
  drawing.counters = strips::counters_of(census, order == nullptr, size.columns, size.rows);
  drawing.counters.push_back({"beyond", size.beyond});
  drawing.counters.push_back({"moved_components", order == nullptr ? 0 : order->moved_components});
  if (graph.num_vertices() > 0) drawing.instance_bound = box_of(size);
  return drawing;
}

/// In the first of some ever wider strips that can be filled, if it keeps the guarantee's box. Each
/// has an order of its own: what cannot be placed in one order may be easy in the next.
std::optional<Drawing> draw_narrow(const Graph& graph, const Tightness& first, std::uint64_t seed,
                                   Census& census) {
  NarrowOrder order;
  std::uint64_t orders = 0;
  const std::optional<Strip> strip = strips::fill_ever_wider(
      first,
      [&](const Tightness& tightness) {
        order = narrow_order(graph, strips::NumbersAhead(seed, kOrderStream + orders++));
        const StripSize size = narrow_size(order, tightness);
        return size_bound().holds(box_of(size), graph.num_vertices());
      },
      [&](const Tightness& tightness, std::uint64_t i) {
        return fill_narrow_strip(order, graph.num_edges(), tightness, strips::NumbersAhead(seed, i),
                                 census);
      },
      census);
  if (!strip) return std::nullopt;
  return finished(graph, *strip, &order, census);
}

Drawing draw_in_zones(const Graph& graph, std::uint64_t seed, Census& census) {
  const Order order = moved_order(graph);
  const Links links = assign_arms(graph, order, choose_owners(graph, order));
  const Strip strip = fill_zones(in_levels(graph, order), links, graph.num_edges(),
                                 RandomStream(seed, kZoneStream), census);
  return finished(graph, strip, nullptr, census);
}

/// @param code  the edge's arrival in two bits, then its variant.
void append_bends(unsigned code, const Point& at_tail, const Point& at_head,
                  std::vector<Point>& out) {
  const Quad tail = quad_of(site_of(at_tail));
  const Quad head = quad_of(site_of(at_head));
  const Shape shape{head[0] > tail[0], static_cast<Arrival>(code & 3), code >> 2};
  Route(shape, tail, head).append_bends(out);
}

std::vector<std::uint8_t> codes(const Graph& graph, const Strip& strip) {
  std::vector<std::uint8_t> code(graph.num_edges());
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    for (const ArmLink& link : strip.links().at[v]) {
      if (!link.is_set() || link.is_out == 0) continue;
      const unsigned variant = strip.variant()[link.edge];
      code[link.edge] =  // first ends have smaller numbers
          strips::code_of(v > link.to, variant << 2 | link.at);
    }
  }
  return code;
}

Drawing draw_alone(const Graph& graph, const Options& options) {
  return draw_from(graph, strips::first_tightness("compact-120", options.effort, kNarrow));
}

}  // namespace

Drawing draw(const Graph& graph, const Options& options) {
  return smallest_of_efforts(graph, options, draw_alone);
}

Drawing draw_from(const Graph& graph, const std::optional<Tightness>& first) {
  refuse_larger_degrees("compact-120", graph, 3);
  refuse_more_vertices("compact-120", graph, kMaxVertices);
  const std::uint64_t seed = mix_seed(graph.num_vertices(), graph.num_edges());
  Census census;
  if (first) {
    std::optional<Drawing> drawing = draw_narrow(graph, *first, seed, census);
    if (drawing) return std::move(*drawing);
  }
  return draw_in_zones(graph, seed, census);
}

Algorithm row() {
  return strips::row_of<draw>(
      "compact-120", "degree at most 3, 5 bends per edge, all angles 120 degrees, volume O(n^1.5)",
      {
          .max_degree = 3,
          .max_bends = 5,
          .angle_rule = AngleRule::exactly,
          .cosine = {-1, 2},
          .lattice = kCubeLattice,
          .directions = {{1, 1, 0}, {1, -1, 0}, {1, 0, 1}, {1, 0, -1}, {0, 1, 1}, {0, 1, -1}},
          .vertices_in_plane = false,
          .bound = size_bound(),
          .published = {},
      });
}

// Lemma D.10, and the drawing in space. The sites of the two ends and one byte per edge give the
// word and with it all five bends, so bends are computed when they are read, in O(1).

std::array<std::int64_t, 3> box_of(const StripSize& size) {
  const std::int64_t last = size.columns - 1;
  const std::int64_t across = 4 * last + 2;  // t is in 0 .. across
  const std::int64_t side = 3 * across / 2 + 4 * std::int64_t{size.rows} + size.beyond;
  return {side, side, 5 * across + 2};
}

Drawing lift(const Graph& graph, const Strip& strip) {
  const Vertex n = graph.num_vertices();
  Coordinates vertices(n, 20 * (std::int64_t{strip.size().columns} + strip.size().rows));
  for (Vertex v = 0; v < n; ++v) vertices.set(v, to_point(quad_of(strip.site(v))));
  return Drawing("compact-120", kCubeLattice, std::move(vertices), graph.shared_edges(),
                 std::make_shared<strips::CodedBends<append_bends>>(codes(graph, strip)));
}

}  // namespace ar3d::compact_120
