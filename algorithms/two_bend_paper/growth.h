#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "ar3d/algorithms/shortest_cycle.h"
#include "ar3d/algorithms/two_bend_paper/contraction.h"
#include "ar3d/algorithms/two_bend_paper/general_position.h"

namespace ar3d::two_bend_paper {

/// A shortest cycle among the given nodes of a graph, hence without chord, in cyclic order: the
/// first that a search from every node in the order of `nodes` finds; empty if there is none.
/// @param inside  nodes that do not count. Cost: O(nodes * edges); a search goes no deeper than
/// half of the best length.
std::vector<Node> shortest_cycle(const ContractedGraph& graph, const std::vector<Node>& nodes,
                                 const std::vector<bool>& inside, ShortestCycleSearch& search);

/// A vertex of a cycle that is added, in the order of the cycle.
struct CycleVertex {
  Node node = 0;
  EdgeId to_next = 0;
  std::optional<HalfEdge> third;  ///< its edge outside the cycle
  bool is_below = false;          ///< the other end of that edge is drawn already
  bool has_ray() const { return third.has_value() && !is_below; }
};

/// Says what one step of the growth adds: a node with no neighbour drawn already (line), one
/// (pass), two (merge) or three (triskelion), or a chordless cycle of at least four nodes.
enum class StepKind : std::uint8_t { line, pass, merge, triskelion, cycle };

/// One step of the growth, then all that place() chooses freely for it. The numbers are dyadic and
/// the same for every real type: what a drawing is made of is a function of them.
struct Step {
  StepKind kind{};
  Node node = 0;                ///< unless a cycle is added
  std::vector<HalfEdge> below;  ///< its edges to nodes drawn already, in their order at the node
  bool has_ray = false;         ///< it has a neighbour that is not drawn yet
  std::vector<CycleVertex> cycle;

  Foot foot;                ///< of a line
  double share = 0;         ///< of a merge: how far on the way from the first foot to the second
  std::vector<Side> sides;  ///< of a cycle

  /// Of a triskelion: the indices in `below` of the two farthest feet t and u and of the third, w.
  /// Its middle is over the line from t to u, `slide` times the height of w over that line away
  /// from the foot of this height, towards u; it has arms of length `radius`.
  std::array<std::uint8_t, 3> order{};
  bool w_is_left = false;  ///< of the way from t to u
  double slide = 0;
  double radius = 0;
};

/// The order in which a component of the contracted graph is drawn.
struct Component {
  std::optional<std::array<Node, 4>> k4;  ///< the whole component, ascending
  double left = 0;                        ///< where it stands
  std::vector<Step> steps;                ///< else; every node in one of them
  /// All steps keep this (vertical extensibility): a node drawn already has at most one
  /// neighbour that is not, and then a ray.
};

/// Components in the order of their least nodes (Steps P.2 and P.4).
/// Cost: O(n log n + m) and a shortest_cycle() per cycle.
std::vector<Component> grow(const ContractedGraph& graph);

/// Places every foot so that no three rays are in one plane, and each component right of those
/// before it (Steps P.3 to P.8).
/// @throws InternalError if a place is not found in kRounds rounds.
/// Cost: O(N log N) for every candidate, N the number of rays.
void place(const ContractedGraph& graph, std::vector<Component>& components);

}  // namespace ar3d::two_bend_paper
