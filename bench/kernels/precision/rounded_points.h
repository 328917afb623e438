#pragma once

#include "ar3d/model/real_points.h"

namespace ar3d::precision {

/// The points with every coordinate rounded once to so many significant bits, to the nearest,
/// halves away from 0: what a type of those bits makes of a drawing that is computed in a wider
/// one. @pre bits > 0.
RealPoints in_bits(RealPoints points, int bits);

}  // namespace ar3d::precision
