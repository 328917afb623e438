#pragma once

#include "ar3d/generators/graph_builder.h"

namespace ar3d {

/// The Kneser graph K(n, k): the k-subsets of n things in order of their bit masks, joined if
/// disjoint. Of degree (n - k choose k). K(5, 2) is the Petersen graph. @throws InputError unless 1
/// <= k and 2k <= n <= 20.
Graph kneser_graph(unsigned n, unsigned k);

/// The odd graph O_k = K(2k - 1, k - 1), k-regular: O_2 a triangle, O_3 the Petersen graph, O_4
/// 4-regular on 35 vertices. k in 2..4.
Graph odd_graph(unsigned k);

}  // namespace ar3d
