#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "ar3d/model/graph.h"

namespace ar3d {

/// Searches breadth first for shortest cycles among the vertices of a graph that still count.
class ShortestCycleSearch {
 public:
  explicit ShortestCycleSearch(std::size_t num_vertices)
      : depth_(num_vertices, kUnreached), parent_(num_vertices), branch_(num_vertices) {}

  /// A shortest cycle through the root, from it on, in cyclic order; empty if all are longer. An
  /// edge between two branches closes a cycle through the root, and a shortest one has such an edge
  /// whose ends are reached on shortest ways: of those with the least sum of depths the first.
  /// @param star  star(v) are the half edges at v. @param is_gone  vertices that do not count.
  /// Cost: the edges within half of the length found, at most of `longest`.
  template <class Star>
  std::vector<Vertex> through(Vertex root, std::size_t longest, const Star& star,
                              const std::vector<bool>& is_gone) {
    std::size_t best = longest + 1;
    std::pair<Vertex, Vertex> closing;
    std::vector<Vertex> reached{root};
    depth_[root] = 0;
    parent_[root] = branch_[root] = root;
    std::size_t i = 0;
    for (; i < reached.size() && 2 * std::size_t{depth_[reached[i]]} + 1 < best; ++i) {
      const Vertex a = reached[i];
      for (const HalfEdge half : star(a)) {
        const Vertex b = half.to;
        if (is_gone[b] || b == parent_[a]) continue;
        const std::size_t length = std::size_t{depth_[a]} + depth_[b] + 1;
        if (depth_[b] == kUnreached) {
          depth_[b] = depth_[a] + 1;
          parent_[b] = a;
          branch_[b] = a == root ? b : branch_[a];
          reached.push_back(b);
        } else if (branch_[a] != branch_[b] && length < best) {
          best = length;
          closing = {a, b};
        }
      }
    }
    is_all_reached_ = i == reached.size();
    std::vector<Vertex> cycle;
    if (best <= longest) {
      for (Vertex v = closing.first; v != root; v = parent_[v]) cycle.push_back(v);
      cycle.push_back(root);
      std::reverse(cycle.begin(), cycle.end());
      for (Vertex v = closing.second; v != root; v = parent_[v]) cycle.push_back(v);
    }
    for (const Vertex v : reached) depth_[v] = kUnreached;
    return cycle;
  }
  /// Returns whether the last search went through all that the root is connected to.
  bool is_all_reached() const { return is_all_reached_; }

 private:
  static constexpr std::uint32_t kUnreached = std::numeric_limits<std::uint32_t>::max();

  std::vector<std::uint32_t> depth_;  // kUnreached between searches
  std::vector<Vertex> parent_;
  std::vector<Vertex> branch_;  // the child of the root through which a vertex was reached
  bool is_all_reached_ = false;
};

}  // namespace ar3d
