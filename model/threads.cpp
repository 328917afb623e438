#include "ar3d/model/threads.h"

#include <omp.h>
#include <sys/mman.h>

#include <cstdint>
#include <cstdlib>
#include <new>

#include "ar3d/model/long_vector.h"

namespace ar3d {
namespace {
constexpr std::size_t kPage = std::size_t{1} << 21;
}

int threads_for(std::uint64_t items) {
  constexpr std::uint64_t kFew = std::uint64_t{1} << 17;
  return items < kFew || omp_in_parallel() ? 1 : omp_get_max_threads();
}

void advise_long_array(void* array, std::size_t bytes) {
  if (bytes < kLongArrayBytes) return;
  // Whole pages inside the array only; the advice takes addresses that are multiples of 4 KiB.
  const auto begin = (reinterpret_cast<std::uintptr_t>(array) + kPage - 1) / kPage * kPage;
  const auto end = (reinterpret_cast<std::uintptr_t>(array) + bytes) / kPage * kPage;
  // NOLINTNEXTLINE(performance-no-int-to-ptr): rounded up to a page
  if (begin < end) madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
}

void* allocate_long_array(std::size_t bytes) {
  void* const array = std::aligned_alloc(kPage, (bytes + kPage - 1) / kPage * kPage);
  if (array == nullptr) throw std::bad_alloc();
  advise_long_array(array, bytes);  // not for the last page, which costs no more than it holds
  return array;
}

void free_long_array(void* array) noexcept { std::free(array); }

}  // namespace ar3d
