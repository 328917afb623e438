#pragma once

#include <optional>
#include <utility>

#include "ar3d/model/drawing.h"

namespace ar3d::verify {

using VertexPair = std::pair<Vertex, Vertex>;

/// Two vertices at the smallest distance in the drawing's metric; nothing if there are fewer than
/// two. Distances are compared exactly. By strips where these apply, else by the tree: the same
/// distance, not always the same of several closest pairs.
/// @throws InputError if the drawing's Gram matrix is not positive definite.
std::optional<VertexPair> closest_pair(const Drawing& drawing);

/// The plain version, for vertices in range: an R-tree gives those near each vertex, in a fixed
/// random order, so that few are. O(n log^2 n) expected time where vertices are spread evenly.
std::optional<VertexPair> closest_pair_by_tree(const Drawing& drawing);

/// A radix sort along the widest axis, strips as wide as a distance that was seen, each sorted
/// along the second widest. O(n log n) time besides the pairs that are looked at, 16 bytes per
/// vertex (32 if an extent passes 2^32); nothing if the pairs are more than 60 per vertex, if the
/// smallest squared distance passes 2^40, in units of the Gram matrix, or if the coordinates are
/// not in_range().
/// @pre two vertices at least, and a positive definite Gram matrix.
std::optional<VertexPair> closest_pair_by_strips(const Drawing& drawing);

}  // namespace ar3d::verify
