#pragma once

#include "ar3d/generators/graph_builder.h"

namespace ar3d {

/// Isaacs' dot product (1975) of cubic graphs: `first` without the edges ab = `cut` and cd =
/// `other_cut`, `second` without its adjacent vertices x and y; a, b are joined to the other
/// neighbours of x, and c, d to those of y. The dot product of two snarks is a snark. n = n1 + n2 -
/// 2; the vertices of `second` follow in their order.
/// @throws InputError unless the two edges are disjoint edges of `first` and xy is an edge.
Graph dot_product(const Graph& first, Edge cut, Edge other_cut, const Graph& second, Vertex x,
                  Vertex y);

/// A generalised Blanusa snark: a chain of k + 1 Petersen graphs by dot products, each cut in two
/// edges at distance `type` = 1 or 2. n = 8k + 10, m = 3n/2, cubic, no bridges, no
/// 3-edge-colouring. k = 1: the two Blanusa snarks (1946).
/// @throws InputError unless type is 1 or 2. O(k).
Graph blanusa_snark(Count k, Count type);

/// Goldberg's snark G_k (1981): k blocks of 8 vertices in a ring. n = 8k, m = 12k, cubic, no
/// bridges, no 3-edge-colouring.
/// @throws InputError unless k is odd and at least 5.
Graph goldberg_snark(Count k);

/// The double-star snark (Isaacs 1975): 30 vertices, girth 6, diameter 4.
Graph double_star_snark();

/// The Szekeres snark (1973): 50 vertices, girth 5, diameter 7.
Graph szekeres_snark();

/// The Watkins snark (1989): 50 vertices, girth 5, diameter 7.
Graph watkins_snark();

}  // namespace ar3d
