// Two bends at 120 degrees along face diagonals (docs/two-bend-120.md), component by component: triangles
// contracted, numbering, orders, places, words, and triangles drawn inside their vertices again
// (Lemma F.8). Cores without a numbering come from a table. Cost: O(n log n) and Step F.3.
#include "ar3d/algorithms/two_bend_120/two_bend_120.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/container/static_vector.hpp>
#include <boost/graph/biconnected_components.hpp>

#include "ar3d/algorithms/two_bend_120/placement.h"
#include "ar3d/base/error.h"
#include "ar3d/model/boost_graph.h"

namespace ar3d::two_bend_120 {
namespace {

constexpr std::uint32_t kMostVertices = 1u << 29;  // coordinates are then below 2^60
constexpr const char* kDraws =
    "two-bend-120 draws graphs whose components are cubic and have no bridge";

/// Step F.1: refuses graphs with a component that is not cubic or has a bridge, a biconnected
/// component of one edge. @throws InputError naming the first vertex of another degree, or the first
/// bridge. Cost: O(n).
void refuse_bridges(const Graph& graph) {
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    if (graph.degree(v) == 3) continue;
    throw InputError(fmt::format("{}, but vertex {} has degree {} (vertices count from 0)", kDraws,
                                 v, graph.degree(v)));
  }
  std::vector<EdgeId> component(graph.num_edges());
  std::vector<EdgeId> sizes(boost::biconnected_components(
      graph, boost::make_iterator_property_map(component.begin(), get(boost::edge_index, graph))));
  for (const EdgeId c : component) ++sizes[c];
  const auto bridge = std::ranges::find_if(component, [&](EdgeId c) { return sizes[c] == 1; });
  if (bridge == component.end()) return;
  const Edge ends = graph.edge(static_cast<EdgeId>(bridge - component.begin()));
  throw InputError(fmt::format("{}, but edge {} - {} is a bridge (vertices count from 0)", kDraws,
                               ends.u, ends.v));
}

Vector grid_direction(Direction d) { return to_grid(to_four(d)); }

using Bends = boost::container::static_vector<Point, 2>;

/// A component of what is left when triangles are contracted, its vertices renamed in the order of
/// a breadth-first search.
struct Core {
  CubicGraph graph;
  std::vector<Vertex> nodes;  ///< per vertex: the node of the contraction
  Reach reach;
};

/// Draws the cores one by one and collects the points of the whole graph.
class Painter {
 public:
  Painter(const Graph& graph, const Nests& contraction)
      : graph_(graph),
        contraction_(contraction),
        name_(contraction.nodes.size(), kNoVertex),
        at_(contraction.nodes.size()),
        stars_(contraction.nodes.size() - graph.num_vertices()),
        component_(graph.num_vertices()),
        bends_(graph.num_edges()) {}

  void draw_all() {
    for (const Vertex node : contraction_.left) {
      if (name_[node] == kNoVertex) draw(core_from(node));
    }
  }

  Drawing finish() const {
    Coordinates vertices(graph_.num_vertices(), std::max<std::int64_t>(largest_, 1));
    vertices.fill(0, vertices.size(),
                  [&](std::size_t v) { return at_[v] + shifts_[component_[v]]; });
    auto bends = std::make_shared<StoredBends>();
    bends->reserve(graph_.num_edges(), std::size_t{2} * graph_.num_edges());
    std::vector<Point> line;
    for (EdgeId e = 0; e < graph_.num_edges(); ++e) {
      const Vector shift = shifts_[component_[graph_.edge(e).u]];
      line.clear();
      for (const Point p : bends_[e]) line.push_back(p + shift);
      bends->add_edge(line);
    }
    Drawing drawing{"two-bend-120", kCubeLattice, std::move(vertices), graph_.shared_edges(),
                    std::move(bends)};
    drawing.counters = {{"components", static_cast<std::int64_t>(shifts_.size())},
                        {"core", static_cast<std::int64_t>(contraction_.left.size())},
                        {"small_cores", small_}};
    return drawing;
  }

 private:
  Core core_from(Vertex first) {
    Core core;
    core.nodes.push_back(first);
    name_[first] = 0;
    for (std::size_t i = 0; i < core.nodes.size(); ++i) {
      const Nests::Nest& node = contraction_.nodes[core.nodes[i]];
      std::array<HalfEdge, 3> near{};
      for (std::size_t slot = 0; slot < 3; ++slot) {
        const Edge ends = contraction_.ends[node.edges[slot]];
        const Vertex other = ends.u == core.nodes[i] ? ends.v : ends.u;
        if (name_[other] == kNoVertex) {
          name_[other] = static_cast<Vertex>(core.nodes.size());
          core.nodes.push_back(other);
        }
        near[slot] = {name_[other], node.edges[slot]};
      }
      core.graph.push_back(near);
      core.reach.push_back(node.reach);
    }
    return core;
  }

  void draw(const Core& core) {
    std::optional<Orders> orders;
    const auto numbering = find_numbering(core.graph, [&](const ForkOrder& found) {
      orders = find_orders(found.forks);
      return orders.has_value();
    });
    if (numbering) {
      draw_by_orders(core, *numbering, *orders);
    } else {
      draw_from_table(core);
    }
    open_triangles(core.nodes);
    const Vector size = box_.high() - box_.low();
    shifts_.push_back(Point{next_x_, 0, 0} - box_.low());
    box_ = {};
    next_x_ += size.x + 1;
    largest_ = std::max({largest_, next_x_, size.y, size.z});
  }

  /// Steps F.5 and F.6.
  void draw_by_orders(const Core& core, const ForkOrder& numbering, const Orders& orders) {
    std::vector<Vertex> nodes;
    Reach reach;
    for (const Vertex v : numbering.order) {
      nodes.push_back(core.nodes[v]);
      reach.push_back(core.reach[v]);
    }
    const ForkPlaces placement = place(numbering, orders, reach);
    for (Vertex v = 0; v < nodes.size(); ++v) {
      set_place(nodes[v], Point{} + to_grid(placement.at[v]));
      for (std::size_t i = 0; i < 3; ++i) {
        set_star(nodes[v], i, grid_direction(placement.stars[v][i]));
      }
    }
    for (Vertex v = 0; v < nodes.size(); ++v) {
      for (const HalfEdge& half : numbering.graph[v]) {
        if (half.to < v) continue;  // upwards, so that each edge is drawn once
        const FourVector& from = placement.at[v];
        const FourVector& to = placement.at[half.to];
        FourVector sum{};
        for (std::size_t i = 0; i < 4; ++i) sum[i] = to[i] - from[i];
        const auto star = [&](Vertex w) {
          return placement.stars[w][slot_of(numbering.graph[w], half.edge)];
        };
        const auto [directions, lengths] = find_word(star(v), -star(half.to), sum);
        Bends bends;
        Point p = Point{} + to_grid(from);
        for (std::size_t i = 0; i < 2; ++i) {
          if (lengths[i] == 0) continue;
          p = p + lengths[i] * grid_direction(directions[i]);
          bends.push_back(p);
        }
        set_bends(half.edge, nodes[v], bends);
      }
    }
  }

  void set_bends(EdgeId edge, Vertex from, Bends bends) {
    for (const Point p : bends) box_.add(p);
    if (contraction_.ends[edge].u != from) std::reverse(bends.begin(), bends.end());
    bends_[edge] = bends;
  }

  void set_place(Vertex node, Point at) {
    box_.add(at);
    at_[node] = at;
  }

  void set_star(Vertex node, std::size_t slot, Vector direction) {
    if (node >= graph_.num_vertices()) stars_[node - graph_.num_vertices()][slot] = direction;
  }

  void draw_from_table(const Core& core);
  void open_triangles(std::vector<Vertex> open);

  const Graph& graph_;
  const Nests& contraction_;
  std::vector<Vertex> name_;                  // per node: its name in its core
  std::vector<Point> at_;                     // per node, as the next one
  std::vector<std::array<Vector, 3>> stars_;  // per contracted triangle
  std::vector<std::uint32_t> component_;      // per vertex of the input
  std::vector<Bends> bends_;                  // per edge, from its end u
  std::vector<Vector> shifts_;                // per component: to a free x, and to 0
  GrowingBox box_;                            // of the component that is drawn
  std::int64_t small_ = 0, largest_ = 0, next_x_ = 0;
};

/// Lemma F.7: the table's drawing of the core, scaled so that the drawings of all its vertices fit.
void Painter::draw_from_table(const Core& core) {
  ++small_;
  std::uint32_t reach = 1;
  for (const auto& each : core.reach) reach = std::max({reach, each[0], each[1], each[2]});
  const std::int64_t scale = reach == 1 ? 1 : 2 * std::int64_t{reach};
  const auto scaled = [&](Point p) { return Point{scale * p.x, scale * p.y, scale * p.z}; };
  const auto found = small_core_of(core.graph);
  if (!found) {
    Vertex v = core.nodes[0];
    while (v >= graph_.num_vertices()) v = contraction_.nodes[v].corners[0];
    throw InputError(
        fmt::format("two-bend-120 found no drawing of the component of vertex {}, which two edges "
                    "cut (vertices count from 0)",
                    v));
  }
  const SmallCore& small = *found;
  for (Vertex v = 0; v < small.at.size(); ++v) set_place(core.nodes[v], scaled(small.at[v]));
  for (const auto& [u, v, bends] : small.lines) {
    std::size_t slot = 0;
    while (core.graph[u][slot].to != v) ++slot;
    const EdgeId edge = core.graph[u][slot].edge;
    Bends line;
    for (const Point p : bends) line.push_back(scaled(p));
    const Point first = bends.empty() ? small.at[v] : bends.front();
    const Point last = bends.empty() ? small.at[u] : bends.back();
    set_star(core.nodes[u], slot, primitive(first - small.at[u]));
    set_star(core.nodes[v], slot_of(core.graph[v], edge), primitive(last - small.at[v]));
    set_bends(edge, core.nodes[u], line);
  }
}

/// Step F.7: corner i of a triangle stands on its edge i, at the greatest reach of the other two in
/// that direction; the side of corners i and j has one bend, at the sum of both steps. Notes the
/// component of all vertices.
void Painter::open_triangles(std::vector<Vertex> open) {
  while (!open.empty()) {
    const Vertex opened = open.back();
    open.pop_back();
    if (opened < graph_.num_vertices()) {
      component_[opened] = static_cast<std::uint32_t>(shifts_.size());
      continue;
    }
    const Nests::Nest& nest = contraction_.nodes[opened];
    const Point at = at_[opened];
    const std::array<Vector, 3> star = stars_[opened - graph_.num_vertices()];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      const Vertex corner = nest.corners[i];
      const auto& own = contraction_.nodes[corner].edges;
      set_place(corner, at + std::int64_t{nest.steps[i]} * star[i]);
      set_star(corner, slot_of(own, nest.edges[i]), star[i]);
      set_star(corner, slot_of(own, nest.sides[k]), star[j]);
      set_star(corner, slot_of(own, nest.sides[j]), star[k]);
      set_bends(nest.sides[k], corner, {at_[corner] + std::int64_t{nest.steps[j]} * star[j]});
    }
    open.insert(open.end(), nest.corners.begin(), nest.corners.end());
  }
}

}  // namespace

Drawing draw(const Graph& graph) {
  refuse_larger_degrees("two-bend-120", graph, 3);
  refuse_more_vertices("two-bend-120", graph, kMostVertices);
  refuse_bridges(graph);
  const Nests contraction = contract_triangles(graph);
  Painter painter(graph, contraction);
  painter.draw_all();
  return painter.finish();
}

Algorithm row() {
  Algorithm row;
  row.name = "two-bend-120";
  row.summary =
      "cubic and 3-connected components, some bridgeless ones, 2 bends, 120 degrees along face "
      "diagonals, in a box of O(n^2) x O(n^2) x O(n)";
  row.source = "the paper's third open question";
  row.by_name_only = true;
  row.guarantee.max_degree = 3;
  row.guarantee.max_bends = 2;
  row.guarantee.cosine = {-1, 2};
  row.guarantee.lattice = kCubeLattice;
  row.guarantee.directions = {{1, 1, 0}, {1, -1, 0}, {1, 0, 1}, {1, 0, -1}, {0, 1, 1}, {0, 1, -1}};
  row.guarantee.bound = {"proved here",
                         "docs/two-bend-120.md",
                         {quadratic(3) + 30, quadratic(3) + 30, linear(21) + 8}};
  row.draw = [](const Graph& graph, const Settings&) { return draw(graph); };
  return row;
}

}  // namespace ar3d::two_bend_120
