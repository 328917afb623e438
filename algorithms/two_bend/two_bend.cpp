// Theorem 2, component by component: Steps 2.1 to 2.11 of docs/theorem2.md in their order. Not the
// paper's construction (contract triangles, seek chordless cycles), which has no grid and no volume
// bound: slabs along an st-order keep all coordinates polynomial. The result of the ordinary rounds
// is compared with a box and, where it breaks it, replaced by the layout whose box is proved. Cost:
// O(n) but for greatest common divisors.
#include "ar3d/algorithms/two_bend/two_bend.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "ar3d/algorithms/degree_limit.h"
#include "ar3d/algorithms/effort.h"
#include "ar3d/algorithms/two_bend/checks.h"
#include "ar3d/algorithms/two_bend/fixed_bodies.h"
#include "ar3d/algorithms/two_bend/instance_bound.h"
#include "ar3d/algorithms/two_bend/safe_layout.h"
#include "ar3d/algorithms/two_bend/stack_slabs.h"
#include "ar3d/algorithms/two_bend/view_list.h"
#include "ar3d/base/error.h"

namespace ar3d::two_bend {
namespace {

constexpr int kHighestEffort = 2;

// Up to this many vertices no check of integer widths can fail: the promised box fits, and so does
// whatever ten ordinary rounds can widen a list to (Lemma 2.18).
constexpr std::int64_t kMostVertices = 12'000'000;
static_assert(88 * kMostVertices + 200 <= kMaxHorizontal);
static_assert(40 * kMostVertices + 80 <= kMaxHorizontal);
static_assert(1000 * kMostVertices * kMostVertices + 1000 < kMaxCoordinate);

/// What the construction met in one run.
struct Census {
  std::int64_t components = 0, q_bodies = 0, stations = 0, vv_leans = 0;
  std::int64_t sinks_a = 0, sinks_v = 0, sources_a = 0, sources_v = 0, adjacent_poles = 0;
  std::int64_t rounds = 0, safe_rounds = 0;
  InstanceBound bound;

  void add(const Flow& flow, const Layout& layout, std::size_t places, std::size_t bodies) {
    bound.add(bound_component(flow, layout, places, bodies));
    q_bodies += static_cast<std::int64_t>(bodies);
    vv_leans += static_cast<std::int64_t>(flow.vv_edges.size());
    for (const Node& node : flow.nodes) stations += node.type == NodeType::station ? 1 : 0;
    for (const Pole& pole : flow.poles) {
      const bool is_sink = flow.nodes[pole.node].type == NodeType::sink;
      ++(is_sink ? (pole.a_type ? sinks_a : sinks_v) : (pole.a_type ? sources_a : sources_v));
      if (is_sink && flow.adjacent_poles(pole)) ++adjacent_poles;
    }
    rounds = std::max<std::int64_t>(rounds, layout.rounds);
    safe_rounds += layout.safe ? 1 : 0;
  }

  std::vector<Counter> counters() const {
    return {
        {"components", components}, {"q_bodies", q_bodies},      {"stations", stations},
        {"vv_leans", vv_leans},     {"sinks_a", sinks_a},        {"sinks_v", sinks_v},
        {"sources_a", sources_a},   {"sources_v", sources_v},    {"adjacent_poles", adjacent_poles},
        {"rounds", rounds},         {"safe_rounds", safe_rounds}};
  }
};

/// One way to lay a component out.
struct Attempt {
  Flow flow;
  Layout layout;
  Slabs slabs;
};

Attempt draw_layout(Flow flow, Layout layout) {
  expect_heavy([&] { return merges_keep_distances(View(flow, false), layout.rows); },
               "MERGEs keep their distances in the rows");
  expect_heavy([&] { return merges_keep_distances(View(flow, true), layout.columns); },
               "SPLITs keep their distances in the columns");
  expect_heavy([&] { return rays_differ(flow, layout); }, "active rays stand at different places");
  expect_heavy([&] { return vv_leans_are_primitive(flow, layout); }, "VV leans are primitive");
  flow.forget_lists();
  Slabs slabs = draw_slabs(flow, layout);
  return {std::move(flow), std::move(layout), std::move(slabs)};
}

std::optional<Attempt> lay_out(Flow flow, int effort, bool straighten) {
  std::optional<Layout> layout = find_layout(
      flow, build_lists(flow, {.share = effort > 0, .straighten = straighten, .weights = {}}),
      effort == 0 ? 0u : 2u);
  if (!layout) return std::nullopt;
  return draw_layout(std::move(flow), *std::move(layout));
}

Attempt lay_out_safely(Flow flow) {
  Layout layout = find_safe_layout(flow, build_safe_lists(flow));
  return draw_layout(std::move(flow), std::move(layout));
}

std::int64_t width_of(const Values& values) {
  return *std::max_element(values.begin(), values.end()) + 1;
}

/// Stops where the drawing would be too high anyway: a slab is lower than kMaxCoordinate.
std::int64_t height_of(const Slabs& slabs) {
  std::int64_t height = 1;
  for (const Slab& slab : slabs.of_node) {
    height += slab.below + slab.above + 1;
    if (height >= kMaxCoordinate) break;
  }
  return height;
}

/// What a component has: vertices in all, in the time order, and Q bodies.
struct ComponentSize {
  std::size_t vertices = 0;
  std::size_t places = 0;
  std::size_t bodies = 0;
};

/// Whether ordinary rounds kept the smaller box, which they are held to (Lemma 2.18). Counts what
/// may stick out at the edges.
bool keeps_box(const Attempt& attempt, const ComponentSize& size) {
  const std::int64_t edge = 2 * (attempt.layout.largest_gap + kQHalfWidth) + 1;
  const auto passes_and_bodies =
      static_cast<std::int64_t>(size.places) + kQHeight * static_cast<std::int64_t>(size.bodies);
  return kOrdinaryBox[0].holds(width_of(attempt.layout.columns) + edge, size.vertices) &&
         kOrdinaryBox[1].holds(width_of(attempt.layout.rows) + edge, size.vertices) &&
         kOrdinaryBox[2].holds(height_of(attempt.slabs) + passes_and_bodies, size.vertices);
}

/// Up to what sticks out at the edges.
double volume_of(const Attempt& attempt) {
  return static_cast<double>(width_of(attempt.layout.columns)) *
         static_cast<double>(width_of(attempt.layout.rows)) *
         static_cast<double>(height_of(attempt.slabs));
}

/// The smaller of two drawings; the second seeks straight edges.
Attempt find_smaller(const Flow& flow, const Options& options, const ComponentSize& size) {
  std::optional<Attempt> plain = lay_out(flow, options.effort, false);
  if (plain && !keeps_box(*plain, size)) plain.reset();
  if (flow.vv_edges.empty()) return plain ? *std::move(plain) : lay_out_safely(flow);
  std::optional<Attempt> straight = lay_out(flow, options.effort, true);
  if (straight && !keeps_box(*straight, size)) straight.reset();
  if (!plain && !straight) return lay_out_safely(flow);
  if (!plain) return *std::move(straight);
  if (!straight) return *std::move(plain);
  return volume_of(*straight) <= volume_of(*plain) ? *std::move(straight) : *std::move(plain);
}

/// @param make_flow  gives the flow anew: an attempt changes it, and a copy for the case that the
/// first one fails would take 72 bytes per vertex of every drawing.
template <class MakeFlow>
Attempt find_attempt(MakeFlow make_flow, const Options& options, const ComponentSize& size) {
  if (options.force_safe_layout) return lay_out_safely(make_flow());
  if (options.effort == kHighestEffort) return find_smaller(make_flow(), options, size);
  std::optional<Attempt> plain = lay_out(make_flow(), options.effort, false);
  if (plain && keeps_box(*plain, size)) return *std::move(plain);
  plain.reset();
  return lay_out_safely(make_flow());
}

void draw_component(LocalGraph& graph, const Options& options, Output& output, Census& census) {
  if (graph.size() == 1) {
    output.make_room(1, output.base_z());
    output.set_vertex(graph.name[0], {0, 0, output.base_z()});
    output.end_component(output.base_z());
    census.bound.add({1, 1, 1});
    return;
  }
  if (draw_small_cubic(graph, output)) return census.bound.add(kFixedBodyBound);
  Blocks blocks = find_blocks(graph);
  release(graph.parent);
  if (graph.size() == 5 && is_q_block(blocks.block_of(0))) {
    output.make_room(graph.size(), output.base_z() + kQHeight);
    draw_q_body(graph, read_q_body(graph, blocks, blocks.block_of(0).free[0]),
                {0, kQHalfWidth, output.base_z()}, true, output);
    output.end_component(output.base_z() + kQHeight);
    ++census.q_bodies;
    return census.bound.add(kFixedBodyBound);
  }
  const LongVector<QBody> bodies = cut_q_bodies(graph, blocks);
  const TimeOrder order = find_time_order(graph, blocks);
  expect_heavy([&] { return is_time_order(graph, order); },
               "sources and sinks of the time order have the neighbours they need");
  const Attempt found = find_attempt([&] { return build_flow(graph, blocks, order); }, options,
                                     {graph.size(), order.list.size(), bodies.size()});
  stack_slabs({graph, order, found.flow, found.layout, found.slabs, bodies}, output);
  census.add(found.flow, found.layout, order.list.size(), bodies.size());
}

}  // namespace

Drawing draw(const Graph& graph, const Options& options) {
  check_effort("two-bend", options.effort, kHighestEffort);
  refuse_larger_degrees("two-bend", graph, 3);
  const LongArrayReuse reuse;
  Output output(graph);
  Census census;
  ComponentReader reader(graph);
  LocalGraph component;
  while (reader.next(component)) {
    ++census.components;
    draw_component(component, options, output, census);
  }
  Drawing drawing = output.finish();
  drawing.counters = census.counters();
  if (graph.num_vertices() > 0) drawing.instance_bound = census.bound.extents;
  return drawing;
}

}  // namespace ar3d::two_bend

namespace ar3d {

Algorithm two_bend::row() {
  Guarantee guarantee;
  guarantee.max_degree = 3;
  guarantee.max_bends = 2;
  guarantee.angle_rule = AngleRule::at_least;
  guarantee.cosine = {-1, 2};
  guarantee.lattice = kTallLattice;
  guarantee.bound = {"proved here", "docs/theorem2.md", two_bend::kBox};
  return {
      "two-bend",
      "degree at most 3, at most 2 bends per edge, angles of at least 120 degrees, in a box of "
      "O(n) x O(n) x O(n^2)",
      "Theorem 2",
      guarantee,
      {effort_option(two_bend::kHighestEffort,
                     "0: plain; 1: edges share rows and columns; 2: also seeks straight edges and "
                     "keeps the smaller drawing")},
      [](const Graph& graph, const Settings& values) {
        return two_bend::draw(graph, {.effort = static_cast<int>(value_of(values, "effort"))});
      }};
}

}  // namespace ar3d
