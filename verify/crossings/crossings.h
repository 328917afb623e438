#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ar3d/verify/crossings/contacts.h"
#include "ar3d/verify/crossings/segments.h"

namespace ar3d::verify {

/// The plane sweep's limits: so many directions, and primitive components below this in absolute
/// value.
inline constexpr std::size_t kMaxDirections = 16;
inline constexpr std::int64_t kMaxDirectionComponent = std::int64_t{1} << 20;

/// The directions that a drawing really has, up to sign, and which of them each segment has.
struct DirectionClasses {
  std::vector<Vector> directions;  ///< primitive, pairwise not parallel
  std::vector<std::uint8_t> of;    ///< one entry per segment
};

/// Nothing if the drawing passes the plane sweep's limits. O(S) time for a bounded number of
/// directions.
std::optional<DirectionClasses> few_directions(const Segments& segments);

/// A segment or a vertex.
struct DrawnItem {
  std::uint32_t number;
  bool is_vertex;
};

/// And its box.
struct BoxedItem {
  DrawnItem item;
  Box box;
};

/// All segments and then all vertices of the drawing.
std::vector<BoxedItem> boxed_items(const Segments& segments);
/// A segment with a segment or vertex that it may meet; the check of the vertices sees two
/// vertices.
void examine_pair(DrawnItem a, DrawnItem b, Contacts& contacts);

// Each test names every pair of segments that meets, and every vertex on a segment, to `contacts`.

/// The oracle: every pair. O(S (S + n)) time, a box per segment.
void test_all_pairs(const Segments& segments, Contacts& contacts);

/// Lines and plane families, for few directions: O(k (S + n) log S + meetings) time for k
/// directions.
void test_by_plane_sweep(const Segments& segments, const DirectionClasses& classes,
                         Contacts& contacts);

/// For drawings with many directions: slabs that nothing crosses, and in each the search for near
/// pairs. O((S + n) log S) time where segments are short, at most quadratic (Lemma V.8); O(S + n)
/// memory.
void test_by_slabs(const Segments& segments, Contacts& contacts);

}  // namespace ar3d::verify
