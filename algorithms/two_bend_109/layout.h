#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "ar3d/algorithms/two_bend_109/drawn_segments.h"
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

/// Holds where everything stands, each component by itself.
struct Placement {
  explicit Placement(Vertex num_vertices) : at(num_vertices), ends(num_vertices) {}
  std::vector<Point> at;                   ///< of each vertex
  std::vector<std::array<Point, 4>> ends;  ///< entry i of a vertex: the bend next to it on its i-th
                                           ///< incident edge
  std::int64_t tried = 0;                  ///< points tried in all, for what could be placed
};

/// owners_that_meet(), or what tests compare it with.
using MeetingSearch = decltype(owners_that_meet);

/// Each vertex and body takes a point of its square where no new middle is flat and nothing new
/// meets anything older, by Step E.4; false if some square is seen to be too small. At the scale
/// LayoutScale::always_enough(n) none is (Lemma E.5). Takes O(n) and `find`, in each round.
/// @param parts  of one component, of n vertices.
/// @param seed  on which the choices depend, and on the numbers within the component.
/// @param made  has room for the graph, and nothing else in it changes.
bool place(const OrderedGraph& graph, std::span<const VertexPart> parts,
           const SlotArrangement& arrangement, const Layout& layout, std::uint64_t seed,
           Placement& made, MeetingSearch& find = owners_that_meet);

}  // namespace ar3d::two_bend_109
