#include "ar3d/model/threads.h"

#include <omp.h>
#include <sys/mman.h>

#include <cstdlib>
#include <new>

namespace ar3d {

int threads_for(std::uint64_t items) {
  constexpr std::uint64_t kFew = std::uint64_t{1} << 17;
  return items < kFew || omp_in_parallel() ? 1 : omp_get_max_threads();
}

void* allocate_long_array(std::size_t bytes) {
  constexpr std::size_t kPage = std::size_t{1} << 21;
  void* const array = std::aligned_alloc(kPage, (bytes + kPage - 1) / kPage * kPage);
  if (array == nullptr) throw std::bad_alloc();
  // Whole pages only, so that the last one costs no more than it holds. Advice: may be refused.
  madvise(array, bytes / kPage * kPage, MADV_HUGEPAGE);
  return array;
}

void free_long_array(void* array) noexcept { std::free(array); }

}  // namespace ar3d
