#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "ar3d/verify/counting/plane_records.h"
#include "ar3d/verify/crossings/radix_sort.h"

namespace ar3d::verify {

/// Counts in planes of many segments: the rows that reach the current column are kept in a tree of
/// partial sums over their places across. O(p log p) time for p records, whatever the number of
/// meetings.
class CrowdedPlanes {
 public:
  using Records = std::span<const PlaneRecord>;
  /// @param lines  as of PlaneMeetings::begin().
  MeetingCounts count(Records rows, Records columns, std::array<bool, 2> lines);

 private:
  void sort_records(Records from, bool along, std::vector<PlaneRecord>& to);
  void count_lines(const std::vector<PlaneRecord>& records);
  void count_plane(Records rows, Records columns);
  void order_ends(Records rows);
  void rank_places(Records rows);
  std::size_t rank(std::int64_t value) const;
  std::uint64_t active_before(std::size_t rank) const;
  void change(std::size_t rank, std::int32_t by);

  MeetingCounts counts_;
  std::vector<PlaneRecord> rows_;     ///< by plane, across, and along for lines
  std::vector<PlaneRecord> columns_;  ///< the same
  std::vector<std::int32_t> places_;  ///< of the plane's rows, ascending
  std::vector<std::uint32_t> table_;  ///< entry (place - first place) >> shift_: where to begin
  unsigned shift_ = 0;
  std::vector<Keyed> order_;
  std::vector<Keyed> by_low_;  ///< the plane's rows
  std::vector<Keyed> by_high_;
  std::vector<Keyed> buffer_;
  std::vector<std::int32_t> tree_;  ///< Fenwick's, of the active rows
};

}  // namespace ar3d::verify
