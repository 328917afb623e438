#include "ar3d/algorithms/two_bend/two_bend.h"

#include <algorithm>
#include <array>
#include <utility>

#include "ar3d/algorithms/degree_limit.h"
#include "ar3d/algorithms/two_bend/checks.h"
#include "ar3d/algorithms/two_bend/fixed_bodies.h"
#include "ar3d/algorithms/two_bend/instance_bound.h"
#include "ar3d/algorithms/two_bend/sweep.h"
#include "ar3d/algorithms/two_bend/view_list.h"
#include "ar3d/model/error.h"

namespace ar3d::two_bend {
namespace {

/// What the construction met in one run.
struct Census {
  std::int64_t components = 0, q_bodies = 0, stations = 0, vv_leans = 0;
  std::int64_t sinks_a = 0, sinks_v = 0, sources_a = 0, sources_v = 0, adjacent_poles = 0;
  std::int64_t rounds = 0, safe_rounds = 0;
  InstanceBound bound;

  void add(const Flow& flow, const Layout& layout, std::size_t places, std::size_t bodies) {
    bound.add(bound_component(flow, layout, places, bodies));
    q_bodies += static_cast<std::int64_t>(bodies);
    vv_leans += static_cast<std::int64_t>(find_vv_edges(flow).size());
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

Attempt lay_out(Flow flow, const Options& options, bool straighten) {
  const Lists lists = build_lists(flow, {options.effort > 0, straighten});
  Layout layout =
      find_layout(flow, lists, {options.force_safe_round, options.effort == 0 ? 0u : 2u});
  expect_heavy([&] { return merges_keep_distances(View(flow, false), layout.rows); },
               "MERGEs keep their distances in the rows");
  expect_heavy([&] { return merges_keep_distances(View(flow, true), layout.columns); },
               "SPLITs keep their distances in the columns");
  expect_heavy([&] { return rays_differ(flow, layout); }, "active rays stand at different places");
  expect_heavy([&] { return vv_leans_are_primitive(flow, layout); }, "VV leans are primitive");
  Slabs slabs = draw_slabs(flow, layout);
  return {std::move(flow), std::move(layout), std::move(slabs)};
}

/// Up to what sticks out at the edges.
double volume_of(const Attempt& attempt) {
  const auto width = [](const Values& values) {
    return static_cast<double>(*std::max_element(values.begin(), values.end()) + 1);
  };
  double height = 1;
  for (const Slab& slab : attempt.slabs.of_node) {
    height += static_cast<double>(slab.below + slab.above + 1);
  }
  return width(attempt.layout.columns) * width(attempt.layout.rows) * height;
}

Attempt find_attempt(const Flow& flow, const Options& options) {
  Attempt plain = lay_out(flow, options, false);
  if (options.effort < 2 || find_vv_edges(flow).empty()) return plain;
  Attempt straight = lay_out(flow, options, true);
  return volume_of(straight) <= volume_of(plain) ? std::move(straight) : std::move(plain);
}

void draw_component(LocalGraph& graph, const Options& options, Output& output, Census& census) {
  if (graph.size() == 1) {
    output.set_vertex(graph.name[0], {0, 0, output.base_z()});
    output.end_component(output.base_z());
    census.bound.add({1, 1, 1});
    return;
  }
  if (draw_small_cubic(graph, output)) return census.bound.add(kFixedBodyBound);
  Blocks blocks = find_blocks(graph);
  if (graph.size() == 5 && is_q_block(blocks.block_of(0))) {
    draw_q_body(graph, read_q_body(graph, blocks, blocks.block_of(0).free[0]),
                {0, kQHalfWidth, output.base_z()}, true, output);
    output.end_component(output.base_z() + kQHeight);
    ++census.q_bodies;
    return census.bound.add(kFixedBodyBound);
  }
  const std::vector<QBody> bodies = cut_q_bodies(graph, blocks);
  const TimeOrder order = find_time_order(graph, blocks);
  expect_heavy([&] { return is_time_order(graph, order); },
               "sources and sinks of the time order have the neighbours they need");
  const Attempt found = find_attempt(build_flow(graph, blocks, order), options);
  sweep({graph, order, found.flow, found.layout, found.slabs, bodies}, output);
  census.add(found.flow, found.layout, order.list.size(), bodies.size());
}

}  // namespace

Drawing draw(const Graph& graph, const Options& options) {
  refuse_larger_degrees("two-bend", graph, 3);
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

Algorithm two_bend_row() {
  Guarantee guarantee;
  guarantee.max_degree = 3;
  guarantee.max_bends = 2;
  guarantee.angle_rule = AngleRule::at_least;
  guarantee.cosine = {-1, 2};
  guarantee.lattice = kTallLattice;
  // x and y: proved unless a component needs the safe round; z: O(n^2) is proved, this constant is
  // not (docs/theorem2.md).
  guarantee.bound = {
      "checked", "docs/theorem2.md", {{{40, 1, 2, 80}, {40, 1, 2, 80}, {64, 1, 4, 64}}}};
  return {
      "two-bend",
      "at most two bends an edge, angles of at least 120 degrees, in volume O(n) x O(n) x O(n^2)",
      "Theorem 2",
      guarantee,
      {{"effort", 0, 2, 1,
        "0 plain, 1 edges share rows and columns, 2 also seeks straight edges, keeps the better"}},
      [](const Graph& graph, const OptionValues& values) {
        return two_bend::draw(graph, {.effort = static_cast<unsigned>(option(values, "effort"))});
      }};
}

}  // namespace ar3d
