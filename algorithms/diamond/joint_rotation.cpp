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

/// The ranks in one colour's order: rank(v, closing) is that of v after the cycle has been closed at
/// its edge `closing`.
auto ranks_of(const Items& items, std::uint32_t cycle) {
  std::vector<std::uint32_t> index(items.vertex.size());
  for (std::uint32_t i = 0; i < index.size(); ++i) index[items.vertex[i]] = i;
  return [begin = items.begin[cycle], size = items.size(cycle), index = std::move(index)](
             Vertex v, std::uint32_t closing) -> std::int64_t {
    const std::uint32_t i = index[v] - begin;  // wraps to a large number outside the cycle
    if (i >= size) return index[v];
    return begin + (i > closing ? i - closing - 1 : i + size - closing - 1);
  };
}

/// Twice the height that a closing edge with ends of these ranks costs, of n ranks.
std::int64_t reach(std::int64_t a, std::int64_t b, std::int64_t n) {
  return std::min(a + b, 2 * (n - 1) - a - b);
}

}  // namespace

bool rotate_jointly(Items& green, Items& red) {
  const std::uint32_t green_cycle = largest_cycle(green);
  const std::uint32_t red_cycle = largest_cycle(red);
  if (green_cycle == kNone || red_cycle == kNone) return false;
  const auto x_rank = ranks_of(green, green_cycle);
  const auto y_rank = ranks_of(red, red_cycle);
  const auto n = static_cast<std::int64_t>(green.vertex.size());
  const auto g = green.of(green_cycle);
  const auto r = red.of(red_cycle);
  RandomStream random(kRotationSeed, static_cast<std::uint64_t>(n));
  std::int64_t best = 4 * n;  // more than any sum of two reaches
  std::uint32_t best_green = 0;
  std::uint32_t best_red = 0;
  for (unsigned sample = 0; sample < kSamples; ++sample) {
    const std::uint32_t i = random.below(green.size(green_cycle));
    const Vertex u = g[i];
    const Vertex w = g[i + 1 == g.size() ? 0 : i + 1];
    std::int64_t previous = x_rank(r[0], i);
    for (std::uint32_t j = 0; j < r.size(); ++j) {
      const std::int64_t next = x_rank(r[j + 1 == r.size() ? 0 : j + 1], i);
      const std::int64_t cost = reach(y_rank(u, j), y_rank(w, j), n) + reach(previous, next, n);
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
