// A set of integers with "next number not in it", which Lemma 3.4 says is near, as a tree of bit
// words with 64 children per node (van Emde Boas's idea with a fixed fan-out). Numbers are dense
// near 0, so a bit vector is smaller and faster than a hash table or a balanced tree. Cost: one
// word per level, up and down again: O(log n) to the base 64.
#include "ar3d/algorithms/grid/number_set.h"

#include <algorithm>

namespace ar3d::grid {
namespace {

constexpr std::uint64_t kFull = ~std::uint64_t{0};

}  // namespace

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
