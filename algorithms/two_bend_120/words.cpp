// Lemma F.1: the words. A right bend keeps one of the two letters of a direction in its place, so
// the middle one of three directions is one of at most two; the lengths are then those of a linear
// system with determinant 1 or -1, or the middle length is free. Cost: O(1).
#include "ar3d/algorithms/two_bend_120/placement.h"
#include "ar3d/base/error.h"

namespace ar3d::two_bend_120 {
namespace {

bool bends_right(Direction d, Direction e) { return (d.plus == e.plus) != (d.minus == e.minus); }

/// The determinant of the first three numbers of each: the fourth is minus their sum.
std::int64_t determinant(const FourVector& u, const FourVector& v, const FourVector& w) {
  return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
         u[2] * (v[0] * w[1] - v[1] * w[0]);
}

/// Lengths of the first and the last segment if the middle one has length 1 and all are in a plane.
std::array<std::int64_t, 3> planar_lengths(const FourVector& first, const FourVector& middle,
                                           const FourVector& last, const FourVector& sum) {
  std::array<std::int64_t, 3> lengths{0, 1, 0};
  for (std::size_t i = 0; i < 4; ++i) {
    if (last[i] == 0 && first[i] != 0) lengths[0] = (sum[i] - middle[i]) * first[i];
    if (first[i] == 0 && last[i] != 0) lengths[2] = (sum[i] - middle[i]) * last[i];
  }
  return lengths;
}

}  // namespace

EdgeWord find_word(Direction first, Direction last, const FourVector& sum) {
  const FourVector u = to_four(first), w = to_four(last);
  if (first == last) {
    return {{first, first, first}, {0, 0, sum[static_cast<std::size_t>(first.plus)]}};
  }
  for (int plus = 0; plus < 4; ++plus) {
    for (int minus = 0; minus < 4; ++minus) {
      const Direction middle{plus, minus};
      if (plus == minus || !bends_right(first, middle) || !bends_right(middle, last)) continue;
      const FourVector v = to_four(middle);
      const std::int64_t d = determinant(u, v, w);
      const std::array<std::int64_t, 3> lengths =
          d == 0
              ? planar_lengths(u, v, w, sum)
              : std::array<std::int64_t, 3>{d * determinant(sum, v, w), d * determinant(u, sum, w),
                                            d * determinant(u, v, sum)};
      if (lengths[0] > 0 && lengths[1] > 0 && lengths[2] > 0) {
        return {{first, middle, last}, lengths};
      }
    }
  }
  throw InternalError("internal error: two vertices of an edge are joined by a word");
}

}  // namespace ar3d::two_bend_120
