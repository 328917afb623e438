#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace ar3d::verify {

/// A segment of a known direction: from its low end, `steps` times along the direction.
struct PlacedSegment {
  std::int32_t x;
  std::int32_t y;
  std::int32_t z;
  std::int32_t steps;
};

/// The segments of one direction, in blocks that grow and are never copied; 16 bytes each.
class PlacedSegments {
 public:
  void add(PlacedSegment segment) {
    if (used_ == room_) grow();
    last_[used_++] = segment;
    ++size_;
  }
  std::size_t size() const { return size_; }

  /// Calls visit(part) for std::span<const PlacedSegment>s that make up all of them.
  template <class Visit>
  void for_each_part(Visit&& visit) const {
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      const std::size_t count = b + 1 == blocks_.size() ? used_ : room_of(b);
      visit(std::span<const PlacedSegment>(blocks_[b].get(), count));
    }
  }

 private:
  static std::size_t room_of(std::size_t block) {
    return std::size_t{256} << std::min<std::size_t>(block, 10);
  }
  void grow() {
    room_ = room_of(blocks_.size());
    used_ = 0;
    // Not value-initialised: every segment is written before it is read.
    blocks_.push_back(std::unique_ptr<PlacedSegment[]>(new PlacedSegment[room_]));
    last_ = blocks_.back().get();
  }

  std::vector<std::unique_ptr<PlacedSegment[]>> blocks_;
  PlacedSegment* last_ = nullptr;
  std::size_t used_ = 0;
  std::size_t room_ = 0;
  std::size_t size_ = 0;
};

}  // namespace ar3d::verify
