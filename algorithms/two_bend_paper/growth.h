#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "ar3d/algorithms/two_bend_paper/contraction.h"

namespace ar3d::two_bend_paper {

/// A vertex of a cycle that is added, in the order of the cycle.
struct CycleVertex {
  Node node = 0;
  EdgeId to_next = 0;
  std::optional<Incidence> third;  ///< its edge outside the cycle
  bool is_below = false;           ///< the other end of that edge is drawn already
  bool has_ray() const { return third.has_value() && !is_below; }
};

/// What one step of the growth adds: a node with no neighbour drawn already (line), one (pass), two
/// (merge) or three (triskelion), or a chordless cycle of at least four nodes.
enum class StepKind : std::uint8_t { line, pass, merge, triskelion, cycle };

struct Step {
  StepKind kind{};
  Node node = 0;                 ///< unless a cycle is added
  std::vector<Incidence> below;  ///< its edges to nodes drawn already, in their order at the node
  bool has_ray = false;          ///< it has a neighbour that is not drawn yet
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
