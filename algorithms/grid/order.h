#pragma once

#include <cstddef>
#include <vector>

#include "ar3d/model/graph.h"

namespace ar3d::grid {

/// One component's stretch [begin, end) of the processing order.
struct OrderPart {
  std::size_t begin = 0;
  std::size_t end = 0;
  bool cubic = false;  ///< every degree is 3; then sequence[begin] = f and sequence[end - 1] = r
};

/// The order in which vertices get their labels and positions.
/// Invariant: in a component with a vertex of degree <= 2, every vertex but the last has a later
/// neighbour, and the last one has degree <= 2. In a cubic component f comes first, r is a
/// neighbour of f and comes last, and every vertex but f and r has a later neighbour. (So every
/// vertex but r has at most two earlier ones.)
struct ProcessingOrder {
  std::vector<Vertex> sequence;
  std::vector<OrderPart> parts;
};

/// Step 3.1: reverse breadth-first orders. Cost: O(n + m).
ProcessingOrder processing_order(const Graph& graph);

}  // namespace ar3d::grid
