// Step 1.10. Where the two largest cycles are closed. A closing edge is the longest edge of most
// drawings, and closing one colour's cycle elsewhere moves the ranks of the other; so pairs of
// closing edges are judged together: 16 random green ones, each against every red one. O(n). Idea:
// not in the paper.
#include <algorithm>

#include "ar3d/algorithms/diamond/parity.h"
#include "ar3d/base/random.h"

namespace ar3d::diamond {
namespace {

constexpr unsigned kSamples = 16;
constexpr std::uint64_t kRotationSeed = 0x726f74617465;

std::uint32_t largest_cycle(const Items& items) {
  std::uint32_t best = kNone;
  for (std::uint32_t item = 0; item < items.count(); ++item) {
    if (items.is_cycle(item) && (best == kNone || items.size(item) > items.size(best))) best = item;
  }
  return best;
}

/// One colour's order with one cycle that can still be rotated.
class Rotatable {
 public:
  Rotatable(const Items& items, std::uint32_t cycle)
      : begin_(items.begin[cycle]), size_(items.size(cycle)), index_(items.vertex.size()) {
    for (std::uint32_t i = 0; i < index_.size(); ++i) index_[items.vertex[i]] = i;
  }

  std::uint32_t size() const { return size_; }

  /// The rank of v after the cycle has been closed at its edge `closing`.
  std::int64_t rank(Vertex v, std::uint32_t closing) const {
    const std::uint32_t i = index_[v] - begin_;  // wraps to a large number outside the cycle
    if (i >= size_) return index_[v];
    return begin_ + (i > closing ? i - closing - 1 : i + size_ - closing - 1);
  }

 private:
  std::uint32_t begin_;
  std::uint32_t size_;
  std::vector<std::uint32_t> index_;
};

/// Twice the height that a closing edge with ends of these ranks costs, of n ranks.
std::int64_t reach(std::int64_t a, std::int64_t b, std::int64_t n) {
  return std::min(a + b, 2 * (n - 1) - a - b);
}

}  // namespace

bool rotate_jointly(Items& green, Items& red) {
  const std::uint32_t green_cycle = largest_cycle(green);
  const std::uint32_t red_cycle = largest_cycle(red);
  if (green_cycle == kNone || red_cycle == kNone) return false;
  const Rotatable x(green, green_cycle);
  const Rotatable y(red, red_cycle);
  const auto n = static_cast<std::int64_t>(green.vertex.size());
  const auto g = green.of(green_cycle);
  const auto r = red.of(red_cycle);
  RandomStream random(kRotationSeed, static_cast<std::uint64_t>(n));
  std::int64_t best = 4 * n;  // more than any sum of two reaches
  std::uint32_t best_green = 0;
  std::uint32_t best_red = 0;
  for (unsigned sample = 0; sample < kSamples; ++sample) {
    const std::uint32_t i = random.below(x.size());
    const Vertex u = g[i];
    const Vertex w = g[i + 1 == x.size() ? 0 : i + 1];
    std::int64_t previous = x.rank(r[0], i);
    for (std::uint32_t j = 0; j < y.size(); ++j) {
      const std::int64_t next = x.rank(r[j + 1 == y.size() ? 0 : j + 1], i);
      const std::int64_t cost = reach(y.rank(u, j), y.rank(w, j), n) + reach(previous, next, n);
      if (cost < best) {
        best = cost;
        best_green = i;
        best_red = j;
      }
      previous = next;
    }
  }
  green.close_at(green_cycle, best_green);
  red.close_at(red_cycle, best_red);
  return true;
}

}  // namespace ar3d::diamond
