#include "ar3d/algorithms/two_bend_109/crossings.h"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

namespace ar3d::two_bend_109 {
namespace {

__extension__ using Int128 = __int128;
using Int256 = boost::multiprecision::int256_t;

using Wide = std::array<Int128, 3>;

/// Components below 2^62: each product is below 2^124.
Wide cross(Vector u, Vector v) {
  const auto product = [](std::int64_t a, std::int64_t b) { return Int128{a} * b; };
  return {product(u.y, v.z) - product(u.z, v.y), product(u.z, v.x) - product(u.x, v.z),
          product(u.x, v.y) - product(u.y, v.x)};
}

bool is_zero(const Wide& a) { return a[0] == 0 && a[1] == 0 && a[2] == 0; }

bool is_orthogonal(const Wide& n, Vector w) {
  const double largest =
      std::max({std::abs(static_cast<double>(n[0])), std::abs(static_cast<double>(n[1])),
                std::abs(static_cast<double>(n[2]))}) *
      static_cast<double>(std::max({std::abs(w.x), std::abs(w.y), std::abs(w.z)}));
  if (largest < 0x1p124) return n[0] * w.x + n[1] * w.y + n[2] * w.z == 0;
  return Int256(n[0]) * w.x + Int256(n[1]) * w.y + Int256(n[2]) * w.z == 0;
}

bool overlap(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
  return std::max(std::min(a, b), std::min(c, d)) <= std::min(std::max(a, b), std::max(c, d));
}

/// 0 <= part / whole <= 1.
bool is_fraction(Int128 part, Int128 whole) {
  if (whole < 0) {
    part = -part;
    whole = -whole;
  }
  return 0 <= part && part <= whole;
}

Wide moment(Point p, Vector u) { return cross({p.x, p.y, p.z}, u); }

}  // namespace

bool meet(const Segment& a, const Segment& b) {
  if (!overlap(a.from.x, a.to.x, b.from.x, b.to.x) ||
      !overlap(a.from.y, a.to.y, b.from.y, b.to.y) ||
      !overlap(a.from.z, a.to.z, b.from.z, b.to.z)) {
    return false;
  }
  const Vector u = a.to - a.from;
  const Vector v = b.to - b.from;
  const Vector w = b.from - a.from;
  const Wide normal = cross(u, v);
  // On one line, boxes that overlap are segments that overlap.
  if (is_zero(normal)) return is_zero(cross(u, w));
  if (!is_orthogonal(normal, w)) return false;
  // a.from + s u = b.from + t v with s = (w x v) / (u x v), t = (w x u) / (u x v).
  const std::size_t k = normal[0] != 0 ? 0 : normal[1] != 0 ? 1 : 2;
  return is_fraction(cross(w, v)[k], normal[k]) && is_fraction(cross(w, u)[k], normal[k]);
}

namespace {

/// Moments, below 2^123, are scaled so that products with directions, below 2^62, fit a float.
float scaled(Int128 moment) { return static_cast<float>(static_cast<double>(moment) * 0x1p-60); }

/// Both factors are rounded by 2^-24 of their size at most, each product and each of the five
/// additions, too (a little more in all): the error of the sum is below 2^-20 of `size`.
constexpr float kDoubt = 0x1p-20F;

}  // namespace

void DrawnSegments::add(const Segment& segment) {
  segments_.push_back(segment);
  const Vector u = segment.to - segment.from;
  const Wide m = moment(segment.from, u);
  of_[0].push_back(static_cast<float>(u.x));
  of_[1].push_back(static_cast<float>(u.y));
  of_[2].push_back(static_cast<float>(u.z));
  for (std::size_t k = 0; k < 3; ++k) of_[3 + k].push_back(scaled(m[k]));
}

std::size_t DrawnSegments::first_met(const Segment& segment, std::size_t begin,
                                     std::size_t but) const {
  const Vector u = segment.to - segment.from;
  const Wide m = moment(segment.from, u);
  const std::array<float, 6> line = {scaled(m[0]),
                                     scaled(m[1]),
                                     scaled(m[2]),
                                     static_cast<float>(u.x),
                                     static_cast<float>(u.y),
                                     static_cast<float>(u.z)};
  const auto is_in_doubt = [&](std::size_t i) {
    float sum = 0;
    float size = 0;
    for (std::size_t k = 0; k < 6; ++k) {
      const float product = line[k] * of_[k][i];
      sum += product;
      size += std::abs(product);
    }
    return std::abs(sum) <= kDoubt * size;
  };
  constexpr std::size_t kBlock = 256;  // counted without branches
  const std::size_t end = segments_.size();
  for (std::size_t first = begin; first < end; first += kBlock) {
    const std::size_t last = std::min(end, first + kBlock);
    int doubts = 0;
    for (std::size_t i = first; i < last; ++i) doubts += is_in_doubt(i) ? 1 : 0;
    if (doubts == 0) continue;
    for (std::size_t i = first; i < last; ++i) {
      if (i != but && is_in_doubt(i) && meet(segment, segments_[i])) return i;
    }
  }
  return end;
}

}  // namespace ar3d::two_bend_109
