#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ar3d/model/drawing.h"
#include "ar3d/model/real_points.h"

namespace ar3d {

/// A drawing made in a real type. Its own integer points are a picture for viewers and exports:
/// the nearest multiples of a power of two, at most 2^-30, that lets all of them fit. Its exact
/// points are Drawing::real; whoever judges it reads these.
/// @param edges  in the order of the bends of `points`.
/// @throws InputError if the numbers of vertices or edges do not fit.
Drawing real_drawing(std::string algorithm, std::shared_ptr<const std::vector<Edge>> edges,
                     RealPoints points);

}  // namespace ar3d
