// Two segments that meet and are not parallel lie in a plane of their two directions. The segments
// of two directions become records of 16 bytes, are partitioned by plane into buckets that fit the
// second-level cache, and compared there: rows sorted by plane into bins of one or two, columns as
// they come. Planes with many segments go to CrowdedPlanes (Steps V.4 to V.7 of docs/verify.md). A
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
  const std::size_t axis = leading_axis(normal_);
  for (std::size_t side = 0; side < 2; ++side) {
    // Constant along d[side]; along the other direction it is a component of the normal, not zero.
    across_[side] = times_unit(d[side], axis);
    const std::int64_t speed = product(across_[side], d[1 - side]);
    if (speed < 0) across_[side] = -across_[side];
    sides_[1 - side][3] = Numbers{0, 0, 0, static_cast<std::uint32_t>(std::abs(speed))};
  }
  constexpr std::uint32_t kSpread = 0x9E3779B1;  // odd, so that it is one to one modulo 2^32
  const auto narrow = [](std::int64_t c) { return static_cast<std::uint32_t>(c); };
  for (std::size_t side = 0; side < 2; ++side) {
    const Vector at = across_[side], low = across_[1 - side];
    for (std::size_t c = 0; c < 3; ++c) {
      sides_[side][c] = Numbers{kSpread * narrow(component(normal_, c)), narrow(component(at, c)),
                                narrow(component(low, c)), 0};
    }
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

/// In a loop that keeps everything it knows of the window in registers.
__attribute__((always_inline)) inline void PlaneMeetings::Intake::add_all(
    std::span<const PlacedSegment> segments, std::size_t side) const {
  const PlaneFamily family = family_;
  RecordBuckets& buckets = *buckets_;
  const std::uint32_t windows = window_.count;
  for (const PlacedSegment& segment : segments) {
    const PlaneRecord record = family.record(segment, side);
    buckets.add(2 * (std::uint64_t{record.plane * windows} >> shift_) + side, record);
  }
}

#if defined(__x86_64__)
__attribute__((target("avx2")))
#endif
void PlaneMeetings::Intake::add_all_avx2(std::span<const PlacedSegment> segments,
                                         std::size_t side) const {
  add_all(segments, side);
}

/// Which segments are in the window is random, so no branch decides it.
void PlaneMeetings::Intake::add(std::span<const PlacedSegment> segments, std::size_t side) const {
  const auto add_taken = [&](std::span<const PlacedSegment> taken) {
    kHasAvx2 ? add_all_avx2(taken, side) : add_all(taken, side);
  };
  if (window_.count == 1) return add_taken(segments);
  std::array<PlacedSegment, 64> taken;
  while (!segments.empty()) {
    const std::size_t size = std::min(taken.size(), segments.size());
    std::size_t count = 0;
    for (const PlacedSegment& segment : segments.first(size)) {
      taken[count] = segment;
      count += scaled(family_.plane_of(segment)) >> 32 == window_.number;
    }
    add_taken(std::span(taken).first(count));
    segments = segments.subspan(size);
  }
}

PlaneMeetings::Intake PlaneMeetings::begin(const PlaneFamily& family, PlaneWindow window,
                                           std::uint64_t expected) {
  constexpr unsigned kMostBits = 11;  // more streams at a time than the memory system follows
  window_ = window;
  bucket_bits_ =
      std::min(kMostBits, static_cast<unsigned>(std::bit_width(expected / sizes_.bucket)));
  buckets_.reset(std::size_t{2} << bucket_bits_);
  return {family, window, 32 - bucket_bits_, buckets_};
}

std::uint64_t PlaneMeetings::finish() {
  std::uint64_t crossing = 0;
  for (std::size_t b = 0; b < buckets_.size(); b += 2) crossing += count_bucket(b);
  return crossing;
}

/// Rows are in this bucket, columns in the next one.
std::uint64_t PlaneMeetings::count_bucket(std::size_t bucket) {
  constexpr std::size_t kMostBins = std::size_t{1} << 15;
  const std::size_t size = std::max(buckets_.size_of(bucket), buckets_.size_of(bucket + 1));
  bin_shift_ =
      33 - static_cast<unsigned>(std::bit_width(std::clamp<std::size_t>(size, 2, kMostBins)));
  into_bins(bucket, bins_[0]);
  if (bins_[0].largest <= sizes_.crowded) return count_crossings(bucket + 1);
  into_bins(bucket + 1, bins_[1]);
  return count_crowded();
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
std::uint64_t PlaneMeetings::count_crossings(std::size_t bucket) const {
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
  return crossing;
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

std::uint64_t PlaneMeetings::count_crowded() {
  constexpr std::size_t kSwept = 5;  // times `crowded` comparisons take as long as a sweep
  std::uint64_t crossing = 0;
  for (std::size_t bin = 0; bin < bins_[0].size(); ++bin) {
    const Records rows = bins_[0][bin], columns = bins_[1][bin];
    if (rows.empty() || columns.empty()) continue;
    if (rows.size() * columns.size() > kSwept * sizes_.crowded * (rows.size() + columns.size())) {
      crossing += crowded_.count(rows, columns);
      continue;
    }
    columns_.take(columns);
    for (const PlaneRecord& row : rows) crossing += columns_.met_by(row);
  }
  return crossing;
}

}  // namespace ar3d::verify
