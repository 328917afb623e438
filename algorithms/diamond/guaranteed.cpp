#include "ar3d/algorithms/diamond/guaranteed.h"

#include <algorithm>

#include "ar3d/algorithms/diamond/ordering.h"
#include "ar3d/model/error.h"

namespace ar3d::theorem1 {
namespace {

// Coordinates here are x = X/2 and y = Y/2.

/// The closing edge of a green cycle, and the red item that holds the whole cycle, or kNone.
struct GreenClosing {
  Vertex u = 0;
  Vertex w = 0;
  std::uint32_t contained_in = kNone;
};

/// Lists of numbers, one list a bucket; linear in all.
class Buckets {
 public:
  Buckets(std::size_t buckets, std::size_t entries)
      : head_(buckets, kNone), next_(entries, kNone) {}
  void add(std::uint32_t bucket, std::uint32_t entry) {
    next_[entry] = head_[bucket];
    head_[bucket] = entry;
  }
  template <class Visit>
  void for_each(std::uint32_t bucket, Visit visit) const {
    for (std::uint32_t entry = head_[bucket]; entry != kNone; entry = next_[entry]) visit(entry);
  }

 private:
  std::vector<std::uint32_t> head_;
  std::vector<std::uint32_t> next_;
};

std::uint32_t distance(std::uint32_t a, std::uint32_t b) { return a > b ? a - b : b - a; }

/// Step 2. Closes a green cycle at an edge between two red items if it has one. Else the cycle is
/// contained in one red item, and it is closed at an edge whose distance there is not k - 1, its
/// distance in x. One exists: at the cycle's first vertex in the red item, the two edges have
/// different distances.
GreenClosing close_green_cycle(Items& green, std::uint32_t cycle, const Whereabouts& red) {
  const auto v = green.of(cycle);
  const auto k = static_cast<std::uint32_t>(v.size());
  std::uint32_t external = kNone;
  std::uint32_t inner = kNone;
  for (std::uint32_t i = 0; i < k && external == kNone; ++i) {
    const Vertex a = v[i];
    const Vertex b = v[i + 1 == k ? 0 : i + 1];
    if (red.item[a] != red.item[b]) external = i;
    if (distance(red.position[a], red.position[b]) != k - 1) inner = i;
  }
  expect(external != kNone || inner != kNone, "a contained green cycle has an edge to close at");
  green.close_at(cycle, external != kNone ? external : inner);
  return {green.first(cycle), green.last(cycle),
          external != kNone ? kNone : red.item[green.first(cycle)]};
}

std::vector<GreenClosing> close_green_cycles(Items& green, const Whereabouts& red) {
  std::vector<GreenClosing> closings;
  for (std::uint32_t item = 0; item < green.count(); ++item) {
    if (green.is_cycle(item)) closings.push_back(close_green_cycle(green, item, red));
  }
  return closings;
}

/// Step 3. Neighbouring lines, but for a free one at each bad boundary of the green order.
std::int64_t assign_x(const Graph& graph, const Items& green, std::vector<PlanePoint>& at) {
  const std::vector<bool> bad = bad_boundaries(graph, green);
  std::int32_t x = 0;
  for (std::uint32_t item = 0; item < green.count(); ++item) {
    x += bad[item];
    for (const Vertex v : green.of(item)) at[v].X = x++;
  }
  return std::count(bad.begin(), bad.end(), true);
}

std::int32_t x_distance(const std::vector<PlanePoint>& at, Vertex u, Vertex v) {
  return std::abs(at[u].X - at[v].X);
}

/// Step 4 for red cycles without a contained green cycle: closes at an edge with |dx| != k - 1. One
/// exists, since a closed walk of k steps of length k - 1 does not visit k distinct integers.
void close_red_cycle(Items& red, std::uint32_t cycle, const std::vector<PlanePoint>& at) {
  const auto v = red.of(cycle);
  const std::size_t k = v.size();
  std::size_t i = k - 1;  // the natural closing edge first
  while (x_distance(at, v[i], v[(i + 1) % k]) == static_cast<std::int32_t>(k) - 1) {
    i = (i + 1) % k;
    expect(i != k - 1, "a red cycle has an edge to close at");
  }
  red.close_at(cycle, static_cast<std::uint32_t>(i));
}

/// The first vertex of a red cycle is moved down by `first` lines and the last one up by `last`
/// lines.
struct Bump {
  std::uint8_t first = 0;
  std::uint8_t last = 0;
};

/// Step 4 for a red cycle R that contains a green cycle. Its rotation stays, since the green
/// closings rely on it; instead its two ends move out until all four kinds of edges there keep |dx|
/// != |dy|.
class BumpSearch {
 public:
  BumpSearch(const Items& red, std::uint32_t cycle, const std::vector<PlanePoint>& at)
      : v_(red.of(cycle)), base_(red.begin[cycle]), at_(at) {}

  /// A closing edge inside R; only those at R's ends matter.
  void add_inner(const GreenClosing& closing) {
    for (const Vertex end : {v_.front(), v_.back()}) {
      if (closing.u == end || closing.w == end) inner_.push_back(closing);
    }
  }

  /// The smallest total works with at most 3: moving only the last vertex, the edge before it
  /// excludes one value, an inner closing at it another, and the closing edge none but 0.
  Bump find(const Whereabouts& natural) const {
    for (unsigned total = 0; total <= 3; ++total) {
      for (unsigned last = 0; last <= total; ++last) {
        const Bump bump{static_cast<std::uint8_t>(total - last), static_cast<std::uint8_t>(last)};
        if (works(bump, natural)) return bump;
      }
    }
    throw InternalError("internal error: no bump of at most 3 lines works");
  }

 private:
  bool works(Bump bump, const Whereabouts& natural) const {
    const std::size_t k = v_.size();
    const auto y = [&](Vertex v) {
      const auto p = static_cast<std::int32_t>(natural.position[v] - base_);
      return v == v_.front() ? p - bump.first : v == v_.back() ? p + bump.last : p;
    };
    const auto apart = [&](Vertex u, Vertex w) {
      return x_distance(at_, u, w) != std::abs(y(u) - y(w));
    };
    return apart(v_.front(), v_.back()) && apart(v_[0], v_[1]) && apart(v_[k - 2], v_[k - 1]) &&
           std::all_of(inner_.begin(), inner_.end(),
                       [&](const GreenClosing& c) { return apart(c.u, c.w); });
  }

  std::span<const Vertex> v_;
  std::uint32_t base_;
  const std::vector<PlanePoint>& at_;
  std::vector<GreenClosing> inner_;
};

/// Step 4. Rotates or bumps every red cycle; the bumps, by natural item.
std::vector<Bump> settle_red_cycles(Items& red, const std::vector<GreenClosing>& closings,
                                    const std::vector<PlanePoint>& at, const Whereabouts& natural,
                                    GapCount& gaps) {
  Buckets inner(red.count(), closings.size());
  std::vector<bool> contains(red.count(), false);
  for (std::uint32_t i = 0; i < closings.size(); ++i) {
    if (closings[i].contained_in == kNone) continue;
    inner.add(closings[i].contained_in, i);
    contains[closings[i].contained_in] = true;
    ++gaps.contained;
  }
  std::vector<Bump> bumps(red.count());
  for (std::uint32_t item = 0; item < red.count(); ++item) {
    if (!red.is_cycle(item)) continue;
    if (!contains[item]) {
      close_red_cycle(red, item, at);
      continue;
    }
    BumpSearch search(red, item, at);
    inner.for_each(item, [&](std::uint32_t i) { search.add_inner(closings[i]); });
    bumps[item] = search.find(natural);
    ++gaps.rho;
    gaps.bumps += bumps[item].first + bumps[item].last;
  }
  return bumps;
}

/// y of the item's vertices relative to its first one.
void assign_relative_y(const Items& red, std::uint32_t item, Bump bump,
                       std::vector<PlanePoint>& at) {
  const auto v = red.of(item);
  std::int32_t y = 0;
  for (std::size_t i = 0; i < v.size(); ++i, ++y) {
    if (i == 1) y += bump.first;
    if (i > 0 && i + 1 == v.size()) y += bump.last;
    at[v[i]].Y = y;
  }
}

/// Step 6. Each red item stands rigidly on the least line above the earlier ones on which no green
/// closing edge to an earlier item has |dx| = |dy|, and not right above a bad boundary.
class RedStack {
 public:
  RedStack(const Items& red, const std::vector<GreenClosing>& closings,
           const std::vector<bool>& bad, std::vector<PlanePoint>& at)
      : red_(red), closings_(closings), bad_(bad), at_(at), late_(red.count(), closings.size()) {
    const Whereabouts where = whereabouts(red);
    for (std::uint32_t i = 0; i < closings.size(); ++i) {
      if (closings[i].contained_in != kNone) continue;
      auto [u, w, unused] = closings[i];
      if (where.position[u] < where.position[w]) std::swap(u, w);
      closings_[i] = {u, w, kNone};  // u is in the later item
      late_.add(where.item[u], i);
    }
  }

  std::int64_t run() {
    std::int64_t offsets = 0;
    std::int32_t base = 0;
    for (std::uint32_t item = 0; item < red_.count(); ++item) {
      const std::int32_t g = offset(item, base);
      offsets += g;
      for (const Vertex v : red_.of(item)) at_[v].Y += base + g;
      base = at_[red_.last(item)].Y + 1;
    }
    return offsets;
  }

 private:
  std::int32_t offset(std::uint32_t item, std::int32_t base) {
    forbidden_.clear();
    if (bad_[item]) forbidden_.push_back(0);
    late_.for_each(item, [&](std::uint32_t i) {
      const auto [u, w, unused] = closings_[i];
      forbidden_.push_back(at_[w].Y + x_distance(at_, u, w) - base - at_[u].Y);
    });
    std::vector<bool> is_forbidden(forbidden_.size() + 1,
                                   false);  // some value up to the size is free
    for (const std::int32_t g : forbidden_) {
      if (g >= 0 && static_cast<std::size_t>(g) < is_forbidden.size()) {
        is_forbidden[static_cast<std::size_t>(g)] = true;
      }
    }
    const auto free = std::find(is_forbidden.begin(), is_forbidden.end(), false);
    return static_cast<std::int32_t>(free - is_forbidden.begin());
  }

  const Items& red_;
  std::vector<GreenClosing> closings_;
  const std::vector<bool>& bad_;
  std::vector<PlanePoint>& at_;
  Buckets late_;
  std::vector<std::int32_t> forbidden_;
};

}  // namespace

GuaranteedPlacement place_guaranteed(const Graph& graph, Items green, Items red) {
  GuaranteedPlacement result;
  auto& [placement, gaps] = result;
  auto& at = placement.at;
  at.resize(graph.num_vertices());
  gaps.m_green = count_cycles(green);
  gaps.m_red = count_cycles(red);

  const Whereabouts natural = whereabouts(red);
  const std::vector<GreenClosing> closings = close_green_cycles(green, natural);
  placement.green = arranged(green, order_items(graph, green));
  gaps.green_gaps = assign_x(graph, placement.green, at);
  // Nothing below changes an x; nothing after settle_red_cycles changes distances inside a red
  // item.
  const std::vector<Bump> bumps = settle_red_cycles(red, closings, at, natural, gaps);
  const Arrangement order = order_items(graph, red);
  placement.red = arranged(red, order);
  for (std::uint32_t i = 0; i < red.count(); ++i) {
    const auto [item, reversed] = order.places[i];
    const Bump bump = bumps[item];
    assign_relative_y(placement.red, i, reversed ? Bump{bump.last, bump.first} : bump, at);
  }
  const std::vector<bool> bad = bad_boundaries(graph, placement.red);
  gaps.red_gaps = std::count(bad.begin(), bad.end(), true);
  gaps.offsets = RedStack(placement.red, closings, bad, at).run();
  for (PlanePoint& p : at) p = {2 * p.X, 2 * p.Y};
  expect_heavy([&] { return keeps_invariants(graph, placement); },
               "the guaranteed placement is right");
  return result;
}

}  // namespace ar3d::theorem1
