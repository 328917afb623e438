#pragma once

#include "ar3d/formats/graphs/graph_format.h"

namespace ar3d {

/// METIS: a line "n m [fmt [ncon]]", then n lines with the neighbours of a vertex each, 1-based;
/// comments begin with %. Weights and sizes are read over.
GraphFormat metis_format();

}  // namespace ar3d
