// Step E.4: all that is drawn, and whether a new segment meets it. A few operations in float with a
// bound of their rounding error rule out nearly every pair, several pairs at a time; only those in
// doubt are compared exactly, in 128-bit integers and in 256 bits where those might not do, so the
// answer is that of exact arithmetic alone. Cost: O(1) for every segment drawn since the lower end
// of the edge, as all older ones lie lower.
#include "ar3d/algorithms/two_bend_109/drawn_segments.h"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>

#include "ar3d/algorithms/two_bend_109/stubs.h"

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

bool meets_stub(const LatticeSegment& segment, const VertexStubs& star) {
  for (std::size_t i = 0; i < 4; ++i) {
    if (meet(segment, star.segment(i))) return true;
  }
  return false;
}

/// The line through a segment, rounded: direction u and moment p x u.
std::array<float, 6> rounded_line(const LatticeSegment& segment) {
  const Point p = segment.from;
  const Vector u = segment.to - p;
  // Moments, below 2^123, are scaled so that products with directions, below 2^62, fit a float.
  const auto moment = [](std::int64_t a, std::int64_t v, std::int64_t b, std::int64_t w) {
    return static_cast<float>(static_cast<double>(Int128{a} * v - Int128{b} * w) * 0x1p-60);
  };
  return {static_cast<float>(u.x),    static_cast<float>(u.y),    static_cast<float>(u.z),
          moment(p.y, u.z, p.z, u.y), moment(p.z, u.x, p.x, u.z), moment(p.x, u.y, p.y, u.x)};
}

/// How many of begin ... end - 1 pass the filter; without branches, so that the compiler tests
/// several at a time.
template <class Filter>
inline int count_doubts(const Filter& filter, std::size_t begin, std::size_t end) {
  int doubts = 0;
  for (std::size_t i = begin; i < end; ++i) doubts += filter(i) ? 1 : 0;
  return doubts;
}

#if defined(__x86_64__) && defined(__GNUC__)
template <class Filter>
__attribute__((target("avx2"))) int count_doubts_avx2(const Filter& filter, std::size_t begin,
                                                      std::size_t end) {
  int doubts = 0;
  for (std::size_t i = begin; i < end; ++i) doubts += filter(i) ? 1 : 0;
  return doubts;
}
const bool kHasAvx2 = __builtin_cpu_supports("avx2") != 0;
#endif

template <class Filter>
int doubts_in(const Filter& filter, std::size_t begin, std::size_t end) {
#if defined(__x86_64__) && defined(__GNUC__)
  if (kHasAvx2) return count_doubts_avx2(filter, begin, end);
#endif
  return count_doubts(filter, begin, end);
}

/// Whether is_met(i) for some i in begin ... end - 1 that passes the filter.
template <class Filter, class IsMet>
bool any_in_doubt(const Filter& filter, std::size_t begin, std::size_t end, IsMet&& is_met) {
  constexpr std::size_t kBlock = 256;
  for (std::size_t first = begin; first < end; first += kBlock) {
    const std::size_t last = std::min(end, first + kBlock);
    if (doubts_in(filter, first, last) == 0) continue;
    for (std::size_t i = first; i < last; ++i) {
      if (filter(i) && is_met(i)) return true;
    }
  }
  return false;
}

}  // namespace

bool are_parallel(Vector u, Vector v) { return is_zero(cross(u, v)); }

bool meet(const LatticeSegment& a, const LatticeSegment& b) {
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

void DrawnSegments::add_star(const VertexStubs& star) {
  stars_.push_back(star);
  star_x_.push_back(static_cast<float>(star.at.x));
  star_z_.push_back(static_cast<float>(star.at.z));
  largest_x_ = std::max(largest_x_, std::abs(star_x_.back()));
  largest_z_ = std::max(largest_z_, std::abs(star_z_.back()));
}

void DrawnSegments::add_line(const LatticeSegment& segment) {
  lines_.push_back(segment);
  const std::array<float, 6> line = rounded_line(segment);
  for (std::size_t k = 0; k < 6; ++k) of_line_[k].push_back(line[k]);
}

bool DrawnSegments::meets_any(const LatticeSegment& segment, DrawnCount since,
                              std::size_t stub) const {
  for (std::size_t i = 0; i < 4; ++i) {
    if (i != stub && meet(segment, stars_[since.stars].segment(i))) return true;
  }
  return meets_star(segment, since.stars + 1) || meets_line(segment, since.lines);
}

/// A star can be met only where the segment, which runs `per_rise` in x for each unit of z, passes
/// it within `reach`.
bool DrawnSegments::meets_star(const LatticeSegment& segment, std::size_t since) const {
  const auto x = static_cast<float>(segment.from.x), z = static_cast<float>(segment.from.z);
  const Vector u = segment.to - segment.from;
  float per_rise = 0;
  float reach = std::numeric_limits<float>::infinity();
  if (is_filtered_ && u.z > 0) {
    per_rise = static_cast<float>(static_cast<double>(u.x) / static_cast<double>(u.z));
    const float run = std::abs(per_rise);
    // Each number is rounded by 2^-24 of its size at most, and there are five operations.
    reach = kStubX + kStubZ * run + 1 +
            0x1p-20F * (std::abs(x) + largest_x_ + run * (std::abs(z) + largest_z_));
  }
  const auto may_pass = [=, star_x = star_x_.data(), star_z = star_z_.data()](std::size_t i) {
    return std::abs((x - star_x[i]) + (star_z[i] - z) * per_rise) <= reach;
  };
  return any_in_doubt(may_pass, since, stars_.size(),
                      [&](std::size_t i) { return meets_stub(segment, stars_[i]); });
}

/// Two lines meet only if u1 m2 + u2 m1 = 0 for their directions u and moments m.
bool DrawnSegments::meets_line(const LatticeSegment& segment, std::size_t since) const {
  const std::array<float, 6> line = rounded_line(segment);
  std::array<float, 6> factor{};
  std::array<const float*, 6> others{};
  for (std::size_t k = 0; k < 6; ++k) {
    if (is_filtered_) factor[k] = line[(k + 3) % 6];  // moments meet directions
    others[k] = of_line_[k].data();
  }
  const auto may_be_coplanar = [factor, others](std::size_t i) {
    float sum = 0;
    float size = 0;
    for (std::size_t k = 0; k < 6; ++k) {
      const float product = factor[k] * others[k][i];
      sum += product;
      size += std::abs(product);
    }
    // Both factors are rounded by 2^-24 of their size at most, each product and each of the five
    // additions, too (a little more in all): the error of the sum is below 2^-20 of `size`.
    constexpr float kDoubt = 0x1p-20F;
    return std::abs(sum) <= kDoubt * size;
  };
  return any_in_doubt(may_be_coplanar, since, lines_.size(),
                      [&](std::size_t i) { return meet(segment, lines_[i]); });
}

}  // namespace ar3d::two_bend_109
