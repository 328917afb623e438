#pragma once

// Theorem 1, guaranteed mode: an order of a colour's items in which neighbours in the order can
// touch.

#include "ar3d/algorithms/diamond/items.h"

namespace ar3d::diamond {

/// Items in an order and direction such that the last vertex of one and the first vertex of the
/// next are not adjacent, with at most one exception if n >= 4, and none if there are at least 6
/// items; an exception is a bad boundary. Proof: Lemma 1.3. Cost: O(n).
Arrangement order_items(const Graph& graph, const Items& items);

bool adjacent(const Graph& graph, Vertex u, Vertex v);

/// bad[i] (i >= 1): items i-1 and i, laid side by side, would put two adjacent vertices on
/// neighbouring lines.
std::vector<bool> bad_boundaries(const Graph& graph, const Items& items);

}  // namespace ar3d::diamond
