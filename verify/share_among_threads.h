#pragma once

#include <omp.h>

#include <cstdint>
#include <exception>

namespace ar3d::verify {

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
