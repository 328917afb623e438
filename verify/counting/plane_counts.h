#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ar3d/verify/counting/crowded_planes.h"
#include "ar3d/verify/counting/plane_records.h"
#include "ar3d/verify/counting/signed_directions.h"

namespace ar3d::verify {

/// Sizes that decide which way is taken, never what is counted; tests set them small.
struct CountingSizes {
  std::size_t bucket =
      6000;                  ///< records that a bucket should have: they fit the second-level cache
  std::size_t crowded = 32;  ///< comparisons per record from which a plane sweep is taken instead
  std::uint64_t memory = 0;  ///< bytes of segments and records at a time; 0: no limit
  std::uint32_t threads = 1;  ///< that count; each has records of its own
};

/// One of `count` equal parts of all planes of a family.
struct PlaneWindow {
  std::uint32_t number = 0;
  std::uint32_t count = 1;
};

/// The planes that contain the directions i and j of `directions`, and coordinates in them.
class PlaneFamily {
 public:
  PlaneFamily(const SignedDirections& directions, std::size_t i, std::size_t j);
  /// True if 32 bits hold every value of its functionals for coordinates up to `largest`.
  bool fits(std::int64_t largest) const;
  /// A number of the segment's plane that differs for all planes, spread over 32 bits: the factor
  /// is odd, so that multiplying by it modulo 2^32 is one to one.
  std::uint32_t plane_of(const PlacedSegment& s) const {
    constexpr std::uint32_t kSpread = 0x9E3779B1;
    return static_cast<std::uint32_t>(plane_(s)) * kSpread;
  }
  /// @param side  0 for a row, of direction i; 1 for a column, of direction j.
  PlaneRecord record(const PlacedSegment& s, std::size_t side, std::uint32_t plane) const {
    const std::int32_t low = at_[1 - side](s);
    // The value at the other end fits, the difference need not: modulo 2^32.
    const std::uint32_t run = static_cast<std::uint32_t>(s.steps) * speed_[side];
    return {plane, at_[side](s), low,
            static_cast<std::int32_t>(static_cast<std::uint32_t>(low) + run)};
  }

 private:
  struct Functional {
    std::int32_t x = 0;
    std::int32_t y = 0;
    std::int32_t z = 0;
    std::int32_t operator()(const PlacedSegment& s) const { return x * s.x + y * s.y + z * s.z; }
  };
  static Functional narrowed(Vector f);

  Vector normal_;
  std::array<Vector, 2> across_;  ///< [side] is constant along that side's direction
  Functional plane_;
  std::array<Functional, 2> at_;
  std::array<std::uint32_t, 2> speed_{};  ///< how far a step of a side runs across the other; > 0
};

/// Counts in one window of planes after the other; keeps its memory: 16 bytes per record.
class PlaneMeetings {
 public:
  /// Takes segments of the window at hand. To be kept in a local variable: then everything that it
  /// knows of the window stays in registers.
  class Intake {
   public:
    /// Segments of a side's direction (0: rows, 1: columns), of which those are taken whose planes
    /// are in the window. Chance decides which: they are told apart without a branch.
    void add(std::span<const PlacedSegment> segments, std::size_t side) const {
      constexpr std::size_t kBlock = 64;
      std::array<std::uint8_t, kBlock> taken;
      for (; !segments.empty(); segments = segments.subspan(std::min(kBlock, segments.size()))) {
        const std::size_t size = std::min(kBlock, segments.size());
        std::size_t count = 0;
        for (std::size_t i = 0; i < size; ++i) {
          taken[count] = static_cast<std::uint8_t>(i);
          count += scaled(family_.plane_of(segments[i])) >> 32 == window_.number;
        }
        for (std::size_t i = 0; i < count; ++i) add_taken(segments[taken[i]], side);
      }
    }

   private:
    friend class PlaneMeetings;
    Intake(const PlaneFamily& family, PlaneWindow window, unsigned shift, RecordBuckets& buckets)
        : family_(family), window_(window), shift_(shift), buckets_(&buckets) {}

    std::uint64_t scaled(std::uint32_t plane) const { return std::uint64_t{plane} * window_.count; }
    void add_taken(const PlacedSegment& s, std::size_t side) const {
      const std::uint32_t plane = family_.plane_of(s);
      const std::uint64_t place = scaled(plane) & 0xffffffff;
      buckets_->add(2 * (place >> shift_) + side, family_.record(s, side, plane));
    }

    PlaneFamily family_;
    PlaneWindow window_;
    unsigned shift_;
    RecordBuckets* buckets_;
  };

  explicit PlaneMeetings(const CountingSizes& sizes) : sizes_(sizes) {}

  /// Begins with a window. @param expected  about how many records it will have.
  /// @param lines  is it asked for rows, and for columns, which of them meet on their lines?
  Intake begin(const PlaneFamily& family, PlaneWindow window, std::uint64_t expected,
               std::array<bool, 2> lines);
  /// All meetings of rows with columns, and those on the lines that are wanted.
  MeetingCounts finish();

 private:
  using Records = std::span<const PlaneRecord>;

  void count_bucket(std::size_t bucket);
  void into_bins(std::size_t bucket, std::vector<PlaneRecord>& to,
                 std::vector<std::uint32_t>& ends);
  void count_bin(Records rows, Records columns);

  CountingSizes sizes_;
  PlaneWindow window_;
  std::array<bool, 2> lines_{};
  MeetingCounts counts_;
  unsigned bucket_bits_ = 0;
  unsigned bin_bits_ = 0;
  RecordBuckets buckets_;              ///< of rows and columns in turns
  std::vector<PlaneRecord> bin_rows_;  ///< of the bucket at hand, by bin
  std::vector<PlaneRecord> bin_columns_;
  std::vector<std::uint32_t> row_ends_;
  std::vector<std::uint32_t> column_ends_;
  CrowdedPlanes crowded_;
};

}  // namespace ar3d::verify
