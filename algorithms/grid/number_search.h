#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "ar3d/algorithms/grid/number_set.h"
#include "ar3d/base/random.h"

namespace ar3d::grid {

/// What (I1) and (I2) ask of one vertex whose plane numbers but one are known: with the last number
/// x, its sum S = known + x is new and differs by at least 2 from the sums of the vertices joined
/// to it by U-edges.
struct SumRule {
  std::int64_t known = 0;
  std::array<std::int64_t, 3> joined{};
  unsigned num_joined = 0;
  bool is_new = true;  ///< false: only the distances count

  void join(std::int64_t sum) { joined[num_joined++] = sum; }
};

/// A closed range of integers.
struct Range {
  std::int64_t low = 0;
  std::int64_t high = -1;
  bool empty() const { return high < low; }
  std::int64_t length() const { return high - low + 1; }
};

enum class Direction { up, down };

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
  std::optional<std::int64_t> find(Direction direction, const NumberSet& taken,
                                   std::span<const SumRule> rules, Range range);

  /// Looks at `words` blocks of 64 from the low end only.
  std::optional<std::int64_t> near_low(const NumberSet& taken, std::span<const SumRule> rules,
                                       Range range, int words);

  /// Blocks of 64 numbers looked at so far.
  std::int64_t blocks() const { return blocks_; }

  /// Whether one number obeys one rule.
  bool obeys(std::int64_t x, const SumRule& rule) const;

 private:
  /// Bit j: x + j is suitable.
  std::uint64_t block(std::int64_t x, const NumberSet& taken, std::span<const SumRule> rules);
  std::optional<std::int64_t> in_block(Direction direction, const NumberSet& taken,
                                       std::span<const SumRule> rules, Range range,
                                       std::int64_t offset);

  const NumberSet& sums_;
  RandomStream& random_;
  std::int64_t sure_length_;
  std::int64_t blocks_ = 0;
};

}  // namespace ar3d::grid
