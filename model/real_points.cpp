#include "ar3d/model/real_points.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "ar3d/base/error.h"

namespace ar3d {
namespace {

DyadicNumber dyadic(double value) {
  expect(std::isfinite(value), "coordinates are finite");
  if (value == 0) return {};
  int exponent = 0;
  constexpr int kBits = std::numeric_limits<double>::digits;
  auto integer = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), kBits));
  exponent -= kBits;
  while (integer % 2 == 0) {
    integer /= 2;
    ++exponent;
  }
  return {integer, exponent};
}

BigInteger in_units(const DyadicNumber& number, int unit_exponent) {
  if (number.integer == 0) return 0;
  const BigInteger shifted = abs(number.integer)
                             << static_cast<unsigned>(number.exponent - unit_exponent);
  return number.integer < 0 ? BigInteger(-shifted) : shifted;
}

}  // namespace

DyadicNumber dyadic_sum(std::span<const double> parts) {
  DyadicNumber sum;
  for (const double part : parts) {
    const DyadicNumber next = dyadic(part);
    if (next.integer == 0) continue;
    if (sum.integer == 0) {
      sum = next;
      continue;
    }
    const int exponent = std::min(sum.exponent, next.exponent);
    sum = {in_units(sum, exponent) + in_units(next, exponent), exponent};
  }
  return sum;
}

void RealPointsBuilder::add_edge(std::vector<Point> bends) {
  std::move(bends.begin(), bends.end(), std::back_inserter(bends_));
  points_.offsets.push_back(bends_.size());
}

RealPoints RealPointsBuilder::finish() const {
  int unit = std::numeric_limits<int>::max();
  const auto look_at = [&](const DyadicNumber& number) {
    if (number.integer != 0) unit = std::min(unit, number.exponent);
  };
  for (const auto* list : {&vertices_, &bends_}) {
    for (const Point& point : *list) {
      look_at(point.x);
      look_at(point.y);
      look_at(point.z);
    }
  }
  RealPoints points = points_;
  points.unit_exponent = unit == std::numeric_limits<int>::max() ? 0 : unit;
  const auto convert = [&](const std::vector<Point>& from, std::vector<BigPoint>& to) {
    to.reserve(from.size());
    for (const Point& p : from) {
      to.push_back({in_units(p.x, unit), in_units(p.y, unit), in_units(p.z, unit)});
    }
  };
  convert(vertices_, points.vertices);
  convert(bends_, points.bends);
  return points;
}

}  // namespace ar3d
