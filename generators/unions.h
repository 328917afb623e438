#pragma once

#include "ar3d/generators/graph_builder.h"

namespace ar3d {

/// `copies` disjoint copies of `part`, vertices numbered one copy after the other.
Graph copies_of(const Graph& part, Count copies);

/// The complete graph on n <= 5 vertices.
Graph complete_graph(Count n);

/// The complete bipartite graph with sides 0..a-1 and a..a+b-1.
Graph complete_bipartite(Count a, Count b);

/// The octahedron K_{2,2,2}: 4-regular on 6 vertices; opposite corners sum to 5.
Graph octahedron_graph();

}  // namespace ar3d
