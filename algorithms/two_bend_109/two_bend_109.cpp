// Two bends at 109.47 degrees, component by component: Steps E.1 to E.4, parts, order along x,
// heights, places. What is tried is exact, so a drawing is right whatever the scale; the scale of
// Lemma E.5, at which no vertex can fail, is the last resort. Cost: that of Step E.4 and of the
// searches of Step E.1.
#include "ar3d/algorithms/two_bend_109/two_bend_109.h"

#include <fmt/format.h>

#include <numeric>

#include "ar3d/algorithms/two_bend_109/layout.h"
#include "ar3d/algorithms/two_bend_109/partition.h"
#include "ar3d/algorithms/two_bend_109/placement.h"
#include "ar3d/algorithms/two_bend_109/slots.h"
#include "ar3d/base/error.h"
#include "ar3d/base/random.h"

namespace ar3d::two_bend_109 {
namespace {

constexpr int kHighestEffort = 1;
constexpr std::int64_t kMostJitter = std::int64_t{1} << 30;  // its square fits 64 bits

/// A component as a graph of its own; both number vertices and edges in the same order.
struct Component {
  Graph graph;
  std::vector<Vertex> vertices;
  std::vector<EdgeId> edges;
};

std::vector<Component> components_of(const Graph& graph) {
  const Components found = connected_components_of(graph);
  std::vector<Component> components(found.count);
  if (found.count == 1) {
    components[0].graph = graph;
    components[0].vertices.resize(graph.num_vertices());
    components[0].edges.resize(graph.num_edges());
    std::iota(components[0].vertices.begin(), components[0].vertices.end(), Vertex{0});
    std::iota(components[0].edges.begin(), components[0].edges.end(), EdgeId{0});
    return components;
  }
  std::vector<Vertex> name(graph.num_vertices());
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    auto& vertices = components[found.of[v]].vertices;
    name[v] = static_cast<Vertex>(vertices.size());
    vertices.push_back(v);
  }
  std::vector<std::vector<Edge>> edges(found.count);
  for (EdgeId e = 0; e < graph.num_edges(); ++e) {
    const Edge ends = graph.edge(e);
    edges[found.of[ends.u]].push_back({name[ends.u], name[ends.v]});
    components[found.of[ends.u]].edges.push_back(e);
  }
  for (std::size_t i = 0; i < components.size(); ++i) {
    components[i].graph = Graph(components[i].vertices.size(), std::move(edges[i]));
  }
  return components;
}

/// Extents of the union of what is drawn over all choices of all vertices in their squares
/// (instance_bound): a bend moves with its vertex. O(n).
std::array<std::int64_t, 3> extents_of_choices(const Graph& graph,
                                               const std::vector<VertexPart>& parts,
                                               const SlotArrangement& arrangement,
                                               const Layout& layout, const Placement& placement) {
  GrowingBox box;
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    const bool in_body = parts[arrangement.part[v]].kind == PartKind::body;
    const std::int64_t most = (in_body ? layout.scale.body_jitter : layout.scale.jitter) - 1;
    const auto add = [&](Point p) {
      box.add(p);
      box.add(p + Vector{most, most, 0});
    };
    add(layout.place[v]);
    for (std::size_t i = 0; i < graph.degree(v); ++i) {
      add(layout.place[v] + (placement.ends[v][i] - placement.at[v]));
    }
  }
  const Point low = box.low(), high = box.high();
  return {high.x - low.x, high.y - low.y, high.z - low.z};
}

/// Draws components and collects them side by side.
class SideBySide {
 public:
  explicit SideBySide(const Graph& graph)
      : graph_(graph), at_(graph.num_vertices()), bends_(graph.num_edges()) {}

  /// Begins with this scale.
  void add(const Component& component, LayoutScale scale) {
    const Graph& graph = component.graph;
    const std::vector<VertexPart> parts = find_partition(graph);
    ++components_;
    for (const VertexPart& part : parts) ++parts_[static_cast<std::size_t>(part.kind)];
    const SlotArrangement arrangement = arrange(graph, parts);
    slots_ += static_cast<std::int64_t>(arrangement.kind.size());
    const std::uint64_t seed = mix_seed(graph.num_vertices(), graph.num_edges());
    for (;; scale = scale.next(graph.num_vertices())) {
      const Layout layout = lay_out(graph, parts, arrangement, scale, component.vertices);
      const std::optional<Placement> placement =
          place(graph, parts, arrangement, layout,
                mix_seed(seed, static_cast<std::uint64_t>(scale.jitter)));
      if (placement) {
        jitter_ = std::max(jitter_, scale.jitter);
        tried_ += placement->tried;
        const auto bound = extents_of_choices(graph, parts, arrangement, layout, *placement);
        return add(component, *placement, bound);
      }
      expect(scale.jitter < LayoutScale::always_enough(graph.num_vertices()).jitter,
             "there are more points than closed ones");
    }
  }

  Drawing finish() const {
    Coordinates vertices(at_.size(), largest_);
    for (std::size_t v = 0; v < at_.size(); ++v) vertices.set(v, at_[v]);
    auto bends = std::make_shared<StoredBends>();
    std::vector<Point> two(2);
    for (const auto& [at_u, at_v] : bends_) {
      two[0] = at_u;
      two[1] = at_v;
      bends->add_edge(two);
    }
    Drawing drawing{"two-bend-109", kAxisLattice, std::move(vertices), graph_.shared_edges(),
                    std::move(bends)};
    if (!at_.empty()) drawing.instance_bound = {bound_[0] - 1, bound_[1], bound_[2]};
    drawing.counters = {{"components", components_},
                        {"singles", parts_[0]},
                        {"cycles", parts_[1]},
                        {"bodies", parts_[2]},
                        {"slots", slots_},
                        {"jitter", jitter_},
                        {"tried", tried_}};
    return drawing;
  }

 private:
  void add(const Component& component, const Placement& placement,
           const std::array<std::int64_t, 3>& bound) {
    const Graph& part = component.graph;
    bound_[0] += bound[0] + 1;
    for (const std::size_t axis : {1u, 2u}) {
      bound_[axis] = std::max(bound_[axis], bound[axis]);
    }
    GrowingBox box;
    for (Vertex v = 0; v < part.num_vertices(); ++v) {
      box.add(placement.at[v]);
      for (std::size_t i = 0; i < part.degree(v); ++i) box.add(placement.ends[v][i]);
    }
    const Point low = box.low();
    const Vector shift{next_x_ - low.x, -low.y, -low.z};
    for (Vertex v = 0; v < part.num_vertices(); ++v) {
      at_[component.vertices[v]] = placement.at[v] + shift;
      const auto incident = part.incident(v);
      for (std::size_t i = 0; i < incident.size(); ++i) {
        const EdgeId e = incident[i].edge;
        bends_[component.edges[e]][part.edge(e).u == v ? 0 : 1] = placement.ends[v][i] + shift;
      }
    }
    next_x_ += box.high().x - low.x + 1;
    expect(next_x_ <= kMaxCoordinate, "x fits");
    largest_ = std::max({largest_, next_x_, box.high().y - low.y, box.high().z - low.z});
  }

  const Graph& graph_;
  std::vector<Point> at_;
  std::vector<std::array<Point, 2>> bends_;
  std::int64_t next_x_ = 0;
  std::int64_t largest_ = 1;
  std::array<std::int64_t, 3> bound_{}, parts_{};  ///< parts by kind
  std::int64_t components_ = 0, slots_ = 0, jitter_ = 0, tried_ = 0;
};

}  // namespace

Drawing draw(const Graph& graph, const Options& options) {
  check_effort("two-bend-109", options.effort, kHighestEffort);
  refuse_larger_degrees("two-bend-109", graph, 4);
  if (options.first_jitter < 1 || options.first_jitter > kMostJitter ||
      !std::has_single_bit(static_cast<std::uint64_t>(options.first_jitter))) {
    throw InputError(fmt::format("two-bend-109: a jitter is a power of 2 up to 2^30, not {}",
                                 options.first_jitter));
  }
  SideBySide output(graph);
  for (const Component& component : components_of(graph)) {
    output.add(component, options.effort == 0
                              ? LayoutScale::always_enough(component.graph.num_vertices())
                              : LayoutScale{options.first_jitter});
  }
  return output.finish();
}

Algorithm row() {
  return {
      .name = "two-bend-109",
      .summary =
          "degree at most 4, at most 2 bends per edge, angles of at least 109.47 degrees, in a box "
          "of O(n^2) x O(n) x O(n^3)",
      .source = "the paper's second open question",
      .guarantee = {.max_degree = 4,
                    .max_bends = 2,
                    .angle_rule = AngleRule::at_least,
                    .cosine = {-1, 3},
                    .lattice = kAxisLattice,
                    .directions = {},
                    .bound = {"proved here",
                              "docs/two-bend-109.md",
                              {quadratic(640) + 220000, linear(240) + 38000,
                               cubic(5000) + 220000000}},
                    .published = {}},
      .options = {effort_option(
          kHighestEffort,
          "0: the scale of the size bound's proof; 1: the smallest of ever larger ones that does")},
      .draw = draw_with_effort<draw>};
}

}  // namespace ar3d::two_bend_109
