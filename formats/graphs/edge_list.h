#pragma once

#include "ar3d/formats/graphs/graph_format.h"

namespace ar3d {

/// One edge "u v" per line; comments begin with # or %. A line "# vertices N", "% vertices N" or "n
/// N" begins a graph with N vertices; edges without such a line make a graph up to the largest id.
GraphFormat edge_list_format();

}  // namespace ar3d
