#pragma once

#include <bit>
#include <cstdint>
#include <vector>

namespace ar3d::grid {

/// A set of integers of either sign that only grows, with "next number not in the set" in both
/// directions: a tree of bit words with 64 children per node, so a question reads at most one word
/// per level on the way up and one on the way down. Memory: about 1.02 bits per number of the
/// covered range, which doubles when an insertion leaves it.
class NumberSet {
 public:
  /// Covers about [-radius, radius] from the start.
  explicit NumberSet(std::int64_t radius);

  bool contains(std::int64_t x) const {
    const std::int64_t i = x - low_;
    return i >= 0 && i < size() && ((levels_[0][word_of(i)] >> (i & 63)) & 1) != 0;
  }
  /// @return false if x was in the set before.
  bool insert(std::int64_t x);

  /// Bit j is set iff x + j is in the set, j = 0..63.
  std::uint64_t window(std::int64_t x) const {
    const std::int64_t i = x - low_;
    if (i < 0 || i + 64 >= size()) return window_at_border(x);
    const std::size_t word = word_of(i);
    const unsigned shift = static_cast<unsigned>(i & 63);
    if (shift == 0) return levels_[0][word];
    return (levels_[0][word] >> shift) | (levels_[0][word + 1] << (64 - shift));
  }

  /// The numbers x with x or x + 1 in the set. Cost: O(covered range / 64).
  NumberSet pairs() const;

  /// Smallest number >= x outside the set, and largest number <= x outside the set.
  std::int64_t next_outside(std::int64_t x) const;
  std::int64_t previous_outside(std::int64_t x) const;

 private:
  static std::size_t word_of(std::int64_t i) { return static_cast<std::size_t>(i) >> 6; }
  std::int64_t size() const { return static_cast<std::int64_t>(levels_[0].size()) * 64; }
  std::uint64_t window_at_border(std::int64_t x) const;
  void grow_to(std::int64_t x);
  void build_upper_levels();

  std::int64_t low_ = 0;  // the number of bit 0
  /// levels_[0] holds the set; bit i of levels_[k + 1] says that word i of levels_[k] is full.
  std::vector<std::vector<std::uint64_t>> levels_;
};

}  // namespace ar3d::grid
