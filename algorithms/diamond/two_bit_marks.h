#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ar3d::diamond {

/// For every number below `count` nothing, or one bit. Sixteen stand in a word, so the marks of
/// 10^6 vertices stay in a second-level cache while they are written in any order.
class TwoBitMarks {
 public:
  /// @param shared  several threads set marks at the same time.
  TwoBitMarks(std::size_t count, bool shared) : words_(count / 16 + 1, 0), shared_(shared) {}

  /// Marks `i`, which may be marked with the same bit already.
  void set(std::uint32_t i, std::uint32_t bit) {
    std::uint32_t& word = words_[i >> 4];
    const std::uint32_t mark = (2 | bit) << (i & 15) * 2;
    if (shared_) {
      std::atomic_ref<std::uint32_t>(word).fetch_or(mark, std::memory_order_relaxed);
    } else {
      word |= mark;
    }
  }
  /// Its bit; 0 if it is not marked.
  std::uint32_t bit(std::uint32_t i) const { return words_[i >> 4] >> (i & 15) * 2 & 1; }
  /// The bits of i, which is even, and of i + 1, in this order from the lowest bit on.
  std::uint32_t two_bits(std::uint32_t i) const {
    const std::uint32_t marks = words_[i >> 4] >> (i & 15) * 2;
    return (marks & 1) | (marks >> 1 & 2);
  }
  bool has(std::uint32_t i) const { return (load(i >> 4) >> (i & 15) * 2 & 2) != 0; }
  /// The first number from `i` on that is not marked, at most `end`; also while others set marks.
  std::uint32_t first_unmarked(std::uint32_t i, std::uint32_t end) const {
    constexpr std::uint32_t kAll = 0xAAAAAAAA;
    while (i < end) {
      if ((i & 15) == 0 && (load(i >> 4) & kAll) == kAll) {
        i += 16;
      } else if (has(i)) {
        ++i;
      } else {
        return i;
      }
    }
    return end;
  }

 private:
  std::uint32_t load(std::uint32_t word) const {
    // const_cast: C++20 has no atomic_ref to const
    auto& shared = const_cast<std::uint32_t&>(words_[word]);
    return std::atomic_ref<std::uint32_t>(shared).load(std::memory_order_relaxed);
  }

  std::vector<std::uint32_t> words_;
  bool shared_;
};

}  // namespace ar3d::diamond
