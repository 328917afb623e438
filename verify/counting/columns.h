#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "ar3d/verify/counting/plane_records.h"

namespace ar3d::verify {

/// A vertical segment; one of length zero stands for a vertex without edges.
struct VerticalSegment {
  std::int32_t x;
  std::int32_t y;
  std::int64_t low;
  std::int64_t high;
};

/// A segment that is not vertical, from its lower end; dz >= 0.
struct SlantedSegment {
  std::int32_t x;
  std::int32_t y;
  std::int64_t z;
  std::int32_t dx;
  std::int32_t dy;
  std::int64_t dz;
};

/// The numbers from low to high.
struct Span {
  std::int64_t low;
  std::int64_t high;
};

/// Places in the plane, sorted by one coordinate (`major`) and then by the other (`minor`).
class PlaceIndex {
 public:
  struct Entry {
    std::int32_t major;
    std::int32_t minor;
    std::uint32_t column;
  };
  using Range = std::pair<const Entry*, const Entry*>;

  PlaceIndex() = default;
  /// @pre sorted, at least one.
  explicit PlaceIndex(std::vector<Entry> entries);
  /// The places from (major_low, minor_low) to (major_high, minor_high) in that order. O(log k) for
  /// k places; O(1) if the places are spread evenly.
  Range between(std::int32_t major_low, std::int32_t minor_low, std::int32_t major_high,
                std::int32_t minor_high) const;

 private:
  const Entry* first_from(std::int64_t major, std::int64_t minor) const;

  std::vector<Entry> entries_;
  std::vector<std::uint32_t> table_;  ///< entry (major - least_) >> shift_: where to begin
  std::int64_t least_ = 0;
  unsigned shift_ = 0;
};

/// The vertical segments of a drawing by their places (x, y), of which each has a column of them
/// (Steps V.9 and V.10). 16 bytes per segment and about 50 per column.
class Columns {
 public:
  /// O(k) for k segments, plus the sorting inside long columns.
  explicit Columns(const std::vector<VerticalSegment>& segments);

  /// Returns how often a segment ends where the next one of its column begins; nothing if two have
  /// more than a point in common.
  std::optional<std::uint64_t> touching() const;
  /// Returns how many vertical segments the slanted one meets. @pre touching() is something.
  std::uint64_t met_by(const SlantedSegment& s) const;

 private:
  struct Projection;

  void sort(const std::vector<VerticalSegment>& segments);
  void index();
  std::uint64_t met_in(PlaceIndex::Range places, const Projection& p, bool swapped) const;
  std::uint64_t met_at_lattice_points(const Projection& p) const;
  std::uint64_t met_at(std::uint32_t column, const Projection& p, std::int64_t x,
                       std::int64_t y) const;
  std::uint64_t count(std::uint32_t column, std::int64_t low, std::int64_t high) const;

  std::vector<Span> spans_;       ///< by column, bottom up
  std::vector<std::int32_t> xs_;  ///< of each column
  std::vector<std::int32_t> ys_;
  std::vector<std::uint32_t> begin_;  ///< of each column in spans_, and their end
  PlaceIndex by_x_;
  PlaceIndex by_y_;
};

/// The meetings of slanted segments with each other: upwards, each is compared with those begun
/// before it that reach its lower end (Step V.11); if that takes more than `patience` comparisons
/// per segment, by halving space (Steps V.12 to V.14). Nothing if there are many more meetings than
/// a right drawing has.
std::optional<MeetingCounts> meetings_of_slanted(const std::vector<SlantedSegment>& segments,
                                                 std::size_t patience);

}  // namespace ar3d::verify
