#include "ar3d/base/parallel.h"

#include <omp.h>

#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace ar3d {
namespace {
thread_local bool is_one_of_several = false;
}

std::uint32_t available_threads() {
  if (is_one_of_several || omp_in_parallel()) return 1;
  return static_cast<std::uint32_t>(omp_get_max_threads());
}

std::uint32_t threads_for(std::uint64_t items) {
  constexpr std::uint64_t kFew = std::uint64_t{1} << 17;
  return items < kFew ? 1 : available_threads();
}

void in_threads(std::uint32_t count, const std::function<void(std::uint32_t)>& work,
                const std::function<void(std::uint32_t, const std::system_error&)>& not_started) {
  if (count == 0) return;
  if (count == 1) return work(0);
  std::mutex mutex;
  std::exception_ptr failure;
  const auto guarded = [&](std::uint32_t i) {
    const bool before = std::exchange(is_one_of_several, true);
    try {
      work(i);
    } catch (...) {  // nothing may leave a thread
      const std::lock_guard<std::mutex> lock(mutex);
      if (!failure) failure = std::current_exception();
    }
    is_one_of_several = before;
  };
  std::vector<std::uint32_t> here = {0};
  std::vector<std::jthread> others;  // joined, too, if not_started throws
  others.reserve(count - 1);
  for (std::uint32_t i = 1; i < count; ++i) {
    try {
      others.emplace_back(guarded, i);
    } catch (const std::system_error& reason) {
      not_started ? not_started(i, reason) : here.push_back(i);
    }
  }
  for (const std::uint32_t i : here) guarded(i);
  for (std::jthread& other : others) other.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace ar3d
