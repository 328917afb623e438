// The space-fillers of Figure 1 as drawings: every component is found in its net by Steps L.1 to
// L.3, then all are set side by side in it (Lemma L.6), large ones first, each at the first free
// place of ever larger cubes. A drawing that comes out is right by construction: vertices are
// different vertices of the net, edges are edges of it. Cost: see draw().
#include "ar3d/algorithms/lattice/lattice.h"

#include <fmt/format.h>

#include <boost/graph/bipartite.hpp>
#include <cstdlib>
#include <unordered_set>

#include "ar3d/base/error.h"
#include "ar3d/model/boost_graph.h"

namespace ar3d::lattice {
namespace {

constexpr std::uint32_t kMostVertices = 1u << 24;
constexpr std::uint64_t kFewTries = 1000000, kTriesEach = 100;

/// The components, the largest first, with their vertices' numbers in the whole graph.
std::vector<std::pair<Graph, std::vector<Vertex>>> parts_of(const Graph& graph) {
  const Components components = connected_components_of(graph);
  std::vector<std::vector<Vertex>> vertices(components.count);
  std::vector<Vertex> number(graph.num_vertices());
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    std::vector<Vertex>& part = vertices[components.of[v]];
    number[v] = static_cast<Vertex>(part.size());
    part.push_back(v);
  }
  std::vector<std::vector<Edge>> edges(components.count);
  for (const auto [u, v] : graph.edges()) {
    edges[components.of[u]].push_back({number[u], number[v]});
  }
  std::vector<std::pair<Graph, std::vector<Vertex>>> parts;
  for (std::uint32_t c = 0; c < components.count; ++c) {
    parts.emplace_back(Graph(vertices[c].size(), std::move(edges[c])), std::move(vertices[c]));
  }
  std::ranges::stable_sort(parts, std::greater<>(),
                           [](const auto& part) { return part.second.size(); });
  return parts;
}

std::vector<Point> points_of(const Graph& part, const std::vector<Vertex>& vertices,
                             const SpaceNet& net) {
  const auto refuse = [&](const std::string& why) {
    throw InputError(fmt::format("no piece of the {}: the component of vertex {} ({} vertices) {}",
                                 net.name(), vertices[0], vertices.size(), why));
  };
  // Both nets are bipartite.
  if (!boost::is_bipartite(part)) refuse("has an odd cycle");
  const std::uint64_t most = kFewTries + kTriesEach * vertices.size();
  Embedding embedding = embed(part, net, most);
  if (embedding.is_given_up) {
    throw InputError(fmt::format(
        "no place found in the {} for the component of vertex {} ({} vertices) in {} tries; "
        "whether it is a piece is not decided",
        net.name(), vertices[0], vertices.size(), most));
  }
  if (embedding.points.empty()) {
    refuse(fmt::format("is no subgraph of it: all {} tries failed", embedding.tries));
  }
  return std::move(embedding.points);
}

/// Components side by side in one net (Lemma L.6): the first around the origin, every other one at
/// the first free place in cubes around it, so that small ones fill the gaps of large ones.
class Packing {
 public:
  explicit Packing(const SpaceNet& net) : net_(net) {}

  /// Returns where to move the next component; none is larger than the one before.
  Vector add(const std::vector<Point>& component) {
    const auto is_free = [&](Vector moved) {
      return std::none_of(component.begin(), component.end(),
                          [&](Point p) { return taken_.contains(p + moved); });
    };
    if (component.size() != size_) next_ = 0;
    size_ = component.size();
    Vector moved = to_the_middle(component);
    for (; !taken_.empty(); ++next_) {
      while (next_ >= translations_.size()) add_shell();
      moved = translations_[next_];
      if (is_free(moved)) break;
    }
    for (const Point p : component) taken_.insert(p + moved);
    return moved;
  }

 private:
  /// Moves the middle of the points to within 4 of the origin.
  static Vector to_the_middle(const std::vector<Point>& component) {
    GrowingBox box;
    for (const Point p : component) box.add(p);
    const auto move = [](std::int64_t low, std::int64_t high) { return -4 * ((low + high) / 8); };
    return {move(box.low().x, box.high().x), move(box.low().y, box.high().y),
            move(box.low().z, box.high().z)};
  }

  void add_shell() {
    const std::int64_t r = shell_++;
    for (std::int64_t x = -r; x <= r; ++x) {
      for (std::int64_t y = -r; y <= r; ++y) {
        const bool is_side = std::max(std::abs(x), std::abs(y)) == r;
        for (std::int64_t z = -r; z <= r; z += is_side ? 1 : 2 * r) {
          if (net_.is_translation({x, y, z})) translations_.push_back({x, y, z});
        }
      }
    }
  }

  const SpaceNet& net_;
  std::vector<Vector> translations_;  // by their largest coordinate, those below shell_
  std::int64_t shell_ = 0;
  std::size_t size_ = 0, next_ = 0;  // of the component before, and where it went
  std::unordered_set<Point, PointHash> taken_;
};

Algorithm row_of(const SpaceNet& net) {
  Algorithm row;
  row.name = net.algorithm();
  row.summary = fmt::format("pieces of the {} as they lie there, without bends", net.name());
  row.source = "Figure 1";
  row.by_name_only = true;
  row.guarantee.max_degree = static_cast<std::uint32_t>(net.steps({}).size());
  row.guarantee.max_bends = 0;
  row.guarantee.lattice = kCubeLattice;
  row.guarantee.bound = {"proved here", "docs/lower-bounds.md", {linear(8), linear(8), linear(8)}};
  return row;
}

}  // namespace

Drawing draw(const Graph& graph, const SpaceNet& net) {
  refuse_larger_degrees(net.algorithm(), graph, static_cast<std::uint32_t>(net.steps({}).size()));
  refuse_more_vertices(net.algorithm(), graph, kMostVertices);
  Coordinates vertices(graph.num_vertices(), 4 * std::int64_t{graph.num_vertices()});
  Packing packing(net);
  for (const auto& [part, numbers] : parts_of(graph)) {
    const std::vector<Point> points = points_of(part, numbers, net);
    const Vector moved = packing.add(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      vertices.set(numbers[i], points[i] + moved);
    }
  }
  auto bends = std::make_shared<StoredBends>();
  for (EdgeId e = 0; e < graph.num_edges(); ++e) bends->add_edge({});
  return Drawing(net.algorithm(), kCubeLattice, std::move(vertices), graph.shared_edges(),
                 std::move(bends));
}

Algorithm row_109() {
  Algorithm row = row_of(SpaceNet::diamond());
  row.guarantee.cosine = {-1, 3};
  row.guarantee.directions = {{1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {-1, 1, 1}};
  row.draw = [](const Graph& graph, const Settings&) { return draw(graph, SpaceNet::diamond()); };
  return row;
}

Algorithm row_120() {
  Algorithm row = row_of(SpaceNet::laves());
  row.guarantee.cosine = {-1, 2};
  row.guarantee.directions = {{1, 1, 0}, {1, -1, 0}, {1, 0, 1}, {1, 0, -1}, {0, 1, 1}, {0, 1, -1}};
  row.draw = [](const Graph& graph, const Settings&) { return draw(graph, SpaceNet::laves()); };
  return row;
}

}  // namespace ar3d::lattice
