#pragma once

#include "ar3d/algorithms/algorithm.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/verify/metrics/metrics.h"

namespace spokes {

/// Draws disjoint paths of at most three vertices,
/// each straight along x, one beside the other. Maximum degree 2, no bends, 180 degrees at every
/// vertex; graphs with longer paths or cycles are refused.
ar3d::Algorithm algorithm();

/// Disjoint paths of three vertices.
ar3d::Family family();

/// Number of segments.
ar3d::Metric metric();

}  // namespace spokes
