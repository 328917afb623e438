#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "ar3d/model/lattice.h"

namespace ar3d::two_bend_109 {

struct LatticeSegment {
  Point from;
  Point to;
};

/// Returns whether two closed segments of positive length have a point in common. Exact for
/// coordinates up to 2^61 in absolute value.
bool meet(const LatticeSegment& a, const LatticeSegment& b);

/// Components below 2^62 in absolute value.
bool are_parallel(Vector u, Vector v);

/// A vertex with its four stubs.
struct VertexStubs {
  Point at;
  std::array<Vector, 4> stubs;  ///< components of at most kStubX, kStubY and kStubZ

  LatticeSegment segment(std::size_t stub) const { return {at, at + stubs[stub]}; }
};

/// Holds how many stars and lines have been drawn.
struct DrawnCount {
  std::size_t stars = 0;
  std::size_t lines = 0;
};

/// All that is drawn. Most pairs are ruled out by a few operations in floating point, several pairs
/// at a time; those in doubt are compared exactly.
class DrawnSegments {
 public:
  /// @param is_filtered  if not, all pairs are compared exactly: the oracle of the filter.
  explicit DrawnSegments(bool is_filtered = true) : is_filtered_(is_filtered) {}
  void add_star(const VertexStubs& star);
  void add_line(const LatticeSegment& segment);
  DrawnCount size() const { return {stars_.size(), lines_.size()}; }
  /// Returns whether the segment, which begins at the end of this stub of the star since.stars,
  /// meets anything else of what was drawn since. O(size() - since).
  bool meets_any(const LatticeSegment& segment, DrawnCount since, std::size_t stub) const;

 private:
  bool meets_star(const LatticeSegment& segment, std::size_t since) const;
  bool meets_line(const LatticeSegment& segment, std::size_t since) const;

  bool is_filtered_;
  std::vector<VertexStubs> stars_;
  std::vector<float> star_x_;
  std::vector<float> star_z_;
  std::vector<LatticeSegment> lines_;
  std::array<std::vector<float>, 6> of_line_;  ///< direction and moment, by component
  float largest_x_ = 0;                        ///< of all stars, in absolute value
  float largest_z_ = 0;
};

}  // namespace ar3d::two_bend_109
