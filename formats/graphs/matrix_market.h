#pragma once

#include "ar3d/formats/graphs/graph_format.h"

namespace ar3d {

/// Matrix Market, "matrix coordinate pattern": the adjacency matrix, symmetric, or general if it is
/// symmetric.
GraphFormat matrix_market_format();

}  // namespace ar3d
