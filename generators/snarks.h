#pragma once

#include "ar3d/generators/graph_builder.h"

namespace ar3d {

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
