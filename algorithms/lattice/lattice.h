#pragma once

#include "ar3d/algorithms/algorithm.h"
#include "ar3d/algorithms/lattice/embedding.h"

namespace ar3d::lattice {

/// Draws a subgraph of a net as it lies there: all edges are unit steps, without bends.
/// @return all components in one net; coordinates at most 4n in absolute value (Lemma L.6).
/// @throws InputError if a degree is too large or n > 2^24; if a component is no subgraph of the
/// net: it has an odd cycle, or every way was tried; if none was found in 10^6 + 100 n tries, which
/// says so and decides nothing. Cost: see embed(); several components are
/// packed in O(n) tries for each of their sizes where boxes are full.
Drawing draw(const Graph& graph, const SpaceNet& net);

/// The rows of the catalogue: `lattice-109` in the diamond lattice, `lattice-120` in the Laves
/// graph.
Algorithm row_109();
Algorithm row_120();

}  // namespace ar3d::lattice
