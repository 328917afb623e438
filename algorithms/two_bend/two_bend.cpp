// Theorem 2, component by component: Steps 2.1 to 2.11 of docs/theorem2.md in their order. Not the
// paper's construction (contract triangles, seek chordless cycles), which has no grid and no volume
// bound: slabs along an st-order keep all coordinates polynomial. The result of the ordinary rounds
// is compared with a box and, where it breaks it, replaced by the layout whose box is proved. Cost:
// O(n) plus greatest common divisors.
#include "ar3d/algorithms/two_bend/two_bend.h"

#include "ar3d/algorithms/efforts.h"
#include "ar3d/algorithms/two_bend/layout.h"
#include "ar3d/algorithms/two_bend/lists.h"
#include "ar3d/algorithms/two_bend/slab.h"
#include "ar3d/algorithms/two_bend/time_order.h"

namespace ar3d::two_bend {
namespace {

constexpr int kHighestEffort = 1;

// Up to this many vertices no check of integer widths can fail: the promised box fits, and so does
// whatever ten ordinary rounds can widen a list to (Lemma 2.18).
constexpr std::int64_t kMostVertices = 12'000'000;
static_assert(88 * kMostVertices + 200 <= kMaxHorizontal);
static_assert(40 * kMostVertices + 80 <= kMaxHorizontal);
static_assert(1000 * kMostVertices * kMostVertices + 1000 < kMaxCoordinate);

/// Extents in x, y and z.
using Extents = std::array<std::int64_t, 3>;

/// Extents that the proof of Lemma 2.18 promises for this very component, from the numbers of its
/// parts and the distances in its lists, never from the points they are compared with.
/// @param indices  vertices in the time order; @param bodies  Q bodies.
Extents bound_component(const Flow& flow, const Layout& layout, const Slabs& slabs,
                        std::size_t indices, std::size_t bodies) {
  const std::int64_t margin = 2 * (layout.largest_gap + kQHalfWidth) + 1;
  const std::int64_t x = layout.width_bound[1] + margin;
  const std::int64_t y = layout.width_bound[0] + margin;
  std::int64_t z = static_cast<std::int64_t>(indices) +
                   static_cast<std::int64_t>(bodies) * kQHeight + slabs.lean_excess;
  for (const NodeType type : flow.types[0]) {
    if (type == NodeType::split) z += x;
    if (type == NodeType::merge) z += y;
    if (type == NodeType::source || type == NodeType::sink) z += x + y + margin;
  }
  z += static_cast<std::int64_t>(flow.vv_edges.size()) * (x + y + 2);
  return {x, y, z};
}

/// Holds what the construction met in one run.
struct TwoBendCensus {
  std::int64_t components = 0, q_bodies = 0, stations = 0, vv_leans = 0;
  std::int64_t sinks_a = 0, sinks_v = 0, sources_a = 0, sources_v = 0, adjacent_poles = 0;
  std::int64_t rounds = 0, safe_rounds = 0;
  Extents bound{};  // components are stacked in z

  void add(const Attempt& drawn, std::size_t indices, std::size_t bodies) {
    const auto& [flow, layout, slabs] = drawn;
    add_bound(bound_component(flow, layout, slabs, indices, bodies));
    q_bodies += static_cast<std::int64_t>(bodies);
    vv_leans += static_cast<std::int64_t>(flow.vv_edges.size());
    stations += std::count(flow.types[0].begin(), flow.types[0].end(), NodeType::station);
    for (const Pole& pole : flow.poles) {
      const bool is_sink = flow.nodes[pole.node].type == NodeType::sink;
      ++(is_sink ? (pole.a_type ? sinks_a : sinks_v) : (pole.a_type ? sources_a : sources_v));
      if (is_sink && flow.adjacent_poles(pole)) ++adjacent_poles;
    }
    rounds = std::max<std::int64_t>(rounds, layout.rounds);
    safe_rounds += layout.safe ? 1 : 0;
  }

  void add_bound(const Extents& component) {
    bound[0] = std::max(bound[0], component[0]);
    bound[1] = std::max(bound[1], component[1]);
    bound[2] += component[2];
  }

  std::vector<Counter> counters() const {
    return {
        {"components", components}, {"q_bodies", q_bodies},      {"stations", stations},
        {"vv_leans", vv_leans},     {"sinks_a", sinks_a},        {"sinks_v", sinks_v},
        {"sources_a", sources_a},   {"sources_v", sources_v},    {"adjacent_poles", adjacent_poles},
        {"rounds", rounds},         {"safe_rounds", safe_rounds}};
  }
};

Attempt draw_layout(Flow flow, Layout layout, Output& output) {
  flow.forget_lists();
  Slabs slabs = draw_slabs(flow, layout, output);
  return {std::move(flow), std::move(layout), std::move(slabs)};
}

std::optional<Attempt> lay_out(Flow flow, int effort, Output& output) {
  std::optional<Layout> layout = find_layout(flow, build_lists(flow, effort > 0), effort > 0);
  if (!layout) return std::nullopt;
  return draw_layout(std::move(flow), *std::move(layout), output);
}

Attempt lay_out_safely(Flow flow, Output& output) {
  Layout layout = find_safe_layout(flow, build_safe_lists(flow));
  return draw_layout(std::move(flow), std::move(layout), output);
}

std::int64_t width_of(const Values& values) {
  return *std::max_element(values.begin(), values.end()) + 1;
}

/// Stops where the drawing would be too high anyway: a slab is lower than kMaxCoordinate.
std::int64_t height_of(const Slabs& slabs) {
  std::int64_t height = 1;
  for (const SlabHeights& slab : slabs.of_node) {
    height += slab.below + slab.above + 1;
    if (height >= kMaxCoordinate) break;
  }
  return height;
}

/// True if the ordinary rounds kept the smaller box that they are held to (Lemma 2.18). Bends and Q
/// bodies may reach beyond the outermost rows and columns; this allows for as much as they can.
/// @param n  vertices. @param indices  vertices in the time order. @param bodies  Q bodies.
bool keeps_box(const Attempt& attempt, std::size_t n, std::size_t indices, std::size_t bodies) {
  const std::int64_t edge = 2 * (attempt.layout.largest_gap + kQHalfWidth) + 1;
  const auto passes_and_bodies =
      static_cast<std::int64_t>(indices) + kQHeight * static_cast<std::int64_t>(bodies);
  return kOrdinaryBox[0].holds(width_of(attempt.layout.columns) + edge, n) &&
         kOrdinaryBox[1].holds(width_of(attempt.layout.rows) + edge, n) &&
         kOrdinaryBox[2].holds(height_of(attempt.slabs) + passes_and_bodies, n);
}

/// @param make_flow  gives the flow anew: an attempt changes it, and a copy for the case that the
/// first one fails would take 72 bytes per vertex of every drawing.
/// @param is_small  whether an attempt keeps the smaller box.
template <class MakeFlow, class IsSmall>
Attempt find_attempt(MakeFlow make_flow, const Options& options, IsSmall is_small, Output& output) {
  if (options.force_safe_layout) return lay_out_safely(make_flow(), output);
  std::optional<Attempt> ordinary = lay_out(make_flow(), options.effort, output);
  if (ordinary && is_small(*ordinary)) return *std::move(ordinary);
  ordinary.reset();
  return lay_out_safely(make_flow(), output);
}

void draw_component(LocalGraph& graph, const Options& options, Output& output,
                    TwoBendCensus& census) {
  if (graph.size() == 1) {
    output.make_room(1, output.base_z());
    output.set_vertex(graph.name[0], {0, 0, output.base_z()});
    output.end_component(output.base_z());
    census.add_bound({1, 1, 1});
    return;
  }
  if (draw_small_cubic(graph, output)) return census.add_bound(kFixedBodyBound);
  BlockTree blocks = find_blocks(graph);
  release(graph.parent);
  if (graph.size() == 5 && is_q_block(blocks.block_of(0))) {
    output.make_room(graph.size(), output.base_z() + kQHeight);
    draw_q_body(graph, read_q_body(graph, blocks, blocks.block_of(0).free[0]),
                {0, kQHalfWidth, output.base_z()}, true, output);
    output.end_component(output.base_z() + kQHeight);
    ++census.q_bodies;
    return census.add_bound(kFixedBodyBound);
  }
  const LongVector<QBody> bodies = cut_q_bodies(graph, blocks);
  const TimeOrder order = find_time_order(graph, blocks);
  const Attempt found =
      find_attempt([&] { return build_flow(graph, blocks, order); }, options,
                   [&](const Attempt& attempt) {
                     return keeps_box(attempt, graph.size(), order.list.size(), bodies.size());
                   },
                   output);
  if (found.flow.joint) {  // every index is a node: nothing reads the graph
    release(graph.neighbours);
    release(graph.edges);
  }
  stack_slabs(graph, order.list, found, bodies, output);
  census.add(found, order.list.size(), bodies.size());
}

Drawing draw_alone(const Graph& graph, const Options& options) {
  const LongArrayReuse reuse;
  Output output(graph);
  TwoBendCensus census;
  ComponentReader reader(graph);
  LocalGraph component;
  while (reader.next(component)) {
    ++census.components;
    draw_component(component, options, output, census);
  }
  Drawing drawing = output.finish();
  drawing.counters = census.counters();
  if (graph.num_vertices() > 0) drawing.instance_bound = census.bound;
  return drawing;
}

}  // namespace

Drawing draw(const Graph& graph, const Options& options) {
  check_effort("two-bend", options.effort, kHighestEffort);
  refuse_larger_degrees("two-bend", graph, 3);
  return smallest_of_efforts(graph, options, draw_alone);
}

Algorithm row() {
  return {
      .name = "two-bend",
      .summary =
          "degree at most 3, at most 2 bends per edge, angles of at least 120 degrees, in a box of "
          "O(n) x O(n) x O(n^2)",
      .source = "Theorem 2",
      .guarantee = {.max_degree = 3,
                    .max_bends = 2,
                    .angle_rule = AngleRule::at_least,
                    .cosine = {-1, 2},
                    .lattice = kScaledZLattice,
                    .directions = {},
                    .bound = {"proved here", "docs/theorem2.md", kBox},
                    .published = {}},
      .options = {effort_option(kHighestEffort, "0: plain; 1: edges share rows and columns")},
      .draw = draw_with_effort<draw>};
}

}  // namespace ar3d::two_bend
