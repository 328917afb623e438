#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "ar3d/verify/counting/plane_records.h"
#include "ar3d/verify/counting/signed_directions.h"
#include "ar3d/verify/crossings/radix_sort.h"

namespace ar3d::verify {

/// Counts in planes of many segments: the rows that reach the current column are kept in a tree of
/// partial sums over their places across. O(p log p) time for p records, whatever the number of
/// meetings.
class CrowdedPlanes {
 public:
  using Records = std::span<const PlaneRecord>;
  std::uint64_t count(Records rows, Records columns);

 private:
  void sort_records(Records from, std::vector<PlaneRecord>& to);
  std::uint64_t count_plane(Records rows, Records columns);
  void order_ends(Records rows);
  void rank_places(Records rows);
  std::size_t rank(std::int64_t value) const;
  std::uint64_t active_before(std::size_t rank) const;
  void change(std::size_t rank, std::int32_t by);

  std::vector<PlaneRecord> rows_;     ///< by plane, then across
  std::vector<PlaneRecord> columns_;  ///< the same
  std::vector<std::int32_t> places_;  ///< of the plane's rows, ascending
  std::vector<std::uint32_t> table_;  ///< entry (place - first place) >> shift_: where to begin
  unsigned shift_ = 0;
  std::vector<ShortKeyed> order_;
  std::vector<ShortKeyed> by_low_;  ///< the plane's rows
  std::vector<ShortKeyed> by_high_;
  std::vector<ShortKeyed> buffer_;
  std::vector<std::int32_t> tree_;  ///< Fenwick's, of the active rows
};

/// Sizes that decide which way is taken, never what is counted; tests set them small.
struct CountingSizes {
  std::size_t bucket = 6000;  ///< records of a bucket: they fit the second-level cache
  std::size_t crowded = 32;   ///< rows of a bin from which its columns are sorted, too; five times
                              ///< as many comparisons per record are left to a plane sweep
  std::uint64_t memory = 0;   ///< bytes of segments and records at a time; 0: no limit
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
  /// A number of the segment's plane that differs for all planes, spread over 32 bits.
  std::uint32_t plane_of(const PlacedSegment& s) const {
    const auto& [of_x, of_y, of_z, of_steps] = sides_[0];
    return of_x[0] * static_cast<std::uint32_t>(s.x) + of_y[0] * static_cast<std::uint32_t>(s.y) +
           of_z[0] * static_cast<std::uint32_t>(s.z);
  }
  /// @param side  0 for a row, of direction i; 1 for a column, of direction j.
  PlaneRecord record(const PlacedSegment& s, std::size_t side) const {
    const auto& [of_x, of_y, of_z, of_steps] = sides_[side];
    return std::bit_cast<PlaneRecord>(
        of_x * static_cast<std::uint32_t>(s.x) + of_y * static_cast<std::uint32_t>(s.y) +
        of_z * static_cast<std::uint32_t>(s.z) + of_steps * static_cast<std::uint32_t>(s.steps));
  }

 private:
  /// The numbers of a record, modulo 2^32.
  using Numbers __attribute__((vector_size(16))) = std::uint32_t;

  Vector normal_;
  std::array<Vector, 2> across_;  ///< [side] is constant along that side's direction
  /// What one of x, y, z and a step adds to a side's record. A step runs across the other side.
  std::array<std::array<Numbers, 4>, 2> sides_{};
};

/// Counts in one window of planes after the other; keeps its memory: 16 bytes per record.
class PlaneMeetings {
 public:
  /// Takes segments of the window at hand.
  class Intake {
   public:
    /// Segments of a side's direction (0: rows, 1: columns), of which those are taken whose planes
    /// are in the window.
    void add(std::span<const PlacedSegment> segments, std::size_t side) const;

   private:
    friend class PlaneMeetings;
    Intake(const PlaneFamily& family, PlaneWindow window, unsigned shift, RecordBuckets& buckets)
        : family_(family), window_(window), shift_(shift), buckets_(&buckets) {}

    void add_all(std::span<const PlacedSegment> segments, std::size_t side) const;
    void add_all_avx2(std::span<const PlacedSegment> segments, std::size_t side) const;
    std::uint64_t scaled(std::uint32_t plane) const { return std::uint64_t{plane} * window_.count; }

    PlaneFamily family_;
    PlaneWindow window_;
    unsigned shift_;
    RecordBuckets* buckets_;
  };

  explicit PlaneMeetings(const CountingSizes& sizes) : sizes_(sizes) {}

  /// Begins with a window. @param expected  about how many records it will have.
  Intake begin(const PlaneFamily& family, PlaneWindow window, std::uint64_t expected);
  /// The number of meetings of rows with columns.
  std::uint64_t finish();

 private:
  using Records = std::span<const PlaneRecord>;
  /// The records of one bucket, those of each bin together, and two that meet nothing.
  struct BucketBins {
    std::vector<PlaneRecord> records;
    std::vector<std::uint32_t> bounds;  ///< of each bin in it
    std::uint32_t largest = 0;          ///< records in one bin
    std::size_t size() const { return bounds.size() - 2; }
    Records operator[](std::size_t bin) const {
      return {records.data() + bounds[bin], records.data() + bounds[bin + 1]};
    }
  };

  /// The records of a bin member by member, so that one is compared with several at a time.
  struct RecordLists {
    std::vector<std::uint32_t> planes, places, lows, runs;
    void take(Records records);
    std::uint64_t met_by(const PlaneRecord& row) const;
  };

  /// Of a record: the bits of its plane's place in the window below those of its bucket.
  auto bin_of() const {
    return [factor = window_.count << bucket_bits_, shift = bin_shift_](const PlaneRecord& record) {
      return record.plane * factor >> shift;
    };
  }
  std::uint64_t count_bucket(std::size_t bucket);
  void into_bins(std::size_t bucket, BucketBins& bins) const;
  std::uint64_t count_crossings(std::size_t bucket) const;
  std::uint64_t count_crowded();

  CountingSizes sizes_;
  PlaneWindow window_;
  unsigned bucket_bits_ = 0;
  unsigned bin_shift_ = 0;
  RecordBuckets buckets_;           ///< of rows and columns in turns
  std::array<BucketBins, 2> bins_;  ///< of rows, of columns
  RecordLists columns_;             ///< of a bin
  CrowdedPlanes crowded_;
};

}  // namespace ar3d::verify
