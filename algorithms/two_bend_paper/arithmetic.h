#pragma once

#include <string>

namespace ar3d::two_bend_paper {

/// How the arithmetic in which this library's drawings are made departs from IEEE 754, as
/// ar3d::arithmetic_departures() (base/ieee_arithmetic.h) tells.
std::string arithmetic_departures();

}  // namespace ar3d::two_bend_paper
