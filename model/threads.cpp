#include "ar3d/model/threads.h"

#include <omp.h>

namespace ar3d {

int threads_for(std::uint64_t items) {
  constexpr std::uint64_t kFew = std::uint64_t{1} << 17;
  return items < kFew || omp_in_parallel() ? 1 : omp_get_max_threads();
}

}  // namespace ar3d
