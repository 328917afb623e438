#pragma once

#include <string>

namespace ar3d::two_bend_paper {

/// Tells, by computing, how the arithmetic in which this library's drawings are made departs from
/// IEEE 754: products and sums contracted to one rounding, sums reordered, more precision kept than
/// the type has, denormal numbers lost, NaN taken for a number. Empty if it does not.
std::string arithmetic_departures();

}  // namespace ar3d::two_bend_paper
