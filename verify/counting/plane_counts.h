#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ar3d/verify/counting/crowded_planes.h"
#include "ar3d/verify/counting/placed_segments.h"
#include "ar3d/verify/counting/plane_records.h"
#include "ar3d/verify/counting/signed_directions.h"

namespace ar3d::verify {

/// Sizes that decide which way is taken, never what is counted; tests set them small.
struct CountingSizes {
  std::size_t bucket =
      6000;                  ///< records that a bucket should have: they fit the second-level cache
  std::size_t crowded = 32;  ///< comparisons per record from which a plane sweep is taken instead
  std::uint64_t memory = 0;  ///< bytes of segments and records at a time; 0: no limit
};

/// The planes that contain the directions i and j of `directions`, and coordinates in them.
class PlaneFamily {
 public:
  PlaneFamily(const SignedDirections& directions, std::size_t i, std::size_t j);
  /// True if 32 bits hold every value of its functionals for coordinates up to `largest`.
  bool fits(std::int64_t largest) const;
  PlaneRecord row(const PlacedSegment& s) const { return record(s, 0); }
  PlaneRecord column(const PlacedSegment& s) const { return record(s, 1); }
  /// A number of the segment's plane that differs for all planes, spread over 32 bits.
  std::uint32_t plane_of(const PlacedSegment& s) const;

 private:
  struct Functional {
    std::int32_t x = 0;
    std::int32_t y = 0;
    std::int32_t z = 0;
    std::int32_t operator()(const PlacedSegment& s) const { return x * s.x + y * s.y + z * s.z; }
  };
  static Functional narrowed(Vector f);
  PlaneRecord record(const PlacedSegment& s, std::size_t side) const;

  Vector normal_;
  std::array<Vector, 2> across_;  ///< [side] is constant along that side's direction
  Functional plane_;
  std::array<Functional, 2> at_;
  std::array<std::uint32_t, 2> speed_{};  ///< how far a step of a side runs across the other; > 0
};

/// Counts in one family after the other; keeps its memory.
class PlaneMeetings {
 public:
  explicit PlaneMeetings(const CountingSizes& sizes) : sizes_(sizes) {}
  /// All meetings of rows with columns, and those on the lines that are wanted.
  MeetingCounts count(const PlaneFamily& family, const PlacedSegments& rows,
                      const PlacedSegments& columns, LinesToCount lines);

 private:
  using Records = std::span<const PlaneRecord>;

  void partition(const PlaneFamily& family, const PlacedSegments& rows,
                 const PlacedSegments& columns);
  void count_bucket(Records rows, Records columns);
  void into_bins(Records from, std::vector<PlaneRecord>& to, std::vector<std::uint32_t>& ends);
  void count_bin(Records rows, Records columns);

  CountingSizes sizes_;
  LinesToCount lines_;
  MeetingCounts counts_;
  unsigned bucket_bits_ = 0;
  unsigned bin_bits_ = 0;
  std::vector<PlaneRecord> records_;      ///< by bucket, in a bucket the rows first
  std::vector<std::size_t> bucket_ends_;  ///< of rows and columns in turns
  std::vector<PlaneRecord> bin_rows_;     ///< of the bucket at hand, by bin
  std::vector<PlaneRecord> bin_columns_;
  std::vector<std::uint32_t> row_ends_;
  std::vector<std::uint32_t> column_ends_;
  CrowdedPlanes crowded_;
};

}  // namespace ar3d::verify
