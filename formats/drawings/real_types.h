#pragma once

#include "ar3d/model/real_points.h"

namespace ar3d {

/// @throws InputError if the type is none of float, double, long double, binary128 and reference,
/// or naming the first vertex, else the first bend in order of edges, with a coordinate that needs
/// more significant bits than the type has (24, 53, 64, 113, 237).
void require_values_of_type(const RealPoints& points);

}  // namespace ar3d
