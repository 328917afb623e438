#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "ar3d/algorithms/two_bend_paper/contraction.h"

namespace ar3d::two_bend_paper {

/// A shortest cycle among the given nodes of a graph, hence without chord; consecutive nodes are
/// adjacent, the last one and the first too. The first that a search from every node in the order
/// of `nodes` finds. Cost: O(nodes * edges); a search goes no deeper than half of the best length.
class ShortestCycle {
 public:
  explicit ShortestCycle(const ContractedGraph& graph);
  /// @param inside  nodes that do not count.
  std::optional<std::vector<Node>> find(const std::vector<Node>& nodes,
                                        const std::vector<bool>& inside);

 private:
  /// The two nodes where the shortest cycle through the root closes, if it is shorter than the
  /// best.
  std::optional<std::pair<Node, Node>> search(Node root, const std::vector<bool>& inside);
  std::vector<Node> way_to_root(Node node) const;

  const ContractedGraph& graph_;
  std::uint32_t best_ = 0;            // length of the best cycle so far
  std::vector<std::uint32_t> depth_;  // in the search at hand
  std::vector<Node> parent_;
  std::vector<Node> reached_;  // by the search at hand, in order
};

/// A vertex of a cycle that is added, in the order of the cycle.
struct CycleVertex {
  Node node = 0;
  EdgeId to_next = 0;
  std::optional<HalfEdge> third;  ///< its edge outside the cycle
  bool is_below = false;          ///< the other end of that edge is drawn already
  bool has_ray() const { return third.has_value() && !is_below; }
};

/// What one step of the growth adds: a node with no neighbour drawn already (line), one (pass), two
/// (merge) or three (triskelion), or a chordless cycle of at least four nodes.
enum class StepKind : std::uint8_t { line, pass, merge, triskelion, cycle };

struct Step {
  StepKind kind{};
  Node node = 0;                ///< unless a cycle is added
  std::vector<HalfEdge> below;  ///< its edges to nodes drawn already, in their order at the node
  bool has_ray = false;         ///< it has a neighbour that is not drawn yet
  std::vector<CycleVertex> cycle;
};

/// The order in which a component of the contracted graph is drawn.
struct Component {
  std::optional<std::array<Node, 4>> k4;  ///< the whole component, ascending
  std::vector<Step> steps;                ///< else; every node in one of them
  /// What the steps keep (vertical extensibility): a node drawn already has at most one neighbour
  /// that is not, and then a ray.
};

/// Components in the order of their least nodes (Steps P.2 and P.4).
/// Cost: O(n log n + m) and a ShortestCycle per cycle.
std::vector<Component> grow(const ContractedGraph& graph);

}  // namespace ar3d::two_bend_paper
