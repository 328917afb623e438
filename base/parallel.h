#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <system_error>
#include <utility>

// The one place where work is shared among threads. They are started anew for every loop, which
// takes some ten microseconds each: threads of OpenMP's pool would begin sooner, but keep a core
// busy while they wait for the next region.
namespace ar3d {

/// Threads that work may be shared among: those of OpenMP (OMP_NUM_THREADS), but 1 in a thread of
/// in_threads() and inside a parallel region, where the others have other work. What is computed
/// never depends on the number.
std::uint32_t available_threads();

/// Threads that a loop over `items` small items is worth: 1 for fewer than 2^17, else
/// available_threads().
std::uint32_t threads_for(std::uint64_t items);

/// Calls work(0), ..., work(count - 1), each in a thread of its own, the first in the calling one.
/// After all have ended, the first exception that one of them threw is thrown again.
/// @param not_started  is called here for each thread that the system does not give; by default
/// its work is done here, after work(0).
void in_threads(
    std::uint32_t count, const std::function<void(std::uint32_t)>& work,
    const std::function<void(std::uint32_t, const std::system_error&)>& not_started = {});

/// Calls both, at the same time if threads_for(items) gives two.
template <class First, class Second>
void in_two_threads(std::uint64_t items, const First& first, const Second& second) {
  if (threads_for(items) > 1) {
    return in_threads(2, [&](std::uint32_t i) { i == 0 ? first() : second(); });
  }
  first();
  second();
}

/// Calls work(thread, i) for every i < size, thread from 0 to threads - 1: a thread that is free
/// takes the next `chunk` numbers. After an exception, which is thrown again at the end, no more
/// are taken.
template <class Work>
void for_each_in_threads(std::uint32_t threads, std::size_t size, const Work& work,
                         std::size_t chunk = 1) {
  if (threads <= 1) {
    for (std::size_t i = 0; i < size; ++i) work(std::uint32_t{0}, i);
    return;
  }
  std::atomic<std::size_t> next = 0;
  const auto take = [&](std::uint32_t thread) {
    for (std::size_t begin = next.fetch_add(chunk); begin < size; begin = next.fetch_add(chunk)) {
      try {
        for (std::size_t i = begin; i < std::min(size, begin + chunk); ++i) work(thread, i);
      } catch (...) {
        next = size;
        throw;
      }
    }
  };
  in_threads(static_cast<std::uint32_t>(std::min<std::size_t>(threads, (size + chunk - 1) / chunk)),
             take);
}

/// The numbers below a size in blocks that threads take one at a time.
class IndexRanges {
 public:
  explicit IndexRanges(std::size_t size) : size_(size) {}
  std::size_t count() const { return (size_ + kBlock - 1) / kBlock; }
  /// Begin and end of block i.
  std::pair<std::size_t, std::size_t> operator[](std::size_t i) const {
    return {i * kBlock, std::min(size_, (i + 1) * kBlock)};
  }

 private:
  static constexpr std::size_t kBlock = std::size_t{1} << 14;
  std::size_t size_;
};

/// Calls work(thread, begin, end) for ranges that cover 0 .. size - 1, in threads.
template <class Work>
void for_ranges_in_threads(std::uint32_t threads, std::size_t size, const Work& work) {
  const IndexRanges blocks(size);
  for_each_in_threads(threads, blocks.count(), [&](std::uint32_t thread, std::size_t i) {
    const auto [begin, end] = blocks[i];
    work(thread, begin, end);
  });
}

}  // namespace ar3d
