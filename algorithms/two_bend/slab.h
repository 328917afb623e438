#pragma once

#include <array>
#include <cstdint>

#include "ar3d/algorithms/two_bend/blocks.h"
#include "ar3d/algorithms/two_bend/layout.h"
#include "ar3d/algorithms/two_bend/leans.h"
#include "ar3d/algorithms/two_bend/output.h"

namespace ar3d::two_bend {

/// Holds what one vertex takes of the height: everything slanted that belongs to it lies between z
/// - below and z + above.
struct SlabHeights {
  std::int64_t below = 0;
  std::int64_t above = 0;
};

/// Slabs of all nodes (Step 2.11).
struct Slabs {
  LongVector<SlabHeights> of_node;
  std::int64_t lean_excess = 0;  ///< what leans into arms add to the height at most (Lemma 2.18)
  std::int64_t left = kMaxHorizontal;   ///< least x of a bend, if it is less
  std::int64_t front = kMaxHorizontal;  ///< least y of a bend, if it is less
};

/// Draws the bends of all long edges into the output, relative to their slabs (Output::bends).
Slabs draw_slabs(const Flow& flow, const Layout& layout, Output& output);

/// Returns where a long edge is vertical, between its lower and its upper bends; z = 0.
Point ray_of(const Flow& flow, const Layout& layout, const LongEdge& edge);

/// One way to lay a component out.
struct Attempt {
  Flow flow;
  Layout layout;
  Slabs slabs;
};

/// Step 2.11: gives every vertex its own slab in time order (z), x and y from rays and poles, and
/// writes vertices and bends, translated so that the smallest x and y of the component are 0. Cost:
/// O(n).
/// @param order  the time order of the component's vertices.
void stack_slabs(const LocalGraph& graph, const LongVector<Vertex>& order, const Attempt& attempt,
                 const LongVector<QBody>& bodies, Output& output);

/// Holds how far a Q body reaches from its joint: to both sides in its plane, and away from it.
inline constexpr std::int64_t kQHalfWidth = 3;
inline constexpr std::int64_t kQHeight = 9;

/// Holds what every fixed body (K4, K3,3, a Q on its own) and a single vertex keep within.
inline constexpr std::array<std::int64_t, 3> kFixedBodyBound{14, 10, 21};

/// Draws the five vertices of a Q, its joint at `at`: two regular hexagons in a vertical plane.
/// Upwards in the plane x = const (above an END), or downwards in the plane y = const (below a
/// START).
void draw_q_body(const LocalGraph& graph, const QBody& body, Point at, bool upwards,
                 Output& output);

/// Draws K4 or K3,3 from a table. @return false (nothing drawn) if the component is neither.
bool draw_small_cubic(const LocalGraph& graph, Output& output);

}  // namespace ar3d::two_bend
