#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ar3d/model/graph.h"

namespace ar3d::two_bend_109 {

/// The vertices of a graph that are in no part yet.
class Rest {
 public:
  explicit Rest(const Graph& graph);
  bool has(Vertex v) const { return degree_[v] >= 0; }
  std::uint32_t degree(Vertex v) const { return static_cast<std::uint32_t>(degree_[v]); }
  void remove(Vertex v);

 private:
  const Graph& graph_;
  std::vector<std::int8_t> degree_;  ///< -1: not there
};

/// The components of a core without an induced cycle.
struct Pieces {
  std::vector<std::vector<Vertex>> of;
  std::vector<bool> alive;  ///< has a cycle or a vertex of degree below 4 in the graph
  bool has_alive() const;
  const std::vector<Vertex>* first_dead() const;  ///< null if all are alive
  /// @pre has_alive().
  const std::vector<Vertex>& largest_alive() const;
};

/// Searches in the rest of a graph. "Core" is a component of it in which all degrees are at
/// least 3.
class CycleSearch {
 public:
  CycleSearch(const Graph& graph, const Rest& rest);

  /// Half-edges that all searches have looked at, which is what they cost.
  std::uint64_t looked_at() const { return looked_at_; }
  /// The component of v, in cyclic order, if it is a cycle; else nothing. Walks over vertices of
  /// degree 2 only. @pre v has degree 2.
  std::vector<Vertex> cycle_component(Vertex v);
  std::vector<Vertex> component(Vertex v);
  /// An induced cycle in the core of root: the first one that a breadth-first search meets, which
  /// is at most 2 log2(k) + 1 long for k vertices.
  std::vector<Vertex> first_cycle(Vertex root);
  /// Whether every component of the core without the cycle is alive. Goes through each only until
  /// that is seen.
  bool leaves_all_alive(const std::vector<Vertex>& cycle);
  Pieces pieces(const std::vector<Vertex>& core, const std::vector<Vertex>& cycle);
  /// An induced cycle in `dead` and `cycle` less one vertex beside `alive`.
  std::vector<Vertex> cycle_off(const std::vector<Vertex>& cycle, const std::vector<Vertex>& dead,
                                const std::vector<Vertex>& alive);
  /// An induced cycle that leaves a living piece, nothing if there is none. Goes through all
  /// induced cycles of the core, which has at most 60 vertices where this is needed (Lemma E.2).
  std::vector<Vertex> cycle_beside_cycle(const std::vector<Vertex>& core);

 private:
  void new_marks();
  /// The half-edges of v, counted.
  std::span<const HalfEdge> look_at(Vertex v);
  bool marked(Vertex v) const { return mark_[v] == stamp_; }
  template <class Allowed>
  std::vector<Vertex> first_cycle_in(Vertex root, Allowed&& allowed);
  std::vector<Vertex> joined(Vertex x, Vertex y) const;
  bool extend_path(std::vector<Vertex>& path, const std::vector<Vertex>& core);

  const Graph& graph_;
  const Rest& rest_;
  std::uint64_t looked_at_ = 0;
  std::uint64_t stamp_ = 0;
  std::vector<std::uint64_t> mark_;
  std::vector<Vertex> parent_;  ///< in the breadth-first tree, of marked vertices
};

}  // namespace ar3d::two_bend_109
