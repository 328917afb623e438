// Step 3.10. Chains of colours 0 and 1 numbered upwards, a cycle along both of its sides at once
// so that they meet at about the same height. The lowest free height that suits is taken; so X_0 +
// X_1 of a vertex stays small, which is what makes the drawing flat. O(log n) per height tried.
#include <algorithm>
#include <cstdlib>

#include "ar3d/algorithms/grid/flat.h"
#include "ar3d/base/error.h"

namespace ar3d::grid {
namespace {

/// One number of a chain: the plane of an edge of colour 0 or 1, or a free number at a path's end.
struct ChainLink {
  Colour colour = 0;
  std::int64_t height = 0;
};

/// h_0 - h_1 of a vertex between two links.
std::int64_t pair_sum(const ChainLink& a, const ChainLink& b) {
  return a.colour == 0 ? a.height - b.height : b.height - a.height;
}

/// A chain that grows upwards.
class GrowingChain {
 public:
  explicit GrowingChain(HeightPool& pool) : pool_(pool) {}

  ChainLink first(Colour c) {
    const ChainLink link{c, pool_.chain_start(c)};
    floor_ = link.height;
    pool_.take_and_advance(c, link.height);
    return link;
  }

  /// The lowest free height from the last link on that suits v.
  /// `closing`, if not kNoIndex, is the last vertex of a cycle, between the new link and `end`.
  ChainLink after(Index v, const ChainLink& from, Index closing, const ChainLink& end) {
    ChainLink link{1 - from.colour, 0};
    for (std::int64_t h = std::max(from.height - 1, floor_);; ++h) {
      h = pool_.next_free(link.colour, h);
      link.height = h;
      const std::int64_t pair = pair_sum(from, link);
      if (!pool_.is_far_from_partner(v, pair)) continue;
      if (closing != kNoIndex && !suits_closing(v, pair, closing, pair_sum(link, end))) continue;
      pool_.take_and_advance(link.colour, h);
      settle(v, from, link);
      return link;
    }
  }

  void settle(Index v, const ChainLink& a, const ChainLink& b) {
    for (const ChainLink& link : {a, b}) pool_.set_height(v, link.colour, link.height);
  }

 private:
  bool suits_closing(Index v, std::int64_t pair, Index closing, std::int64_t closing_pair) const {
    if (!pool_.is_far_from_partner(closing, closing_pair)) return false;
    return pool_.neighbour(closing, 2) != v || std::abs(closing_pair - pair) >= 2;
  }

  HeightPool& pool_;
  std::int64_t floor_ = 0;
};

}  // namespace

void HeightPool::take(Colour c, std::int64_t h) {
  expect(taken_[c].insert(h), "every plane number is fresh (I3)");
  if (pairs_taken_.empty()) return;
  pairs_taken_[c].insert(h - 1);
  pairs_taken_[c].insert(h);
}

void HeightPool::take_and_advance(Colour c, std::int64_t h) {
  take(c, h);
  frontier_ = std::max(frontier_, h);
}

bool HeightPool::suits(Index v, Colour c, std::int64_t h) const {
  if (!has_height(v, 1 - c)) return true;
  const std::int64_t other = height(v, 1 - c);
  return is_far_from_partner(v, c == 0 ? h - other : other - h);
}

bool HeightPool::is_far_from_partner(Index v, std::int64_t pair) const {
  const Index partner = neighbour(v, 2);
  if (partner == kNoIndex || !is_numbered(partner)) return true;
  return std::abs(pair - (height(partner, 0) - height(partner, 1))) >= 2;
}

std::int64_t HeightPool::chain_start(Colour c) {
  constexpr std::int64_t kBack = 8;
  return next_free(c, frontier_ - kBack);
}

void number_path(HeightPool& pool, Index end) {
  GrowingChain chain(pool);
  const Colour towards = pool.neighbour(end, 0) != kNoIndex ? 0 : 1;
  ChainLink link = chain.first(1 - towards);
  for (Index v = end; v != kNoIndex;) {
    const ChainLink next = chain.after(v, link, kNoIndex, {});
    v = pool.neighbour(v, next.colour);
    link = next;
  }
}

void number_cycle(HeightPool& pool, Index start, std::vector<Index>& buffer) {
  buffer.clear();
  Colour c = 0;
  for (Index v = start; buffer.empty() || v != start; c = 1 - c) {
    buffer.push_back(v);
    v = pool.neighbour(v, c);
  }
  std::size_t a = 0;  // buffer[a] .. buffer[b - 1] have no numbers yet
  std::size_t b = buffer.size();
  GrowingChain chain(pool);
  ChainLink low = chain.first(1);
  ChainLink high = low;
  const auto prefetch_ahead = [&](bool from_front) __attribute__((always_inline)) {
    if (b - a <= std::size_t{2} * kAhead) return;
    pool.prefetch(
        buffer[from_front ? a + std::size_t{2} * kAhead : b - 1 - std::size_t{2} * kAhead]);
    pool.prefetch_partner(buffer[from_front ? a + kAhead : b - 1 - kAhead]);
  };
  while (b - a > 1) {
    const bool from_front = low.height <= high.height;
    prefetch_ahead(from_front);
    ChainLink& side = from_front ? low : high;
    const ChainLink& other = from_front ? high : low;
    const Index v = from_front ? buffer[a++] : buffer[--b];
    side = chain.after(v, side, b - a == 1 ? buffer[a] : kNoIndex, other);
  }
  chain.settle(buffer[a], low, high);
}

}  // namespace ar3d::grid
