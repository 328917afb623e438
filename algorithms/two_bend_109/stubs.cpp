// The tetrahedra of Lemma E.3: turned by rational quaternions, the shortest ones with the slack
// that the lemma needs; tests/algorithms/two_bend_109_bodies_test.cpp computes every angle. Mirror
// images give the other corners. Cost: O(1).
#include "ar3d/algorithms/two_bend_109/stubs.h"

#include <vector>

#include "ar3d/base/error.h"

namespace ar3d::two_bend_109 {
namespace {

Stubs upside_down(Stubs stubs) {
  for (Vector& end : stubs.ends) end.z = -end.z;
  return stubs;
}

Stubs both_up(Stance stance) {
  switch (stance) {
    case Stance::chain:
      return {{{{1, 3, 5}, {1, -3, 5}, {4, 0, -7}, {-6, 0, -3}}}, 4, 4};
    case Stance::corner:
      return {{{{-5, -1, 5}, {4, 2, 5}, {3, -3, -3}, {-2, 2, -7}}}, 4, 4};
    case Stance::triangle_right:
      return {{{{-18, 0, 21}, {20, 0, 17}, {-1, 11, -19}, {-1, -11, -19}}}, 5, 5};
    case Stance::triangle_upper:
      return {{{{9, -9, 21}, {-10, 10, 17}, {17, 5, -19}, {-16, -6, -19}}}, 5, 5};
    default:
      throw InternalError("internal error: not a stance on a cycle");
  }
}

Stubs up_and_down(Stance stance) {
  switch (stance) {
    case Stance::chain:
      return {{{{-1, -3, 13}, {2, -4, -11}, {8, 4, 1}, {-9, 3, -3}}}, 2, 2};
    case Stance::corner:
      return {{{{-7, -1, 11}, {-4, -2, -13}, {9, -3, 3}, {2, 6, -1}}}, 2, 2};
    case Stance::triangle_right:
      return {{{{4, 2, 13}, {7, 1, -11}, {-9, 3, -3}, {-2, -6, 1}}}, 2, 2};
    case Stance::triangle_upper:
      return {{{{-5, 3, 11}, {-5, 1, -13}, {10, 2, -1}, {0, -6, 3}}}, 2, 2};
    default:
      throw InternalError("internal error: not a stance on a cycle");
  }
}

}  // namespace

Stubs stubs_of(Stance stance, unsigned downs) {
  if (stance == Stance::middle) {
    return {{{{-20, 0, 17}, {18, 0, 21}, {1, 11, -19}, {1, -11, -19}}}, 5, 5};
  }
  if (stance == Stance::three_down) {
    return {{{{0, 0, 3}, {2, 0, -1}, {-1, 1, -1}, {-1, -1, -1}}}, 1, 3};
  }
  if (downs == 0) return both_up(stance);
  if (downs == 1) return up_and_down(stance);
  return upside_down(both_up(stance));
}

Stubs mirrored(Stubs stubs, bool in_x, bool in_y) {
  for (Vector& end : stubs.ends) {
    if (in_x) end.x = -end.x;
    if (in_y) end.y = -end.y;
  }
  return stubs;
}

const Stubs& stubs_by_number(std::uint8_t number) {
  static const std::vector<Stubs> all = [] {
    std::vector<Stubs> made;
    for (unsigned i = 0; i <= number_of_stubs(Stance::triangle_upper, 3, true, true); ++i) {
      const Stubs stubs = stubs_of(static_cast<Stance>(i / 16), i / 4 % 4);
      made.push_back(mirrored(stubs, i / 2 % 2 == 1, i % 2 == 1));
    }
    return made;
  }();
  return all[number];
}

}  // namespace ar3d::two_bend_109
