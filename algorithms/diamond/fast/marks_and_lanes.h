#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <list>
#include <mutex>
#include <vector>

#include "ar3d/algorithms/diamond/fast/fast.h"
#include "ar3d/base/long_vector.h"

namespace ar3d::diamond::fast {

/// The fastest sizes for n vertices: within the caches, few lanes are enough, and their last
/// stretches, which run in few lanes, should be short.
inline WalkSizes walk_sizes(std::uint64_t n, std::uint32_t threads = 1) {
  constexpr std::uint64_t kInCaches = std::uint64_t{1} << 19;
  return n < kInCaches ? WalkSizes{.stride = 256, .lanes = 16, .threads = threads}
                       : WalkSizes{.threads = threads};
}

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

/// Memory for the lanes of all threads, in few long arrays.
template <class T>
class LaneBlocks {
 public:
  /// A lane takes at least so many values: an odd number of cache lines, since lanes that write at
  /// the same time shall not meet in one set of the cache.
  static constexpr std::size_t kBlock = (std::size_t{1} << 12) + 320 / sizeof(T);

  /// @param kept  values that the lanes will keep together.
  LaneBlocks(std::size_t kept, std::size_t lanes) : expected_(kept + lanes * kBlock) {}

  T* take(std::size_t count) {
    const std::scoped_lock lock(mutex_);
    if (arrays_.empty() || arrays_.back().size() - taken_ < count) {
      arrays_.emplace_back(std::max(count, arrays_.empty() ? expected_ : expected_ / 8));
      taken_ = 0;
    }
    taken_ += count;
    return arrays_.back().data() + taken_ - count;
  }

 private:
  std::mutex mutex_;
  std::list<UnwrittenVector<T>> arrays_;
  std::size_t taken_ = 0;  ///< of the last one
  std::size_t expected_;
};

/// Holds what the stretches of a lane keep, each in one piece that stays where it is.
template <class T>
class LaneBuffer {
 public:
  explicit LaneBuffer(LaneBlocks<T>& blocks) : blocks_(&blocks) {}
  /// Begins a stretch behind the last one.
  void begin() { begin_ = next_; }
  /// Forgets what the stretch has kept.
  void drop() { next_ = begin_; }
  /// Writes the value, and keeps it if `kept` is 1, not 0.
  void put(T value, std::size_t kept = 1) {
    if (next_ == end_) make_room();
    *next_ = value;
    next_ += kept;
  }
  const T* data() const { return begin_; }
  std::size_t size() const { return static_cast<std::size_t>(next_ - begin_); }

 private:
  [[gnu::noinline]] void make_room() {
    const std::size_t kept = size(), room = std::max(LaneBlocks<T>::kBlock, 2 * kept);
    T* const block = blocks_->take(room);
    next_ = std::copy(begin_, next_, block);
    begin_ = block;
    end_ = block + room;
  }

  LaneBlocks<T>* blocks_;
  T* begin_ = nullptr;
  T* next_ = nullptr;
  T* end_ = nullptr;
};

/// Walks many stretches of chains in turns.
/// @param walk  start(lane) begins the next stretch in a lane, false if there is none left;
///              advance(lane) makes a step, false if the stretch ends with it.
template <class Walk>
void walk_in_lanes(Walk& walk, std::uint32_t lanes) {
  std::vector<std::uint32_t> running;
  for (std::uint32_t lane = 0; lane < lanes && walk.start(lane); ++lane) running.push_back(lane);
  while (!running.empty()) {
    for (std::size_t i = 0; i < running.size();) {
      if (walk.advance(running[i]) || walk.start(running[i])) {
        ++i;
      } else {
        running[i] = running.back();
        running.pop_back();
      }
    }
  }
}

}  // namespace ar3d::diamond::fast
