// Two segments that meet and are not parallel lie in a plane of their two directions. The segments
// of two directions become records of 16 bytes, are partitioned by plane into buckets that fit the
// second-level cache, and compared there: rows sorted by plane into bins of one or two, columns as
// they come. Planes with many segments go to CrowdedPlanes (Steps V.4 to V.8 of docs/verify.md). A
// record is written once or twice and read twice or three times, in order or within the cache.
// Dropped: sorted columns, several windows for every pair of directions, and cross products to find
// a direction. They took 1,039 instructions per segment of `diamond` in place of 678 (n = 10^5).
// Not faster: a table of open addressing in place of bins, records by AVX2, smaller buckets.
#include "ar3d/verify/counting/plane_counts.h"

#include <bit>
#include <cstdlib>

#include "ar3d/verify/predicates/functional.h"

namespace ar3d::verify {
namespace {

std::int64_t product(Vector f, Vector d) { return f.x * d.x + f.y * d.y + f.z * d.z; }

/// Modulo 2^32, in which all values differ, what lies below the low end lies beyond the high one.
bool meet(const PlaneRecord& row, const PlaneRecord& column) {
  const std::uint32_t row_at =
      static_cast<std::uint32_t>(row.at) - static_cast<std::uint32_t>(column.low);
  const std::uint32_t column_at =
      static_cast<std::uint32_t>(column.at) - static_cast<std::uint32_t>(row.low);
  return (row.plane == column.plane) & (column_at <= row.run) & (row_at <= column.run);
}

/// As meet() with every one of `size` columns, in a loop that the compiler makes vectors of.
__attribute__((always_inline)) inline std::uint32_t met(const std::uint32_t* plane,
                                                        const std::uint32_t* at,
                                                        const std::uint32_t* low,
                                                        const std::uint32_t* run, std::size_t size,
                                                        const PlaneRecord& row) {
  const auto row_at = static_cast<std::uint32_t>(row.at);
  const auto row_low = static_cast<std::uint32_t>(row.low);
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i < size; ++i) {
    sum += static_cast<std::uint32_t>((plane[i] == row.plane) & (at[i] - row_low <= row.run) &
                                      (row_at - low[i] <= run[i]));
  }
  return sum;
}

#if defined(__x86_64__)
const bool kHasAvx2 = __builtin_cpu_supports("avx2") != 0;
__attribute__((target("avx2"))) std::uint32_t met_avx2(const std::uint32_t* plane,
                                                       const std::uint32_t* at,
                                                       const std::uint32_t* low,
                                                       const std::uint32_t* run, std::size_t size,
                                                       const PlaneRecord& row) {
  return met(plane, at, low, run, size, row);
}
#else
constexpr bool kHasAvx2 = false;
constexpr auto& met_avx2 = met;
#endif

/// Two of one direction, if they lie on a line.
void count_on_line(const PlaneRecord& a, const PlaneRecord& b, MeetingCounts& counts) {
  if (a.plane != b.plane || a.at != b.at || a.high() < b.low || b.high() < a.low) return;
  const bool touch = a.high() == b.low || b.high() == a.low;
  counts.touching += touch;
  counts.overlap |= !touch;
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
  const auto functional = [](Vector f, std::uint32_t factor) {
    return Functional{static_cast<std::uint32_t>(f.x) * factor,
                      static_cast<std::uint32_t>(f.y) * factor,
                      static_cast<std::uint32_t>(f.z) * factor};
  };
  plane_ = functional(normal_, 0x9E3779B1);  // odd, so that it is one to one modulo 2^32
  const std::size_t axis = leading_axis(normal_);
  for (std::size_t side = 0; side < 2; ++side) {
    // Constant along d[side]; along the other direction it is a component of the normal, not zero.
    across_[side] = times_unit(d[side], axis);
    const std::int64_t speed = product(across_[side], d[1 - side]);
    if (speed < 0) across_[side] = -across_[side];
    at_[side] = functional(across_[side], 1);
    speed_[1 - side] = static_cast<std::uint32_t>(std::abs(speed));
  }
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
  constexpr std::size_t kMostBins = std::size_t{1} << 15;
  const std::size_t size = std::max(buckets_.size_of(bucket), buckets_.size_of(bucket + 1));
  bin_shift_ =
      33 - static_cast<unsigned>(std::bit_width(std::clamp<std::size_t>(size, 2, kMostBins)));
  into_bins(bucket, bins_[0]);
  const bool is_crowded = bins_[0].largest > sizes_.crowded;
  if (is_crowded || lines_[1]) into_bins(bucket + 1, bins_[1]);
  is_crowded ? count_crowded() : count_crossings(bucket + 1);
  for (const std::size_t side : {0u, 1u}) {
    if (lines_[side]) count_lines(bins_[side]);
  }
}

/// Behind the last one stand two that meet nothing.
void PlaneMeetings::into_bins(std::size_t bucket, BucketBins& bins) const {
  constexpr PlaneRecord kNothing{0, 0, INT32_MIN, 0};  // lower than any place
  const auto bin_of = this->bin_of();
  bins.bounds.assign((std::size_t{1} << (32 - bin_shift_)) + 2, 0);
  std::uint32_t* const bounds = bins.bounds.data();
  buckets_.for_each(bucket, [&](const PlaneRecord& r) { ++bounds[bin_of(r) + 2]; });
  std::uint32_t sum = 0;
  bins.largest = 0;
  for (std::uint32_t& bound : bins.bounds) {
    bins.largest = std::max(bins.largest, bound);
    bound = sum += bound;
  }
  if (bins.records.size() < sum + 2) bins.records.resize(sum + 2);
  PlaneRecord* const records = bins.records.data();
  records[sum] = records[sum + 1] = kNothing;
  buckets_.for_each(bucket, [&](const PlaneRecord& r) { records[bounds[bin_of(r) + 1]++] = r; });
}

/// Records of different bins do not meet. So two rows are always compared, wherever the bin ends:
/// few bins have more, and no branch waits for their number.
void PlaneMeetings::count_crossings(std::size_t bucket) {
  const auto bin_of = this->bin_of();
  const PlaneRecord* const records = bins_[0].records.data();
  const std::uint32_t* const bounds = bins_[0].bounds.data();
  std::uint64_t crossing = 0;
  buckets_.for_each(bucket, [&](const PlaneRecord& column) {
    const std::uint32_t bin = bin_of(column);
    const PlaneRecord* row = records + bounds[bin];
    const PlaneRecord* const end = records + bounds[bin + 1];
    crossing += meet(row[0], column);
    crossing += meet(row[1], column);
    for (row += 2; row < end; ++row) {
      asm("" : : "r"(row));  // so few that vectors would only cost
      crossing += meet(*row, column);
    }
  });
  counts_.crossing += crossing;
}

void PlaneMeetings::RecordLists::take(Records records) {
  for (auto* list : {&planes, &places, &lows, &runs}) list->resize(records.size());
  for (std::size_t i = 0; i < records.size(); ++i) {
    planes[i] = records[i].plane;
    places[i] = static_cast<std::uint32_t>(records[i].at);
    lows[i] = static_cast<std::uint32_t>(records[i].low);
    runs[i] = records[i].run;
  }
}

std::uint64_t PlaneMeetings::RecordLists::met_by(const PlaneRecord& row) const {
  return (kHasAvx2 ? met_avx2 : met)(planes.data(), places.data(), lows.data(), runs.data(),
                                     planes.size(), row);
}

void PlaneMeetings::count_crowded() {
  constexpr std::size_t kSwept = 5;  // times `crowded` comparisons take as long as a sweep
  for (std::size_t bin = 0; bin < bins_[0].size(); ++bin) {
    const Records rows = bins_[0][bin], columns = bins_[1][bin];
    if (rows.empty() || columns.empty()) continue;
    if (rows.size() * columns.size() > kSwept * sizes_.crowded * (rows.size() + columns.size())) {
      counts_ += crowded_.count(rows, columns, {});
      continue;
    }
    columns_.take(columns);
    for (const PlaneRecord& row : rows) counts_.crossing += columns_.met_by(row);
  }
}

/// All pairs of one direction that lie on a line.
void PlaneMeetings::count_lines(const BucketBins& bins) {
  for (std::size_t bin = 0; bin < bins.size(); ++bin) {
    const Records records = bins[bin];
    if (records.size() > sizes_.crowded) {
      counts_ += crowded_.count(records, {}, {true, false});
      continue;
    }
    for (std::size_t i = 1; i < records.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) count_on_line(records[i], records[j], counts_);
    }
  }
}

}  // namespace ar3d::verify
