#pragma once

#include <cstdint>
#include <vector>

#include "ar3d/base/long_vector.h"
#include "ar3d/model/lattice.h"

namespace ar3d::two_bend_109 {

struct LatticeSegment {
  Point from;
  Point to;
  bool operator==(const LatticeSegment&) const = default;
};

/// True if two segments of positive length have a point in common. Coordinates up to 2^60 in
/// absolute value.
bool meet(const LatticeSegment& a, const LatticeSegment& b);

/// Components below 2^62 in absolute value.
bool are_parallel(Vector u, Vector v);

/// A stub, a middle or any segment of a body.
struct DrawnSegment {
  LatticeSegment at;    ///< from its lower end upwards
  std::uint32_t owner;  ///< the vertex or body that it was drawn with, by its index in the order
  std::uint32_t stub;   ///< of a middle: which of the stubs it begins at, by index
};

/// Everything that is drawn; in `stubs` also the segments of bodies, of which none meets a stub.
struct DrawnSegments {
  LongVector<DrawnSegment> middles;
  LongVector<DrawnSegment> stubs;
};

/// Returns, in order and each once, the later owners of all pairs that meet: two middles, or a
/// middle and a stub at which it does not begin. What has one owner is not compared, nor what is as
/// `before`. Takes near n^1.5 for middles in all directions, O(n^2) at worst; memory O(n).
std::vector<std::uint32_t> owners_that_meet(const DrawnSegments& drawn,
                                            const DrawnSegments& before);

}  // namespace ar3d::two_bend_109
