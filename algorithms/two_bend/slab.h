#pragma once

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

}  // namespace ar3d::two_bend
