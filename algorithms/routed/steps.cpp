// The two classes of points in which edges are routed, with what the angles allow: a segment in
// direction d turns to e if d . e = 1, and edges leave a vertex in directions with inner product -1.
// Both are arccos(-1/3) between body diagonals and 120 degrees between face diagonals. Why a class:
// Lemma R.1. Cost: O(1).
#include "ar3d/algorithms/routed/steps.h"

namespace ar3d::routed {
namespace {

/// One direction of each line, so that the opposite of direction 2i is 2i + 1.
constexpr std::array<Spot, 4> kBody = {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}};
constexpr std::array<Spot, 6> kFace = {
    {{1, 1, 0}, {1, -1, 0}, {1, 0, 1}, {1, 0, -1}, {0, 1, 1}, {0, 1, -1}}};

Directions bit(int d) { return static_cast<Directions>(1u << d); }

}  // namespace

PointClass::PointClass(bool is_body) : is_body_(is_body) {
  const auto add = [this](Spot d) { steps_.insert(steps_.end(), {d, -1 * d}); };
  for (const Spot d : kBody) {
    if (is_body) add(d);
  }
  for (const Spot d : kFace) {
    if (!is_body) add(d);
  }
  const int count = num_directions();
  for (int d = 0; d < count; ++d) {
    for (int e = 0; e < count; ++e) {
      if (dot(step(d), step(e)) == 1) turns_[static_cast<std::size_t>(d)] |= bit(e);
    }
  }
  const auto apart = [this](int a, int b) { return dot(step(a), step(b)) == -1; };
  for (int a = 0; a < count; ++a) {
    for (int b = a + 1; b < count; ++b) {
      for (int c = b + 1; c < count; ++c) {
        if (!apart(a, b) || !apart(a, c) || !apart(b, c)) continue;
        if (!is_body) frames_.push_back(bit(a) | bit(b) | bit(c));
        for (int d = c + 1; d < count && is_body; ++d) {
          if (apart(a, d) && apart(b, d) && apart(c, d)) {
            frames_.push_back(bit(a) | bit(b) | bit(c) | bit(d));
          }
        }
      }
    }
  }
}

const PointClass& PointClass::body() {
  static const PointClass points(true);
  return points;
}

const PointClass& PointClass::face() {
  static const PointClass points(false);
  return points;
}

}  // namespace ar3d::routed
