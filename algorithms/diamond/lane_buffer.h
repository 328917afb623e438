#pragma once

#include <algorithm>
#include <cstddef>
#include <list>
#include <mutex>
#include <span>

#include "ar3d/base/threads.h"

namespace ar3d::diamond {

/// Memory for the lanes of all threads, in few long arrays.
template <class T>
class LaneBlocks {
 public:
  /// A lane takes at least so many elements: an odd number of cache lines, since lanes that write
  /// at the same time shall not meet in one set of the cache.
  static constexpr std::size_t kBlock = (std::size_t{1} << 12) + 320 / sizeof(T);

  /// @param kept  elements that the lanes will keep together.
  LaneBlocks(std::size_t kept, std::size_t lanes) : expected_(kept + lanes * kBlock) {}

  std::span<T> take(std::size_t count) {
    const std::scoped_lock lock(mutex_);
    if (arrays_.empty() || arrays_.back().size() - taken_ < count) {
      arrays_.emplace_back(std::max(count, arrays_.empty() ? expected_ : expected_ / 8));
      taken_ = 0;
    }
    taken_ += count;
    return {arrays_.back().data() + taken_ - count, count};
  }

 private:
  std::mutex mutex_;
  std::list<UnwrittenVector<T>> arrays_;
  std::size_t taken_ = 0;  ///< of the last one
  std::size_t expected_;
};

/// What the stretches of one lane keep, one stretch after the other. A stretch stands in one piece
/// and stays where it is when the next one has begun.
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
  /// What the stretch has so far moves to a new block.
  [[gnu::noinline]] void make_room() {
    const std::size_t kept = size();
    const std::span<T> block = blocks_->take(std::max(LaneBlocks<T>::kBlock, 2 * kept));
    std::copy(begin_, next_, block.begin());
    begin_ = block.data();
    next_ = begin_ + kept;
    end_ = begin_ + block.size();
  }

  LaneBlocks<T>* blocks_;
  T* begin_ = nullptr;
  T* next_ = nullptr;
  T* end_ = nullptr;
};

}  // namespace ar3d::diamond
