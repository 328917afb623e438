#pragma once

#include <array>
#include <cstdint>

#include "ar3d/algorithms/two_bend/blocks.h"
#include "ar3d/algorithms/two_bend/layout.h"
#include "ar3d/algorithms/two_bend/leans.h"
#include "ar3d/algorithms/two_bend/output.h"

namespace ar3d::two_bend {

/// A bend in x, y of the component and in z relative to the vertex at its end of the edge.
struct RelativeBend {
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::int64_t dz = 0;
};

/// The bends of a long edge, at most two in all. Upwards, first those drawn in the slab of the
/// lower end, then the vertical piece with the PASS vertices, then those drawn in the slab of the
/// upper end. 32 bytes: the numbers of bends are kept in the last two bits of their heights.
class alignas(32) LongBends {
 public:
  std::size_t lower_count() const { return static_cast<std::size_t>(coded_[0] & 3); }
  std::size_t upper_count() const { return static_cast<std::size_t>(coded_[1] & 3); }
  std::size_t count() const { return lower_count() + upper_count(); }
  RelativeBend operator[](std::size_t i) const {
    return {xy_[2 * i], xy_[2 * i + 1], coded_[i] >> 2};
  }
  void add_lower(RelativeBend bend);  ///< before any upper one, below any lower one
  void add_upper(RelativeBend bend);  ///< in upward order

 private:
  void set(std::size_t i, RelativeBend bend);

  std::array<std::int32_t, 4> xy_{};
  std::array<std::int64_t, 2>
      coded_{};  // 4 dz + number of lower bends, 4 dz + number of upper ones
};

/// Holds what one vertex takes of the height: everything slanted that belongs to it lies between z
/// - below and z + above.
struct SlabHeights {
  std::int64_t below = 0;
  std::int64_t above = 0;
};

/// Slabs of all nodes and bends of all long edges (Step 2.11).
struct Slabs {
  LongVector<SlabHeights> of_node;
  LongVector<LongBends> of_edge;
  std::int64_t left = kMaxHorizontal;   ///< least x of a bend, if it is less
  std::int64_t front = kMaxHorizontal;  ///< least y of a bend, if it is less
};

Slabs draw_slabs(const Flow& flow, const Layout& layout);

/// A point as seen from above; rows and columns are below kMaxHorizontal.
struct FlatPoint {
  std::int32_t x = 0;
  std::int32_t y = 0;
};

/// Returns where a long edge is vertical, between its lower and its upper bends.
FlatPoint ray_of(const Flow& flow, const Layout& layout, const LongEdge& edge);

/// Everything found out about one component, ready to be drawn.
struct Component {
  const LocalGraph& graph;
  const TimeOrder& order;
  const Flow& flow;
  const Layout& layout;
  const Slabs& slabs;
  const LongVector<QBody>& bodies;
};

/// Step 2.11: gives every vertex its own slab in time order (z), x and y from rays and poles, and
/// writes vertices and bends, translated so that the smallest x and y of the component are 0. Cost:
/// O(n).
void stack_slabs(const Component& component, Output& output);

}  // namespace ar3d::two_bend
