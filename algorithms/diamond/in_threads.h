#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <future>
#include <system_error>
#include <vector>

#include "ar3d/base/threads.h"

namespace ar3d::diamond {

/// Calls work(0), ..., work(count - 1), each in a thread of its own, or here if the system gives
/// none. What one of them throws is thrown again here, after all have ended.
template <class Work>
void in_threads(std::uint32_t count, const Work& work) {
  std::vector<std::future<void>> others;
  std::vector<std::uint32_t> here = {0};
  for (std::uint32_t i = 1; i < count; ++i) {
    try {
      others.push_back(std::async(std::launch::async, [&work, i] { work(i); }));
    } catch (const std::system_error&) {
      here.push_back(i);
    }
  }
  for (const std::uint32_t i : here) work(i);
  for (std::future<void>& other : others) other.get();
}

/// Calls both, at the same time if threads_for(items) gives two.
template <class First, class Second>
void in_two_threads(std::uint64_t items, const First& first, const Second& second) {
  if (threads_for(items) == 1) {
    first();
    second();
    return;
  }
  in_threads(2, [&](std::uint32_t i) { i == 0 ? first() : second(); });
}

/// Calls work(i) for i < size, in threads that take `chunk` at a time.
template <class Work>
void for_each_in_threads(std::uint32_t threads, std::size_t size, std::size_t chunk,
                         const Work& work) {
  std::atomic<std::size_t> next{0};
  in_threads(threads, [&](std::uint32_t) {
    for (std::size_t begin = next.fetch_add(chunk); begin < size; begin = next.fetch_add(chunk)) {
      for (std::size_t i = begin; i < size && i < begin + chunk; ++i) work(i);
    }
  });
}

/// Calls work(begin, end) for ranges that cover 0 .. size - 1, in threads.
template <class Work>
void for_ranges_in_threads(std::uint32_t threads, std::size_t size, const Work& work) {
  constexpr std::size_t kRange = 1 << 14;
  for_each_in_threads(threads, (size + kRange - 1) / kRange, 1,
                      [&](std::size_t i) { work(i * kRange, std::min(size, (i + 1) * kRange)); });
}

}  // namespace ar3d::diamond
