// Points of real types as integers times a power of two: every finite binary number is one, so
// nothing is rounded.
#include "ar3d/model/real_points.h"

#include <fmt/format.h>

#include <cmath>

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

constexpr int kPictureBits = 50;  // of its coordinates
constexpr int kFinest = 30;

/// Bits of the largest coordinate, in units.
int largest_bits(const RealPoints& points) {
  BigInteger largest = 1;
  for (const auto* list : {&points.vertices, &points.bends}) {
    for (const BigPoint& p : *list) {
      for (const BigInteger* c : {&p.x, &p.y, &p.z}) {
        if (abs(*c) > largest) largest = abs(*c);
      }
    }
  }
  return static_cast<int>(msb(largest)) + 1;
}

/// value * 2^shift, rounded to the nearest integer.
std::int64_t scaled(const BigInteger& value, int shift) {
  if (shift >= 0) return static_cast<std::int64_t>(value * (BigInteger(1) << shift));
  const BigInteger half = BigInteger(1) << (-shift - 1);
  const BigInteger size = (abs(value) + half) >> -shift;
  return static_cast<std::int64_t>(value < 0 ? BigInteger(-size) : size);
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
  for (const auto* list : {&vertices_, &bends_}) {
    for (const Point& point : *list) {
      for (const DyadicNumber& number : point) {
        if (number.integer != 0) unit = std::min(unit, number.exponent);
      }
    }
  }
  RealPoints points = points_;
  points.unit_exponent = unit == std::numeric_limits<int>::max() ? 0 : unit;
  const auto convert = [&](const std::vector<Point>& from, std::vector<BigPoint>& to) {
    to.reserve(from.size());
    for (const Point& p : from) {
      to.push_back({in_units(p[0], unit), in_units(p[1], unit), in_units(p[2], unit)});
    }
  };
  convert(vertices_, points.vertices);
  convert(bends_, points.bends);
  return points;
}

Drawing real_drawing(std::string algorithm, std::shared_ptr<const std::vector<Edge>> edges,
                     RealPoints points) {
  if (points.offsets.size() != edges->size() + 1) {
    throw InputError(fmt::format("bends of {} edges, but there are {}", points.offsets.size() - 1,
                                 edges->size()));
  }
  const int shift = std::min(kFinest + points.unit_exponent, kPictureBits - largest_bits(points));
  const auto picture = [&](const BigPoint& p) -> Point {
    return {scaled(p.x, shift), scaled(p.y, shift), scaled(p.z, shift)};
  };
  Coordinates vertices(points.vertices.size(), std::int64_t{1} << kPictureBits);
  for (std::size_t v = 0; v < points.vertices.size(); ++v) {
    vertices.set(v, picture(points.vertices[v]));
  }
  auto bends = std::make_shared<StoredBends>();
  for (std::size_t e = 0; e < edges->size(); ++e) {
    std::vector<Point> list;
    for (const BigPoint& bend : points.bends_of(e)) list.push_back(picture(bend));
    bends->add_edge(list);
  }
  Drawing drawing(std::move(algorithm), kCubeLattice, std::move(vertices), std::move(edges),
                  std::move(bends));
  drawing.real = std::make_shared<const RealPoints>(std::move(points));
  return drawing;
}

}  // namespace ar3d
