#pragma once

#include "ar3d/model/lattice.h"

namespace ar3d::two_bend_109 {

struct Segment {
  Point from;
  Point to;
};

/// Whether two closed segments of positive length have a point in common. Exact for coordinates up
/// to 2^61 in absolute value.
bool meet(const Segment& a, const Segment& b);

}  // namespace ar3d::two_bend_109
