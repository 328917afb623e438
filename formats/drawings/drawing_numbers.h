#pragma once

#include <cstdint>
#include <string>

#include "ar3d/model/real_points.h"

namespace ar3d {

/// digits * 10^exponent, the digits without trailing zeros; 0 is 0 * 10^0.
struct Decimal {
  std::int64_t digits = 0;
  int exponent = 0;
};

/// Reads a number as JSON writes it, exactly.
/// @throws InputError naming it if it has more than 18 significant digits or an exponent beyond
/// 1000.
Decimal parse_decimal(const std::string& text);

/// The number in units of 10^unit. @pre unit <= number.exponent, unless it is 0.
/// @throws InputError if that passes kMaxCoordinate.
std::int64_t scaled(const Decimal& number, int unit);

/// @throws InputError if the type is none of float, double, binary80, binary128 and reference,
/// or naming the first vertex, else the first bend in order of edges, with a coordinate that needs
/// more significant bits than the type has (24, 53, 64, 113, 237).
void require_values_of_type(const RealPoints& points);

}  // namespace ar3d
