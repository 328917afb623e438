#pragma once

#include <algorithm>
#include <cstddef>
#include <list>
#include <utility>

#include "ar3d/model/threads.h"

namespace ar3d::diamond {

/// What the stretches of one lane keep, one stretch after the other. A stretch stands in one piece
/// and stays where it is when the next one has begun.
template <class T>
class LaneBuffer {
 public:
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
  static constexpr std::size_t kBlock = std::size_t{1} << 14;

  /// What the stretch has so far moves to a new block.
  [[gnu::noinline]] void make_room() {
    const std::size_t kept = size();
    UnwrittenVector<T> block(std::max(kBlock, 2 * kept));
    std::copy(begin_, next_, block.data());
    begin_ = block.data();
    next_ = begin_ + kept;
    end_ = begin_ + block.size();
    blocks_.push_back(std::move(block));
  }

  T* begin_ = nullptr;
  T* next_ = nullptr;
  T* end_ = nullptr;
  std::list<UnwrittenVector<T>> blocks_;
};

}  // namespace ar3d::diamond
