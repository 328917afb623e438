#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ar3d/base/random.h"

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

/// Holds what (I1) and (I2) ask of one vertex whose plane numbers but one are known: with the last
/// number x, its sum S = known + x is new and differs by at least 2 from the sums of the vertices
/// joined to it by U-edges.
struct SumRule {
  std::int64_t known = 0;
  std::array<std::int64_t, 3> joined{};
  unsigned num_joined = 0;
  bool is_new = true;  ///< false: only the distances count

  void join(std::int64_t sum) { joined[num_joined++] = sum; }
};

/// A closed range of integers.
struct NumberRange {
  std::int64_t low = 0;
  std::int64_t high = -1;
  std::int64_t length() const { return high - low + 1; }
};

/// Finds numbers outside a set that obey sum rules, 64 candidates at a time.
/// A search looks at the nearest 2048 numbers and then at random blocks of ever longer stretches,
/// so it ends after O(log n) words expected, on every input, at most about twice as far away as
/// counting guarantees.
class NumberSearch {
 public:
  /// @param sums  the sums in use.
  /// @param sure_length  at most half of this many consecutive numbers can be unsuitable in any
  /// search.
  NumberSearch(const NumberSet& sums, RandomStream& random, std::int64_t sure_length)
      : sums_(sums), random_(random), sure_length_(sure_length) {}

  /// A suitable number of `range`, preferably near its low end (up) or its high end (down).
  /// Always found if range.length() >= sure_length.
  std::optional<std::int64_t> find_up(const NumberSet& taken, std::span<const SumRule> rules,
                                      NumberRange range) {
    return find(true, taken, rules, range);
  }
  std::optional<std::int64_t> find_down(const NumberSet& taken, std::span<const SumRule> rules,
                                        NumberRange range) {
    return find(false, taken, rules, range);
  }

  /// Looks at `words` blocks of 64 from the low end only.
  std::optional<std::int64_t> near_low(const NumberSet& taken, std::span<const SumRule> rules,
                                       NumberRange range, int words);

  /// Blocks of 64 numbers looked at so far.
  std::int64_t blocks() const { return blocks_; }

  /// Returns whether one number obeys one rule.
  bool obeys(std::int64_t x, const SumRule& rule) const;

 private:
  /// Bit j: x + j is suitable.
  std::uint64_t block(std::int64_t x, const NumberSet& taken, std::span<const SumRule> rules);
  std::optional<std::int64_t> find(bool up, const NumberSet& taken, std::span<const SumRule> rules,
                                   NumberRange range);
  std::optional<std::int64_t> in_block(bool up, const NumberSet& taken,
                                       std::span<const SumRule> rules, NumberRange range,
                                       std::int64_t offset);

  const NumberSet& sums_;
  RandomStream& random_;
  std::int64_t sure_length_;
  std::int64_t blocks_ = 0;
};

}  // namespace ar3d::grid
