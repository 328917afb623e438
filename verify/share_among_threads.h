#pragma once

#include <omp.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <utility>

namespace ar3d::verify {

/// The numbers below a size in blocks that threads take one at a time.
class Blocks {
 public:
  explicit Blocks(std::uint64_t size) : size_(size) {}
  std::uint64_t count() const { return (size_ + kBlock - 1) / kBlock; }
  /// Begin and end of block i.
  std::pair<std::uint32_t, std::uint32_t> operator[](std::uint64_t i) const {
    return {static_cast<std::uint32_t>(i * kBlock),
            static_cast<std::uint32_t>(std::min(size_, (i + 1) * kBlock))};
  }

 private:
  static constexpr std::uint64_t kBlock = 1 << 14;
  std::uint64_t size_;
};

/// Calls work(thread, i) for every i below `count`, thread from 0 to threads - 1: threads that are
/// free take the next number. The first exception is thrown again at the end.
template <class Work>
void share_among_threads(int threads, std::uint64_t count, Work&& work) {
  if (threads <= 1) {
    for (std::uint64_t i = 0; i < count; ++i) work(0, i);
    return;
  }
  std::exception_ptr failure;
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
  for (std::uint64_t i = 0; i < count; ++i) {
    try {
      work(omp_get_thread_num(), i);
    } catch (...) {
#pragma omp critical(ar3d_share_among_threads)
      if (!failure) failure = std::current_exception();
    }
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace ar3d::verify
