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

constexpr std::uint64_t kFull = ~std::uint64_t{0};

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

std::optional<std::int64_t> NumberSearch::in_block(bool up, const NumberSet& taken,
                                                   std::span<const SumRule> rules,
                                                   NumberRange range, std::int64_t offset) {
  if (up) {
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
                                                   std::span<const SumRule> rules,
                                                   NumberRange range, int words) {
  for (std::int64_t i = 0; i < words && i * kBlock < range.length(); ++i) {
    const auto found = in_block(true, taken, rules, range, i * kBlock);
    if (found) return found;
  }
  return std::nullopt;
}

std::optional<std::int64_t> NumberSearch::find(bool up, const NumberSet& taken,
                                               std::span<const SumRule> rules, NumberRange range) {
  const std::int64_t length = range.length();
  const auto try_at = [&](std::int64_t offset) {
    return in_block(up, taken, rules, range, offset);
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

// A set of integers with "next number not in it", which Lemma 3.4 says is near, as a tree of bit
// words with 64 children per node (van Emde Boas's idea with a fixed fan-out). Numbers are dense
// near 0, so a bit vector is smaller and faster than a hash table or a balanced tree. Cost: one
// word per level, up and down again: O(log n) to the base 64.

NumberSet::NumberSet(std::int64_t radius) {
  const auto half = static_cast<std::int64_t>(
      std::bit_ceil(static_cast<std::uint64_t>(std::max<std::int64_t>(radius, 64)) / 64 + 1));
  low_ = -half * 64;
  levels_.emplace_back(static_cast<std::size_t>(2 * half), 0);
  build_upper_levels();
}

bool NumberSet::insert(std::int64_t x) {
  if (x < low_ || x >= low_ + size()) grow_to(x);
  std::size_t i = static_cast<std::size_t>(x - low_);
  if (((levels_[0][i >> 6] >> (i & 63)) & 1) != 0) return false;
  for (auto& level : levels_) {
    std::uint64_t& word = level[i >> 6];
    word |= std::uint64_t{1} << (i & 63);
    if (word != kFull) break;
    i >>= 6;
  }
  return true;
}

NumberSet NumberSet::pairs() const {
  NumberSet pairs = *this;
  const std::vector<std::uint64_t>& words = levels_[0];
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::uint64_t above = i + 1 < words.size() ? words[i + 1] : 0;
    pairs.levels_[0][i] |= (words[i] >> 1) | (above << 63);
  }
  pairs.build_upper_levels();
  if (contains(low_)) pairs.insert(low_ - 1);
  return pairs;
}

std::uint64_t NumberSet::window_at_border(std::int64_t x) const {
  std::uint64_t bits = 0;
  for (int j = 0; j < 64; ++j) bits |= static_cast<std::uint64_t>(contains(x + j)) << j;
  return bits;
}

std::int64_t NumberSet::next_outside(std::int64_t x) const {
  if (x < low_ || x >= low_ + size()) return x;
  std::size_t i = static_cast<std::size_t>(x - low_);
  std::size_t level = 0;
  while (true) {  // up, until some word has a gap at or after bit i
    if (level == levels_.size() || (i >> 6) >= levels_[level].size()) return low_ + size();
    const std::uint64_t gaps = ~levels_[level][i >> 6] & (kFull << (i & 63));
    if (gaps != 0) {
      i = (i & ~std::size_t{63}) + static_cast<std::size_t>(std::countr_zero(gaps));
      break;
    }
    i = (i >> 6) + 1;
    ++level;
  }
  while (level > 0) {  // down to that gap's first number
    --level;
    if (i >= levels_[level].size()) return low_ + size();
    i = i * 64 + static_cast<std::size_t>(std::countr_one(levels_[level][i]));
  }
  return low_ + static_cast<std::int64_t>(i);
}

std::int64_t NumberSet::previous_outside(std::int64_t x) const {
  if (x < low_ || x >= low_ + size()) return x;
  std::size_t i = static_cast<std::size_t>(x - low_);
  std::size_t level = 0;
  while (true) {  // up, until some word has a gap at or before bit i
    const std::uint64_t gaps = ~levels_[level][i >> 6] & (kFull >> (63 - (i & 63)));
    if (gaps != 0) {
      i = (i | 63) - static_cast<std::size_t>(std::countl_zero(gaps));
      break;
    }
    if ((i >> 6) == 0) return low_ - 1;
    i = (i >> 6) - 1;
    ++level;
  }
  while (level > 0) {
    --level;
    i = i * 64 + 63 - static_cast<std::size_t>(std::countl_one(levels_[level][i]));
  }
  return low_ + static_cast<std::int64_t>(i);
}

void NumberSet::grow_to(std::int64_t x) {
  std::int64_t words = static_cast<std::int64_t>(levels_[0].size());
  while (x < -words * 32 || x >= words * 32) words *= 2;
  const std::size_t shift = (static_cast<std::size_t>(words) - levels_[0].size()) / 2;
  std::vector<std::uint64_t> wider(static_cast<std::size_t>(words), 0);
  std::copy(levels_[0].begin(), levels_[0].end(),
            wider.begin() + static_cast<std::ptrdiff_t>(shift));
  low_ = -words * 32;
  levels_[0] = std::move(wider);
  build_upper_levels();
}

void NumberSet::build_upper_levels() {
  levels_.resize(1);
  while (levels_.back().size() > 1) {
    const std::vector<std::uint64_t>& below = levels_.back();
    std::vector<std::uint64_t> above((below.size() + 63) / 64, 0);
    for (std::size_t i = 0; i < below.size(); ++i) {
      if (below[i] == kFull) above[i >> 6] |= std::uint64_t{1} << (i & 63);
    }
    levels_.push_back(std::move(above));
  }
}

}  // namespace ar3d::grid
