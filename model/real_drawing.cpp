#include "ar3d/model/real_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "ar3d/base/error.h"

namespace ar3d {
namespace {

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
