#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "ar3d/model/lattice.h"

namespace ar3d::two_bend_109 {

struct Segment {
  Point from;
  Point to;
};

/// Whether two closed segments of positive length have a point in common. Exact for coordinates up
/// to 2^61 in absolute value.
bool meet(const Segment& a, const Segment& b);

/// Segments in the order in which they were added.
class DrawnSegments {
 public:
  std::size_t size() const { return segments_.size(); }
  const Segment& operator[](std::size_t i) const { return segments_[i]; }
  void add(const Segment& segment);
  /// The first of the segments begin, begin + 1, … but `but` that the given one meets, or size().
  /// Two segments meet only if u1 m2 + u2 m1 = 0 for their directions u and moments m = p x u; that
  /// sum is evaluated in floating point, and where its sign is in doubt the two are compared
  /// exactly. O(size() - begin).
  std::size_t first_met(const Segment& segment, std::size_t begin, std::size_t but) const;

 private:
  std::vector<Segment> segments_;
  std::array<std::vector<float>, 6> of_;  ///< direction and moment, by component
};

}  // namespace ar3d::two_bend_109
