#include "ar3d/verify/modes/candidate_pairs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ar3d/base/error.h"
#include "ar3d/model/drawing.h"
#include "ar3d/verify/metrics/functional.h"

namespace ar3d::verify {
namespace {

std::int64_t floor_of(Int128 numerator, Int128 denominator) {  // denominator > 0
  const Int128 down = numerator / denominator;
  return static_cast<std::int64_t>(down - (numerator % denominator < 0));
}

/// Values that a coordinate takes on a segment while another runs from `low` to `high`, rounded
/// outwards. Products are below 2^62 * 2^63.
struct Range {
  std::int64_t low;
  std::int64_t high;
};

Range range_within(const Item& item, std::size_t leading, std::size_t axis, Range run) {
  const std::int64_t start = component(item.from, leading), at = component(item.from, axis);
  const std::int64_t length = component(item.to, leading) - start;
  const std::int64_t rise = component(item.to, axis) - at;
  const auto value = [&](std::int64_t place) {  // length > 0
    return at + floor_of(Int128{rise} * (place - start), length);
  };
  const std::int64_t a = value(run.low), b = value(run.high);
  return {std::min(a, b), std::max(a, b) + 1};
}

}  // namespace

CandidatePairs::Cells CandidatePairs::cell_of(Point p) const {
  Cells cell{};
  for (std::size_t i = 0; i < 3; ++i) {
    cell[i] = std::clamp<std::int64_t>((component(p, i) - component(low_, i)) / size_[i], 0,
                                       count_[i] - 1);
  }
  return cell;
}

/// Layer after layer along the axis of most cells: in each, all cells of the box of the item's part
/// in it.
template <class Visit>
void CandidatePairs::for_each_cell(const Item& item, Visit&& visit) const {
  const Cells from = cell_of(item.from), to = cell_of(item.to);
  std::size_t leading = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (std::abs(to[i] - from[i]) > std::abs(to[leading] - from[leading])) leading = i;
  }
  Item upwards = item;
  if (component(item.from, leading) > component(item.to, leading)) {
    std::swap(upwards.from, upwards.to);
  }
  const std::size_t j = (leading + 1) % 3, k = (leading + 2) % 3;
  const std::int64_t first = std::min(from[leading], to[leading]);
  const std::int64_t last = std::max(from[leading], to[leading]);
  for (std::int64_t layer = first; layer <= last; ++layer) {
    const std::int64_t bottom = component(low_, leading) + layer * size_[leading];
    const Range run{std::max(bottom, component(upwards.from, leading)),
                    std::min(bottom + size_[leading], component(upwards.to, leading))};
    Cells low = from, high = to;
    for (const std::size_t axis : {j, k}) {
      if (first == last) {
        if (low[axis] > high[axis]) std::swap(low[axis], high[axis]);
        continue;
      }
      const Range range = range_within(upwards, leading, axis, run);
      Point p = low_;
      (axis == 0 ? p.x : axis == 1 ? p.y : p.z) = range.low;
      low[axis] = cell_of(p)[axis];
      (axis == 0 ? p.x : axis == 1 ? p.y : p.z) = range.high;
      high[axis] = cell_of(p)[axis];
    }
    for (std::int64_t a = low[j]; a <= high[j]; ++a) {
      for (std::int64_t b = low[k]; b <= high[k]; ++b) {
        Cells cell{};
        cell[leading] = layer;
        cell[j] = a;
        cell[k] = b;
        visit(static_cast<std::size_t>((cell[0] * count_[1] + cell[1]) * count_[2] + cell[2]));
      }
    }
  }
}

CandidatePairs::CandidatePairs(const std::vector<Item>& items, std::size_t most_places) {
  if (items.size() > kMostItems) {
    throw InputError(
        fmt::format("{} segments: certificates other than exact and none take at most "
                    "{}",
                    items.size(), kMostItems));
  }
  GrowingBox box;
  for (const Item& item : items) {
    box.add(item.from);
    box.add(item.to);
  }
  low_ = box.box().low;
  const std::array<std::int64_t, 3> extents = box.box().extents();
  const auto wanted = static_cast<std::int64_t>(std::cbrt(static_cast<double>(items.size()))) + 1;
  for (std::size_t i = 0; i < 3; ++i) {
    size_[i] = extents[i] / wanted + 1;
    count_[i] = extents[i] / size_[i] + 1;
  }
  begin_.assign(static_cast<std::size_t>(count_[0] * count_[1] * count_[2]) + 1, 0);
  for (const Item& item : items) for_each_cell(item, [&](std::size_t cell) { ++begin_[cell]; });
  first_pair_.reserve(begin_.size());
  std::uint64_t pairs = 0;
  std::size_t places = 0;
  for (std::size_t& begin : begin_) {
    first_pair_.push_back(pairs);
    pairs += begin > 0 ? std::uint64_t{begin} * (begin - 1) / 2 : 0;
    places += begin;
    begin = places;
  }
  if (places > most_places) {
    throw InputError(
        fmt::format("certificates other than exact and none need more than {} places "
                    "of segments in cells for this drawing",
                    most_places));
  }
  places_.resize(places);
  for (std::size_t i = items.size(); i-- > 0;) {  // backwards: begin_ are ends so far
    for_each_cell(items[i], [&](std::size_t cell) {
      places_[--begin_[cell]] = static_cast<std::uint32_t>(i);
    });
  }
}

std::pair<std::uint32_t, std::uint32_t> CandidatePairs::operator[](std::uint64_t number) const {
  const auto after = std::upper_bound(first_pair_.begin(), first_pair_.end(), number);
  const auto cell = static_cast<std::size_t>(after - first_pair_.begin()) - 1;
  const std::uint64_t within = number - first_pair_[cell];
  // Pair (i, j) of the cell, i < j, has the number j (j - 1) / 2 + i.
  auto j = static_cast<std::uint64_t>((1 + std::sqrt(1 + 8 * static_cast<double>(within))) / 2);
  while (j * (j - 1) / 2 > within) --j;
  while (j * (j + 1) / 2 <= within) ++j;
  const std::size_t begin = begin_[cell];
  return {places_[begin + (within - j * (j - 1) / 2)], places_[begin + j]};
}

}  // namespace ar3d::verify
