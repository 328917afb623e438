#pragma once

#include <cstdint>
#include <vector>

#include "ar3d/algorithms/diamond/colouring.h"

namespace ar3d::diamond {

/// Lists of numbers, one list a bucket; linear in all.
class Buckets {
 public:
  Buckets(std::size_t buckets, std::size_t entries)
      : head_(buckets, kNone), next_(entries, kNone) {}
  void add(std::uint32_t bucket, std::uint32_t entry) {
    next_[entry] = head_[bucket];
    head_[bucket] = entry;
  }
  template <class Visit>
  void for_each(std::uint32_t bucket, Visit visit) const {
    for (std::uint32_t entry = head_[bucket]; entry != kNone; entry = next_[entry]) visit(entry);
  }

 private:
  std::vector<std::uint32_t> head_;
  std::vector<std::uint32_t> next_;
};

}  // namespace ar3d::diamond
