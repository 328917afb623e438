// Two segments that meet and are not parallel lie in a plane of their two directions. The segments
// of two directions become records of 16 bytes, are partitioned by plane into buckets that fit the
// second-level cache, there sorted by plane into bins of about two records, and compared. Planes
// with many segments go to CrowdedPlanes. Each record is written twice and read three times, always
// in order or within the cache (Steps V.4 to V.8 of docs/verify.md).
#include "ar3d/verify/counting/plane_counts.h"

#include <bit>
#include <cstdlib>
#include <utility>

#include "ar3d/verify/predicates/functional.h"

namespace ar3d::verify {
namespace {

std::int64_t product(Vector f, Vector d) { return f.x * d.x + f.y * d.y + f.z * d.z; }

bool meet(const PlaneRecord& row, const PlaneRecord& column) {
  return (row.plane == column.plane) & (row.low <= column.at) & (column.at <= row.high) &
         (column.low <= row.at) & (row.at <= column.high);
}

/// All pairs of one direction that lie on a line.
void count_on_lines(std::span<const PlaneRecord> records, MeetingCounts& counts) {
  for (std::size_t i = 1; i < records.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const PlaneRecord& a = records[i];
      const PlaneRecord& b = records[j];
      if (a.plane != b.plane || a.at != b.at || a.high < b.low || b.high < a.low) continue;
      const bool touch = a.high == b.low || b.high == a.low;
      counts.touching += touch;
      counts.overlap |= !touch;
    }
  }
}

}  // namespace

MeetingCounts& MeetingCounts::operator+=(const MeetingCounts& other) {
  crossing += other.crossing;
  touching += other.touching;
  overlap |= other.overlap;
  return *this;
}

PlaneFamily::PlaneFamily(const SignedDirections& directions, std::size_t i, std::size_t j) {
  const Vector d[2] = {directions[i], directions[j]};
  normal_ = plane_normal(d[0], d[1]);
  plane_ = narrowed(normal_);
  const std::size_t axis = leading_axis(normal_);
  for (std::size_t side = 0; side < 2; ++side) {
    // Constant along d[side]; along the other direction it is a component of the normal, not zero.
    across_[side] = times_unit(d[side], axis);
    const std::int64_t speed = product(across_[side], d[1 - side]);
    if (speed < 0) across_[side] = -across_[side];
    at_[side] = narrowed(across_[side]);
    speed_[1 - side] = static_cast<std::uint32_t>(std::abs(speed));
  }
}

PlaneFamily::Functional PlaneFamily::narrowed(Vector f) {
  return {static_cast<std::int32_t>(f.x), static_cast<std::int32_t>(f.y),
          static_cast<std::int32_t>(f.z)};
}

// A sum of absolute coefficients times the largest coordinate bounds every term, every partial sum
// and every value.
bool PlaneFamily::fits(std::int64_t largest) const {
  const auto narrow = [largest](Vector f) {
    const Int128 sum = Int128{std::abs(f.x)} + std::abs(f.y) + std::abs(f.z);
    return sum * std::max<std::int64_t>(largest, 1) < (Int128{1} << 31);
  };
  return narrow(normal_) && narrow(across_[0]) && narrow(across_[1]);
}

PlaneMeetings::Intake PlaneMeetings::begin(const PlaneFamily& family, PlaneWindow window,
                                           std::uint64_t expected, std::array<bool, 2> lines) {
  constexpr unsigned kMostBits = 11;  // more streams at a time than the memory system follows
  window_ = window;
  lines_ = lines;
  counts_ = {};
  bucket_bits_ =
      std::min(kMostBits, static_cast<unsigned>(std::bit_width(expected / sizes_.bucket)));
  buckets_.reset(std::size_t{2} << bucket_bits_);
  return {family, window, 32 - bucket_bits_, buckets_};
}

MeetingCounts PlaneMeetings::finish() {
  for (std::size_t b = 0; b < buckets_.size(); b += 2) count_bucket(b);
  return counts_;
}

/// Rows are in this bucket, columns in the next one.
void PlaneMeetings::count_bucket(std::size_t bucket) {
  constexpr unsigned kMostBits = 15;
  const std::size_t records = buckets_.size_of(bucket) + buckets_.size_of(bucket + 1);
  if (records < 2) return;
  bin_bits_ = std::min(kMostBits, static_cast<unsigned>(std::bit_width(records / 2)));
  into_bins(bucket, bin_rows_, row_ends_);
  into_bins(bucket + 1, bin_columns_, column_ends_);
  const Records all_rows(bin_rows_);
  const Records all_columns(bin_columns_);
  std::size_t row = 0;
  std::size_t column = 0;
  for (std::size_t bin = 0; bin < row_ends_.size(); ++bin) {
    const std::size_t row_end = row_ends_[bin];
    const std::size_t column_end = column_ends_[bin];
    count_bin(all_rows.subspan(row, row_end - row),
              all_columns.subspan(column, column_end - column));
    row = row_end;
    column = column_end;
  }
}

/// By the bits of the plane's place in the window below those of its bucket. Afterwards ends[s] is
/// the end of bin s.
void PlaneMeetings::into_bins(std::size_t bucket, std::vector<PlaneRecord>& to,
                              std::vector<std::uint32_t>& ends) {
  const std::uint32_t scale = window_.count << bucket_bits_;  // modulo 2^32, as the place is
  const unsigned shift = 32 - bin_bits_;
  const auto bin = [=](const PlaneRecord& record) {
    const std::uint32_t place = record.plane * scale;
    return static_cast<std::size_t>(std::uint64_t{place} >> shift);
  };
  ends.assign(std::size_t{1} << bin_bits_, 0);
  buckets_.for_each(bucket, [&](const PlaneRecord& record) { ++ends[bin(record)]; });
  std::uint32_t begin = 0;
  for (std::uint32_t& place : ends) begin += std::exchange(place, begin);
  if (to.size() < begin) to.resize(begin);
  buckets_.for_each(bucket, [&](const PlaneRecord& record) { to[ends[bin(record)]++] = record; });
}

void PlaneMeetings::count_bin(Records rows, Records columns) {
  const std::size_t pairs = rows.size() * columns.size() +
                            (lines_[0] ? rows.size() * rows.size() : 0) +
                            (lines_[1] ? columns.size() * columns.size() : 0);
  if (pairs > sizes_.crowded * (rows.size() + columns.size())) {
    counts_ += crowded_.count(rows, columns, lines_);
    return;
  }
  for (const PlaneRecord& row : rows) {
    for (const PlaneRecord& column : columns) counts_.crossing += meet(row, column);
  }
  if (lines_[0]) count_on_lines(rows, counts_);
  if (lines_[1]) count_on_lines(columns, counts_);
}

}  // namespace ar3d::verify
