#include "ar3d/verify/crossings/slab_columns.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

#include "ar3d/verify/checks/exact.h"

namespace ar3d::verify {
namespace {

using Place = std::pair<std::int64_t, std::int64_t>;
constexpr std::int64_t kLeast = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t kLargest = std::numeric_limits<std::int64_t>::max();

Int128 rounded_down(Int128 numerator, Int128 denominator) {
  const Int128 quotient = numerator / denominator;
  const bool inexact = quotient * denominator != numerator;
  return quotient - (inexact && (numerator < 0) != (denominator < 0) ? 1 : 0);
}

}  // namespace

/// A segment that is not vertical: a is one end, a + d the other; low and high span its
/// projection's box.
struct SlabColumns::Projection {
  Projection(Point from, Point to, SegmentId id)
      : a(from),
        d(to - from),
        low{std::min(from.x, to.x), std::min(from.y, to.y)},
        high{std::max(from.x, to.x), std::max(from.y, to.y)},
        segment(id) {}

  /// Lattice steps from end to end in the plane: it passes over one lattice point more.
  std::int64_t steps() const { return std::gcd(d.x, d.y); }

  bool passes_over(std::int64_t x, std::int64_t y) const {
    return x >= low.first && x <= high.first && y >= low.second && y <= high.second &&
           Int128{x - a.x} * d.y == Int128{y - a.y} * d.x;
  }
  /// The segment's height over a place that it passes over, rounded down and up. Products are below
  /// 2^124.
  std::pair<std::int64_t, std::int64_t> height(std::int64_t x, std::int64_t y) const {
    const Int128 moved = Int128{d.z} * (d.x != 0 ? x - a.x : y - a.y);
    const std::int64_t length = d.x != 0 ? d.x : d.y;
    return {a.z + static_cast<std::int64_t>(rounded_down(moved, length)),
            a.z - static_cast<std::int64_t>(rounded_down(-moved, length))};
  }

  Point a;
  Vector d;
  Place low;
  Place high;
  SegmentId segment;
};

void SlabColumns::build(const std::vector<SegmentId>& verticals) {
  verticals_.clear();
  for (const SegmentId s : verticals) {
    const Point p = segments_.from(s);
    const Point q = segments_.to(s);
    verticals_.push_back({p.x, p.y, std::min(p.z, q.z), std::max(p.z, q.z), 0, s});
  }
  std::sort(verticals_.begin(), verticals_.end(), [](const Vertical& a, const Vertical& b) {
    return std::tie(a.x, a.y, a.low) < std::tie(b.x, b.y, b.low);
  });
  build_columns();
}

void SlabColumns::build_columns() {
  by_x_.clear();
  for (std::uint32_t i = 0; i < verticals_.size(); ++i) {
    Vertical& vertical = verticals_[i];
    vertical.highest = vertical.high;
    if (by_x_.empty() || Place(by_x_.back().x, by_x_.back().y) != Place(vertical.x, vertical.y)) {
      by_x_.push_back({vertical.x, vertical.y, i, i});
    } else {
      vertical.highest = std::max(vertical.high, verticals_[i - 1].highest);
    }
    by_x_.back().end = i + 1;
  }
  by_y_ = by_x_;
  std::sort(by_y_.begin(), by_y_.end(), [](const Column& a, const Column& b) {
    return std::tie(a.y, a.x) < std::tie(b.y, b.x);
  });
}

void SlabColumns::examine_verticals() {
  for (const Column& column : by_x_) {
    for (std::uint32_t i = column.begin; i < column.end; ++i) {
      for (std::uint32_t j = i + 1; j < column.end && verticals_[j].low <= verticals_[i].high;
           ++j) {
        if (contacts_.done()) return;
        contacts_.examine(verticals_[i].segment, verticals_[j].segment);
      }
    }
  }
}

template <class Visit>
void SlabColumns::for_each_between(const Column& column, std::int64_t low, std::int64_t high,
                                   Visit&& visit) const {
  const auto begin = verticals_.begin() + column.begin;
  auto next = std::upper_bound(begin, verticals_.begin() + column.end, high,
                               [](std::int64_t z, const Vertical& v) { return z < v.low; });
  // Downwards from the last one that begins low enough; nothing below one with a smaller `highest`
  // reaches up.
  while (next != begin && (--next)->highest >= low) {
    if (next->high >= low) visit(next->segment);
  }
}

const SlabColumns::Column* SlabColumns::find(std::int64_t x, std::int64_t y) const {
  const auto found = std::lower_bound(
      by_x_.begin(), by_x_.end(), Place(x, y),
      [](const Column& column, const Place& place) { return Place(column.x, column.y) < place; });
  return found != by_x_.end() && found->x == x && found->y == y ? &*found : nullptr;
}

void SlabColumns::examine_vertex(Vertex v) {
  const Point p = segments_.drawing().vertex(v);
  const Column* column = find(p.x, p.y);
  if (!column) return;
  for_each_between(*column, p.z, p.z, [&](SegmentId s) { contacts_.examine_vertex(v, s); });
}

SlabColumns::Places SlabColumns::within_x(const Projection& projection) const {
  const bool straight = projection.d.x == 0;  // then y cuts the range, too
  const Place low{projection.low.first, straight ? projection.low.second : kLeast};
  const Place high{projection.high.first, straight ? projection.high.second : kLargest};
  const auto before = [](const Column& c, const Place& p) { return Place(c.x, c.y) < p; };
  const auto after = [](const Place& p, const Column& c) { return p < Place(c.x, c.y); };
  const Column* end = by_x_.data() + by_x_.size();
  return {std::lower_bound(by_x_.data(), end, low, before),
          std::upper_bound(by_x_.data(), end, high, after)};
}

SlabColumns::Places SlabColumns::within_y(const Projection& projection) const {
  const bool straight = projection.d.y == 0;
  const Place low{projection.low.second, straight ? projection.low.first : kLeast};
  const Place high{projection.high.second, straight ? projection.high.first : kLargest};
  const auto before = [](const Column& c, const Place& p) { return Place(c.y, c.x) < p; };
  const auto after = [](const Place& p, const Column& c) { return p < Place(c.y, c.x); };
  const Column* end = by_y_.data() + by_y_.size();
  return {std::lower_bound(by_y_.data(), end, low, before),
          std::upper_bound(by_y_.data(), end, high, after)};
}

void SlabColumns::examine_at(const Projection& projection, const Column& column) {
  const auto [low, high] = projection.height(column.x, column.y);
  for_each_between(column, low, high,
                   [&](SegmentId s) { contacts_.examine(s, projection.segment); });
}

void SlabColumns::examine_slanted(SegmentId s) {
  const Projection projection(segments_.from(s), segments_.to(s), s);
  const Places by_x = within_x(projection);
  const Places by_y = within_y(projection);
  const Places fewer = by_x.second - by_x.first < by_y.second - by_y.first ? by_x : by_y;
  const std::int64_t steps = projection.steps();
  const auto columns = std::min<std::int64_t>(fewer.second - fewer.first, steps);
  contacts_.spend(static_cast<std::uint64_t>(columns));
  if (contacts_.done()) return;
  if (fewer.second - fewer.first <= steps) {
    for (const Column* column = fewer.first; column != fewer.second; ++column) {
      if (projection.passes_over(column->x, column->y)) examine_at(projection, *column);
    }
    return;
  }
  const Vector step{projection.d.x / steps, projection.d.y / steps, 0};
  for (std::int64_t i = 0; i <= steps; ++i) {
    const Column* column = find(projection.a.x + i * step.x, projection.a.y + i * step.y);
    if (column) examine_at(projection, *column);
  }
}

}  // namespace ar3d::verify
