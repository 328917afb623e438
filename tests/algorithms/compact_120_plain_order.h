#pragma once

// Step D.6 as plainly as it is written: every question is asked of the graph again, and after every
// repair all owners are chosen anew. What the program does faster is held against this.

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "ar3d/algorithms/compact_120/order.h"
#include "ar3d/base/random.h"

namespace ar3d::compact_120::plain {

constexpr unsigned kLevels = 4;
constexpr int kSweeps = 5;  ///< before owners are tried
constexpr int kSweepsOfRepair = 4;

class PlainSweeper {
 public:
  PlainSweeper(const Graph& graph, RandomStream random)
      : graph_(graph), random_(random), left_(graph.num_vertices(), 0) {
    order_.rank.assign(graph.num_vertices(), 0);
    for (Vertex v = 0; v < graph.num_vertices(); ++v) {
      const auto used = levels_of_neighbours(v);
      do {
        order_.rank[v] = static_cast<std::uint16_t>(random_.below(kLevels));
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
    order_.rank[v] = static_cast<std::uint16_t>(level);
  }

  const Graph& graph_;
  RandomStream random_;
  Order order_;
  std::vector<std::uint8_t> left_;  ///< by vertex: neighbours to the left
};

/// The order that repairs end with, and its owners.
inline std::pair<Order, Owners> swept_order(const Graph& graph, RandomStream random, int repairs) {
  PlainSweeper sweeper(graph, random);
  for (int i = 0; i < kSweeps; ++i) sweeper.sweep();
  Order order = sweeper.order();
  Owners owners = choose_owners(graph, order);
  for (int i = 0; i < repairs && !owners.crowded.empty(); ++i) {
    sweeper.repair(owners.crowded);
    order = sweeper.order();
    owners = choose_owners(graph, order);
  }
  return {std::move(order), std::move(owners)};
}

}  // namespace ar3d::compact_120::plain
