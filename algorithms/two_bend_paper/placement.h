#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ar3d/algorithms/two_bend_paper/general_position.h"
#include "ar3d/algorithms/two_bend_paper/growth.h"

namespace ar3d::two_bend_paper {

/// Where a triskelion stands: `order` are the places among Step::below of the two farthest feet t
/// and u and of the third, w. Its middle is over the line from t to u, `slide` times the height of
/// w over that line away from the foot of this height, towards u; it has arms of length `radius`.
struct Triskelion {
  std::array<std::uint8_t, 3> order{};
  bool w_is_left = false;  ///< of the way from t to u
  double slide = 0;
  double radius = 0;
};

/// All that is chosen freely for a step. The numbers are dyadic and the same for every real type:
/// what a drawing is made of is a function of them.
struct Placing {
  Foot foot;         ///< of a line
  double share = 0;  ///< of a merge: how far on the way from the first foot to the second
  Triskelion triskelion;
  std::vector<Side> sides;  ///< of a cycle
};

/// A component and the choices for it, moved so that it lies right of everything before it.
struct PlacedComponent {
  Component component;
  std::vector<Placing> placings;  ///< one for each step
  double left = 0;                ///< where K4 stands
};

/// Places every foot so that no three rays are in one plane (Steps P.3 to P.8).
/// @throws InternalError if a place is not found in kRounds rounds.
/// Cost: O(N log N) for every candidate, N the number of rays.
std::vector<PlacedComponent> place(const ContractedGraph& graph, std::vector<Component> components);

}  // namespace ar3d::two_bend_paper
