#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ar3d/algorithms/two_bend/layout.h"
#include "ar3d/algorithms/two_bend/numeric.h"

namespace ar3d::two_bend {

/// A bend in x, y of the component and in z relative to the vertex at its end of the edge.
struct RelativeBend {
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::int64_t dz = 0;
};

/// The bends of a long edge, at most two in all. Upwards, first those drawn in the slab of the
/// lower end, then the vertical piece with the PASS vertices, then those drawn in the slab of the
/// upper end.
struct LongBends {
  std::uint8_t lower_count = 0;
  std::uint8_t upper_count = 0;
  std::array<RelativeBend, 2> bends{};

  std::size_t count() const { return std::size_t{lower_count} + upper_count; }
  void add_lower(RelativeBend bend);  ///< before any upper one
  void add_upper(RelativeBend bend);  ///< in upward order
};

/// What one vertex takes of the height: everything slanted that belongs to it lies between z -
/// below and z + above.
struct Slab {
  std::int64_t below = 0;
  std::int64_t above = 0;
};

/// Slabs of all nodes and bends of all long edges (Step 2.11).
struct Slabs {
  LongVector<Slab> of_node;
  LongVector<LongBends> of_edge;
  std::int64_t left = kMaxHorizontal;   ///< least x of a bend, if it is less
  std::int64_t front = kMaxHorizontal;  ///< least y of a bend, if it is less
};

Slabs draw_slabs(const Flow& flow, const Layout& layout);

/// Where a long edge is vertical: (x, y) of the piece between its lower and its upper bends.
struct Ray {
  std::int64_t x = 0;
  std::int64_t y = 0;
};
Ray ray_of(const Flow& flow, const Layout& layout, const LongEdge& edge);

}  // namespace ar3d::two_bend
