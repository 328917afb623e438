#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ar3d/algorithms/two_bend_109/partition.h"
#include "ar3d/algorithms/two_bend_109/slots.h"
#include "ar3d/model/graph.h"

namespace ar3d::two_bend_109 {

/// All lengths follow from the side of the square of points that each vertex off the bodies may
/// choose from (Lemma E.4).
struct LayoutScale {
  std::int64_t jitter = 16;           ///< points along each side of the square
  std::int64_t body_jitter = jitter;  ///< of a body's square; between jitter and 2 jitter + 16

  std::int64_t half_pair() const { return 3 * jitter + 125; }  ///< y of upper and lower vertices
  std::int64_t radius() const { return 6 * jitter + 280; }     ///< of triangles
  /// Least distance in x of a slot of this kind from any other.
  std::int64_t gap(SlotKind kind) const;

  /// At which every vertex of a component of n vertices and every body finds a point (Lemma E.5).
  static LayoutScale always_enough(std::uint64_t num_vertices);
  /// Twice as large, but at most that one.
  LayoutScale next(std::uint64_t num_vertices) const;
  bool operator==(const LayoutScale&) const = default;
};

/// Heights of consecutive vertices differ by this at least; along cycles of four and more by less.
inline constexpr std::int64_t kStep = 2 * kStubZ + 2;
inline constexpr std::int64_t kCycleStep = 2 * kCycleStubZ + 2;

/// Positions before the choice in the square: a vertex will stand at position + (a, b, 0) with
/// 0 <= a, b < jitter.
struct Layout {
  LayoutScale scale;
  std::vector<Point> position;  ///< of each vertex; of those of bodies too, all move alike
  std::uint32_t end_slot = 0;   ///< behind those of the component
};

/// Heights by slope: so high above its earlier neighbours that no edge leans too much, wherever
/// both choose to stand (Step E.3).
/// @param parts  of one component, whose slots begin with this one. The vertices of the others keep
/// their positions in `before`.
/// @throws InputError naming a vertex whose coordinates may pass 2^60. O(size of the component).
Layout lay_out(const OrderedGraph& graph, std::span<const VertexPart> parts,
               const SlotArrangement& arrangement, LayoutScale scale, std::uint32_t first_slot = 0,
               Layout before = {});

}  // namespace ar3d::two_bend_109
