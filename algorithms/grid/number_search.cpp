// How a plane number is found (Lemma 3.4): 64 candidates in one word, the near blocks in turn,
// then random blocks of ever longer stretches. At most half of a long stretch is spoiled, so O(log
// n) blocks are looked at in expectation, on every input; a plain scan would be quadratic on some.
#include "ar3d/algorithms/grid/number_search.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

namespace ar3d::grid {
namespace {

constexpr std::int64_t kBlock = 64;
constexpr std::int64_t kNearBlocks = 32;
constexpr int kProbes = 4;

/// Clears the bits of the numbers within 1 of `forbidden` in the block of 64 that begins at x.
std::uint64_t clear_around(std::uint64_t bits, std::int64_t x, std::int64_t forbidden) {
  for (std::int64_t bit = forbidden - x - 1; bit <= forbidden - x + 1; ++bit) {
    if (bit >= 0 && bit < kBlock) bits &= ~(std::uint64_t{1} << bit);
  }
  return bits;
}

}  // namespace

std::uint64_t NumberSearch::block(std::int64_t x, const NumberSet& taken,
                                  std::span<const SumRule> rules) {
  ++blocks_;
  std::uint64_t free = ~taken.window(x);
  for (const SumRule& rule : rules) {
    if (rule.is_new) free &= ~sums_.window(x + rule.known);
    for (unsigned i = 0; i < rule.num_joined; ++i) {
      free = clear_around(free, x, rule.joined[i] - rule.known);
    }
  }
  return free;
}

bool NumberSearch::obeys(std::int64_t x, const SumRule& rule) const {
  const std::int64_t sum = rule.known + x;
  if (rule.is_new && sums_.contains(sum)) return false;
  return std::all_of(rule.joined.begin(), rule.joined.begin() + rule.num_joined,
                     [&](std::int64_t other) { return std::abs(sum - other) >= 2; });
}

std::optional<std::int64_t> NumberSearch::in_block(Direction direction, const NumberSet& taken,
                                                   std::span<const SumRule> rules, Range range,
                                                   std::int64_t offset) {
  if (direction == Direction::up) {
    const std::int64_t x = range.low + offset;
    const std::uint64_t bits = block(x, taken, rules);
    const std::int64_t found = x + std::countr_zero(bits);
    if (bits == 0 || found > range.high) return std::nullopt;
    return found;
  }
  const std::int64_t x = range.high - offset - (kBlock - 1);
  const std::uint64_t bits = block(x, taken, rules);
  const std::int64_t found = x + (kBlock - 1) - std::countl_zero(bits);
  if (bits == 0 || found < range.low) return std::nullopt;
  return found;
}

std::optional<std::int64_t> NumberSearch::near_low(const NumberSet& taken,
                                                   std::span<const SumRule> rules, Range range,
                                                   int words) {
  for (std::int64_t i = 0; i < words && i * kBlock < range.length(); ++i) {
    const auto found = in_block(Direction::up, taken, rules, range, i * kBlock);
    if (found) return found;
  }
  return std::nullopt;
}

std::optional<std::int64_t> NumberSearch::find(Direction direction, const NumberSet& taken,
                                               std::span<const SumRule> rules, Range range) {
  const std::int64_t length = range.length();
  const auto try_at = [&](std::int64_t offset) {
    return in_block(direction, taken, rules, range, offset);
  };
  for (std::int64_t offset = 0; offset < std::min(length, kNearBlocks * kBlock); offset += kBlock) {
    if (const auto found = try_at(offset)) return found;
  }
  if (length <= kNearBlocks * kBlock) return std::nullopt;
  for (std::int64_t stretch = 2 * kNearBlocks * kBlock;; stretch *= 2) {
    const auto reach = static_cast<std::uint64_t>(std::min(stretch, length));
    for (int probe = 0; probe < kProbes; ++probe) {
      if (const auto found = try_at(static_cast<std::int64_t>(random_.below64(reach))))
        return found;
    }
    if (stretch >= std::min(length, 2 * sure_length_)) break;
  }
  if (length < sure_length_) return std::nullopt;
  for (std::int64_t offset = 0; offset < length;
       offset += kBlock) {  // the counting argument's word
    if (const auto found = try_at(offset)) return found;
  }
  return std::nullopt;
}

}  // namespace ar3d::grid
