#pragma once

#include <algorithm>
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

inline constexpr std::size_t kIndexBlock = std::size_t{1} << 14;
/// Returns in how many blocks threads take the numbers below a size, and begin and end of block i.
inline std::size_t blocks_below(std::size_t size) { return (size + kIndexBlock - 1) / kIndexBlock; }
inline std::pair<std::size_t, std::size_t> block_below(std::size_t size, std::size_t i) {
  return {i * kIndexBlock, std::min(size, (i + 1) * kIndexBlock)};
}

/// Calls work(thread, begin, end) for ranges that cover 0 .. size - 1, in threads.
template <class Work>
void for_ranges_in_threads(std::uint32_t threads, std::size_t size, const Work& work) {
  for_each_in_threads(threads, blocks_below(size), [&](std::uint32_t thread, std::size_t i) {
    const auto [begin, end] = block_below(size, i);
    work(thread, begin, end);
  });
}

}  // namespace ar3d
