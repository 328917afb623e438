#pragma once

// Compact modes of Theorem 1: where to close the largest green and the largest red cycle.

#include "ar3d/algorithms/diamond/items.h"

namespace ar3d::diamond {

/// Rotates the largest green and the largest red cycle so that their closing edges, the longest
/// edges of most drawings, run short: a closing edge costs as height half the sum of its ends'
/// distances, in the other colour's order, from the cycle's nearer border. As the rotation of one
/// colour moves the ranks of the other, pairs are judged: a fixed number of random green edges,
/// each with every red edge. @return false if there are no two such cycles. Deterministic. Cost:
/// O(n).
bool rotate_jointly(Items& green, Items& red);

}  // namespace ar3d::diamond
