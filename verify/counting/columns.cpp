// Steps V.9 and V.10 of docs/verify.md: what meets a vertical segment. In drawings whose long
// segments are vertical, every other segment passes over few places of columns: one parallel to the
// x- or y-axis over those of its line, any other nearly always over the places of its two ends
// only. So a place is looked up in a table, where sorting all segments by height and searching
// would wait for the memory.
#include "ar3d/verify/counting/columns.h"

#include <bit>
#include <numeric>
#include <tuple>

#include "ar3d/verify/crossings/radix_sort.h"
#include "ar3d/verify/predicates/exact.h"

namespace ar3d::verify {
namespace {

/// Sorts the numbers 0, 1, ... of places by (first, second), whose ranges multiply to at most 2^62.
template <class First, class Second>
std::vector<Keyed> order_of(std::size_t size, Span first, Span second, First&& first_of,
                            Second&& second_of) {
  const auto width = static_cast<std::uint64_t>(second.high - second.low) + 1;
  std::vector<Keyed> order(size);
  std::vector<Keyed> buffer;
  for (std::uint32_t i = 0; i < size; ++i) {
    order[i] = {static_cast<std::uint64_t>(first_of(i) - first.low) * width +
                    static_cast<std::uint64_t>(second_of(i) - second.low),
                i};
  }
  sort_by_key(order, buffer);
  return order;
}

template <class Value>
Span bounds_of(std::size_t size, Value&& value_of) {
  Span bounds{value_of(0), value_of(0)};
  for (std::size_t i = 1; i < size; ++i) {
    bounds = {std::min<std::int64_t>(bounds.low, value_of(i)),
              std::max<std::int64_t>(bounds.high, value_of(i))};
  }
  return bounds;
}

}  // namespace

PlaceIndex::PlaceIndex(std::vector<Entry> entries)
    : entries_(std::move(entries)), least_(entries_.front().major) {
  const auto range = static_cast<std::uint64_t>(entries_.back().major - least_);
  const auto range_bits = static_cast<unsigned>(std::bit_width(range));
  const auto size_bits = static_cast<unsigned>(std::bit_width(entries_.size()));
  shift_ = range_bits > size_bits ? range_bits - size_bits : 0;
  table_.assign((range >> shift_) + 2, 0);
  for (const Entry& entry : entries_) {
    ++table_[(static_cast<std::uint64_t>(entry.major - least_) >> shift_) + 1];
  }
  std::partial_sum(table_.begin(), table_.end(), table_.begin());
}

const PlaceIndex::Entry* PlaceIndex::first_from(std::int64_t major, std::int64_t minor) const {
  const Entry* const begin = entries_.data();
  if (major < least_) return begin;
  const std::uint64_t bucket = static_cast<std::uint64_t>(major - least_) >> shift_;
  if (bucket + 1 >= table_.size()) return begin + entries_.size();
  return std::lower_bound(begin + table_[bucket], begin + table_[bucket + 1],
                          std::pair(major, minor), [](const Entry& entry, const auto& place) {
                            return std::pair<std::int64_t, std::int64_t>(entry.major, entry.minor) <
                                   place;
                          });
}

PlaceIndex::Range PlaceIndex::between(std::int32_t major_low, std::int32_t minor_low,
                                      std::int32_t major_high, std::int32_t minor_high) const {
  return {first_from(major_low, minor_low), first_from(major_high, std::int64_t{minor_high} + 1)};
}

Columns::Columns(const std::vector<VerticalSegment>& segments) {
  begin_.push_back(0);
  if (segments.empty()) return;
  sort(segments);
  index();
}

void Columns::sort(const std::vector<VerticalSegment>& segments) {
  const auto x = [&](std::size_t i) { return segments[i].x; };
  const auto y = [&](std::size_t i) { return segments[i].y; };
  const std::size_t size = segments.size();
  const auto order = order_of(size, bounds_of(size, x), bounds_of(size, y), x, y);
  spans_.reserve(size);
  for (std::size_t i = 0; i < size; ++i) {
    const VerticalSegment& segment = segments[order[i].item];
    if (i == 0 || order[i].key != order[i - 1].key) {
      xs_.push_back(segment.x);
      ys_.push_back(segment.y);
      begin_.back() = static_cast<std::uint32_t>(i);
      begin_.push_back(0);
    }
    spans_.push_back({segment.low, segment.high});
  }
  begin_.back() = static_cast<std::uint32_t>(size);
  for (std::size_t c = 0; c + 1 < begin_.size(); ++c) {
    std::sort(spans_.begin() + begin_[c], spans_.begin() + begin_[c + 1],
              [](const Span& a, const Span& b) {
                return std::tie(a.low, a.high) < std::tie(b.low, b.high);
              });
  }
}

void Columns::index() {
  const auto x = [&](std::size_t c) { return xs_[c]; };
  const auto y = [&](std::size_t c) { return ys_[c]; };
  const std::size_t size = xs_.size();
  std::vector<PlaceIndex::Entry> entries(size);
  for (std::uint32_t c = 0; c < size; ++c) entries[c] = {xs_[c], ys_[c], c};
  by_x_ = PlaceIndex(std::move(entries));
  const auto order = order_of(size, bounds_of(size, y), bounds_of(size, x), y, x);
  entries.assign(size, {});
  for (std::size_t i = 0; i < size; ++i) {
    const std::uint32_t c = order[i].item;
    entries[i] = {ys_[c], xs_[c], c};
  }
  by_y_ = PlaceIndex(std::move(entries));
}

std::optional<std::uint64_t> Columns::touching() const {
  std::uint64_t touching = 0;
  for (std::size_t c = 0; c + 1 < begin_.size(); ++c) {
    for (std::uint32_t i = begin_[c] + 1; i < begin_[c + 1]; ++i) {
      if (spans_[i].low < spans_[i - 1].high) return std::nullopt;
      touching += spans_[i].low == spans_[i - 1].high;
    }
  }
  return touching;
}

/// A slanted segment seen from above, which passes over a place at one height.
struct Columns::Projection {
  explicit Projection(const SlantedSegment& segment)
      : s(segment),
        low_x(std::min(s.x, s.x + s.dx)),
        high_x(std::max(s.x, s.x + s.dx)),
        low_y(std::min(s.y, s.y + s.dy)),
        high_y(std::max(s.y, s.y + s.dy)) {}

  /// True if it passes over a place in the box. Products are below 2^31 * 2^31.
  bool passes_over(std::int64_t x, std::int64_t y) const {
    return (x - s.x) * s.dy == (y - s.y) * s.dx;
  }
  /// The height over a place that it passes over, rounded down and up. The product is below
  /// 2^62 * 2^31.
  Span height(std::int64_t x, std::int64_t y) const {
    const std::int64_t run = s.dx != 0 ? s.dx : s.dy;
    const std::int64_t moved = s.dx != 0 ? x - s.x : y - s.y;
    if (moved == 0) return {s.z, s.z};
    if (moved == run) return {s.z + s.dz, s.z + s.dz};
    // Between its ends: moved and run have the same sign, so the quotient is not negative.
    const std::int64_t part = moved < 0 ? -moved : moved;
    const std::int64_t length = run < 0 ? -run : run;
    return s.dz < kLow ? rounded<std::int64_t>(part, length) : rounded<Int128>(part, length);
  }

  static constexpr std::int64_t kLow = std::int64_t{1} << 32;  // products below 2^63
  /// s.z + s.dz * part / length, down and up.
  template <class Integer>
  Span rounded(Integer part, Integer length) const {
    const Integer product = s.dz * part;
    const auto down = static_cast<std::int64_t>(product / length);
    return {s.z + down, s.z + down + (product % length != 0)};
  }

  const SlantedSegment& s;
  std::int32_t low_x;
  std::int32_t high_x;
  std::int32_t low_y;
  std::int32_t high_y;
};

/// Returns how many segments of a column reach a height, given rounded down and up. They do not
/// overlap, so upwards their upper ends do not fall.
std::uint64_t Columns::count(std::uint32_t column, std::int64_t low, std::int64_t high) const {
  const auto begin = spans_.begin() + begin_[column];
  auto next = std::upper_bound(begin, spans_.begin() + begin_[column + 1], low,
                               [](std::int64_t z, const Span& span) { return z < span.low; });
  std::uint64_t count = 0;
  while (next != begin && (--next)->high >= high) ++count;
  return count;
}

std::uint64_t Columns::met_at(std::uint32_t column, const Projection& p, std::int64_t x,
                              std::int64_t y) const {
  const Span height = p.height(x, y);
  return count(column, height.low, height.high);
}

std::uint64_t Columns::met_in(PlaceIndex::Range places, const Projection& p, bool swapped) const {
  std::uint64_t met = 0;
  for (const PlaceIndex::Entry* entry = places.first; entry != places.second; ++entry) {
    const std::int64_t x = swapped ? entry->minor : entry->major;
    const std::int64_t y = swapped ? entry->major : entry->minor;
    const bool in_box = x >= p.low_x && x <= p.high_x && y >= p.low_y && y <= p.high_y;
    if (in_box && p.passes_over(x, y)) met += met_at(entry->column, p, x, y);
  }
  return met;
}

std::uint64_t Columns::met_at_lattice_points(const Projection& p) const {
  const std::int32_t steps = std::gcd(p.s.dx, p.s.dy);
  const std::int32_t step_x = p.s.dx / steps;
  const std::int32_t step_y = p.s.dy / steps;
  std::uint64_t met = 0;
  for (std::int32_t i = 0; i <= steps; ++i) {
    const std::int32_t x = p.s.x + i * step_x;
    const std::int32_t y = p.s.y + i * step_y;
    const auto [at, end] = by_x_.between(x, y, x, y);
    if (at != end) met += met_at(at->column, p, x, y);
  }
  return met;
}

std::uint64_t Columns::met_by(const SlantedSegment& s) const {
  if (xs_.empty()) return 0;
  const Projection p(s);
  if (s.dx == 0) return met_in(by_x_.between(s.x, p.low_y, s.x, p.high_y), p, false);
  if (s.dy == 0) return met_in(by_y_.between(s.y, p.low_x, s.y, p.high_x), p, true);
  const std::ptrdiff_t steps = std::gcd(s.dx, s.dy);
  if (steps <= 2) return met_at_lattice_points(p);
  const auto size = [](PlaceIndex::Range range) { return range.second - range.first; };
  const auto by_x = by_x_.between(p.low_x, p.low_y, p.high_x, p.high_y);
  const auto by_y = by_y_.between(p.low_y, p.low_x, p.high_y, p.high_x);
  if (steps <= std::min(size(by_x), size(by_y))) return met_at_lattice_points(p);
  return size(by_x) <= size(by_y) ? met_in(by_x, p, false) : met_in(by_y, p, true);
}

}  // namespace ar3d::verify
