// Step D.6: four levels, so that the ends of an edge are far apart in a narrow strip, and few
// sources and sinks. Nothing is proved of it but that the order is right: Lemma D.8 gives the moved
// order to every component of the graph on which the sweeps fail. Cost: O(n) for each of a bounded
// number of sweeps; O(n log n) where a component gets the moved order, whose paths are measured
// rank by rank.
#include "ar3d/algorithms/compact_120/levels.h"

#include <algorithm>
#include <array>
#include <utility>

namespace ar3d::compact_120 {
namespace {

constexpr unsigned kLevels = 4;
constexpr int kSweeps = 5;  ///< before owners are tried
constexpr int kSweepsOfRepair = 4;

class Sweeper {
 public:
  Sweeper(const Graph& graph, RandomStream random)
      : graph_(graph), random_(random), left_(graph.num_vertices(), 0) {
    order_.rank.assign(graph.num_vertices(), 0);
    for (Vertex v = 0; v < graph.num_vertices(); ++v) {
      const auto used = levels_of_neighbours(v);
      do {
        order_.rank[v] = random_.below(kLevels);
      } while (used[order_.rank[v]]);
    }
    for (const Edge& edge : graph.edges()) {
      ++left_[order_.is_right(edge.u, edge.v) ? edge.v : edge.u];
    }
  }

  void sweep() {
    for (Vertex v = 0; v < graph_.num_vertices(); ++v) improve(v);
  }

  /// Some vertices and their neighbours, from a new random start: there the sweeps are stuck.
  void repair(const std::vector<Vertex>& vertices) {
    for (const Vertex v : vertices) {
      const auto used = levels_of_neighbours(v);
      const std::uint32_t level = random_.below(kLevels);
      if (!used[level]) move(v, level);
    }
    for (int i = 0; i < kSweepsOfRepair; ++i) sweep(vertices);
  }

  /// The order, sources of degree 3 at the lowest level, sinks at the highest one.
  Order order() const {
    Order result = order_;
    for (Vertex v = 0; v < graph_.num_vertices(); ++v) {
      if (graph_.degree(v) < 3) continue;
      if (left_[v] == 0) result.rank[v] = 0;
      if (left_[v] == 3) result.rank[v] = kLevels - 1;
    }
    return result;
  }

 private:
  void sweep(const std::vector<Vertex>& vertices) {
    for (const Vertex v : vertices) {
      improve(v);
      for (const HalfEdge& edge : graph_.incident(v)) improve(edge.to);
    }
  }

  std::array<bool, kLevels> levels_of_neighbours(Vertex v) const {
    std::array<bool, kLevels> used{};
    for (const HalfEdge& edge : graph_.incident(v)) used[order_.rank[edge.to]] = true;
    return used;
  }

  bool is_extreme(Vertex v, int left) const {
    return graph_.degree(v) == 3 && (left == 0 || left == 3);
  }

  /// Sources and sinks among v and its neighbours if v had this level.
  int extremes_at(Vertex v, std::uint32_t level) const {
    int left = 0;
    int found = 0;
    for (const HalfEdge& edge : graph_.incident(v)) {
      const std::uint32_t other = order_.rank[edge.to];
      left += other < level ? 1 : 0;
      const int moved = (level < other ? 1 : 0) - (order_.rank[v] < other ? 1 : 0);
      found += is_extreme(edge.to, left_[edge.to] + moved) ? 1 : 0;
    }
    return found + (is_extreme(v, left) ? 1 : 0);
  }

  /// Moves v to the best level, a random one of equals: standing still would end in a poor order.
  void improve(Vertex v) {
    const auto used = levels_of_neighbours(v);
    std::uint32_t best = order_.rank[v];
    int fewest = extremes_at(v, best);
    const std::uint32_t first = random_.below(kLevels);
    for (std::uint32_t i = 0; i < kLevels; ++i) {
      const std::uint32_t level = (first + i) % kLevels;
      if (used[level] || level == order_.rank[v]) continue;
      const int found = extremes_at(v, level);
      if (found <= fewest) {
        fewest = found;
        best = level;
      }
    }
    move(v, best);
  }

  void move(Vertex v, std::uint32_t level) {
    if (level == order_.rank[v]) return;
    left_[v] = 0;
    for (const HalfEdge& edge : graph_.incident(v)) {
      const std::uint32_t other = order_.rank[edge.to];
      left_[edge.to] = static_cast<std::uint8_t>(left_[edge.to] + (level < other ? 1 : 0) -
                                                 (order_.rank[v] < other ? 1 : 0));
      left_[v] = static_cast<std::uint8_t>(left_[v] + (other < level ? 1 : 0));
    }
    order_.rank[v] = level;
  }

  const Graph& graph_;
  RandomStream random_;
  Order order_;
  std::vector<std::uint8_t> left_;  ///< by vertex: neighbours to the left
};

std::vector<Position> positions_by_level(const Order& order) {
  std::vector<Position> position;
  position.reserve(order.rank.size());
  for (const std::uint32_t level : order.rank) {
    position.push_back(static_cast<Position>(100 * level / (kLevels - 1)));
  }
  return position;
}

/// The longest ascending paths to and from every vertex, as a share.
std::vector<Position> positions_by_paths(const Graph& graph, const Order& order) {
  const Order before = in_levels(graph, order);
  Order reversed = order;
  const std::uint32_t most =
      order.rank.empty() ? 0 : *std::max_element(order.rank.begin(), order.rank.end());
  for (std::uint32_t& rank : reversed.rank) rank = most - rank;
  const Order after = in_levels(graph, reversed);
  std::vector<Position> position(order.rank.size(), 50);
  for (std::size_t v = 0; v < position.size(); ++v) {
    const std::uint32_t both = before.rank[v] + after.rank[v];
    if (both > 0) position[v] = static_cast<Position>(100 * before.rank[v] / both);
  }
  return position;
}

}  // namespace

NarrowOrder narrow_order(const Graph& graph, RandomStream random, int repairs) {
  Sweeper sweeper(graph, random);
  for (int i = 0; i < kSweeps; ++i) sweeper.sweep();
  Order order = sweeper.order();
  Owners owners = choose_owners(graph, order);
  for (int i = 0; i < repairs && !owners.crowded.empty(); ++i) {
    sweeper.repair(owners.crowded);
    order = sweeper.order();
    owners = choose_owners(graph, order);
  }
  NarrowOrder result;
  result.position = positions_by_level(order);
  if (!owners.crowded.empty()) {
    const Components components = connected_components_of(graph);
    std::vector<bool> is_crowded(components.count, false);
    for (const Vertex v : owners.crowded) is_crowded[components.of[v]] = true;
    result.moved_components = std::count(is_crowded.begin(), is_crowded.end(), true);
    const Order moved = moved_order(graph);
    const std::vector<Position> by_paths = positions_by_paths(graph, moved);
    for (Vertex v = 0; v < graph.num_vertices(); ++v) {
      if (!is_crowded[components.of[v]]) continue;
      order.rank[v] = moved.rank[v];
      result.position[v] = by_paths[v];
    }
    owners = choose_owners(graph, order);
  }
  result.links = assign_arms(graph, order, owners);
  return result;
}

}  // namespace ar3d::compact_120
