#pragma once

#include "ar3d/formats/graphs/graph_format.h"

namespace ar3d {

/// A vertex a line, "u: v w …" (the colon may be missing); an edge may stand at one of its ends or
/// at both. Comments and "# vertices N" as in edge lists.
GraphFormat adjacency_list_format();

}  // namespace ar3d
