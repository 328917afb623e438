#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "ar3d/verify/checks/contacts.h"
#include "ar3d/verify/crossings/segments.h"

namespace ar3d::verify {

/// The vertical segments of a slab, found by their place (x, y): a column holds those of one place,
/// bottom up. Places are indexed by x and by y.
class SlabColumns {
 public:
  SlabColumns(const Segments& segments, Contacts& contacts)
      : segments_(segments), contacts_(contacts) {}

  /// Replaces the content. O(k log k) for k segments.
  void build(const std::vector<SegmentId>& verticals);

  /// Names the vertical segments that meet each other.
  void examine_verticals();
  /// Names those on which the vertex lies. O(log k) and the meetings.
  void examine_vertex(Vertex v);
  /// Names those that may meet a segment that is not vertical. It passes over the lattice points of
  /// its projection to the plane, over the columns within its x-range and over those within its
  /// y-range: the smallest of the three sets is searched, each of its members in O(log k).
  void examine_slanted(SegmentId s);

 private:
  struct Vertical {
    std::int64_t x;
    std::int64_t y;
    std::int64_t low;
    std::int64_t high;
    std::int64_t highest;  ///< largest `high` from the bottom of the column up to here
    SegmentId segment;
  };
  struct Column {
    std::int64_t x;
    std::int64_t y;
    std::uint32_t begin;  ///< its segments in verticals_
    std::uint32_t end;
  };
  struct Projection;
  using Places = std::pair<const Column*, const Column*>;

  void build_columns();
  const Column* find(std::int64_t x, std::int64_t y) const;
  Places within_x(const Projection& projection) const;
  Places within_y(const Projection& projection) const;
  void examine_at(const Projection& projection, const Column& column);
  /// Calls visit(segment) for the column's segments that reach a height in [low, high].
  template <class Visit>
  void for_each_between(const Column& column, std::int64_t low, std::int64_t high,
                        Visit&& visit) const;

  const Segments& segments_;
  Contacts& contacts_;
  std::vector<Vertical> verticals_;
  std::vector<Column> by_x_;  ///< sorted by (x, y)
  std::vector<Column> by_y_;  ///< sorted by (y, x)
};

}  // namespace ar3d::verify
