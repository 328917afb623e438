#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>

// The one place where work is shared among threads, which are OpenMP's (base/README.md).
namespace ar3d {

/// Returns threads that work may be shared among: OpenMP's (OMP_NUM_THREADS, OMP_THREAD_LIMIT); 1
/// inside a parallel region, where the others have other work, unless OMP_MAX_ACTIVE_LEVELS allows
/// more. What is computed never depends on the number.
std::uint32_t available_threads();

/// Returns threads that a loop over `items` small items is worth: 1 for fewer than 2^17.
inline std::uint32_t threads_for(std::uint64_t items) {
  return items >> 17 == 0 ? 1 : available_threads();
}

/// Calls work(0), ..., work(count - 1) at the same time, each in a thread of its own, then throws
/// the first exception of one. @throws InputError before any call if there are fewer threads.
void in_threads(std::uint32_t count, const std::function<void(std::uint32_t)>& work);

/// Calls work(thread, i) for every i < size, thread from 0 to threads - 1: a thread that is free
/// takes the next `chunk` numbers; if the system gives fewer threads, they take all. After an
/// exception, which is thrown again at the end, no more are taken.
void for_each_in_threads(std::uint32_t threads, std::size_t size,
                         const std::function<void(std::uint32_t, std::size_t)>& work,
                         std::size_t chunk = 1);

/// Represents the numbers below a size in blocks that threads take one at a time.
class IndexRanges {
 public:
  explicit IndexRanges(std::size_t size) : size_(size) {}
  std::size_t count() const { return (size_ + kBlock - 1) / kBlock; }
  /// Returns the begin and end of block i.
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
