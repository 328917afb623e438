#pragma once

#include <omp.h>
#include <sched.h>

#include <vector>

#include "ar3d/base/error.h"

namespace ar3d {

/// Returns the numbers of the cores that the calling thread may run on, increasing.
std::vector<int> allowed_cores();

/// Keeps the calling thread on one core for its lifetime. @throws InputError if the system refuses.
class Pinning {
 public:
  /// Pins to that core; core < 0: no pinning.
  explicit Pinning(int core);
  ~Pinning();
  Pinning(const Pinning&) = delete;
  Pinning& operator=(const Pinning&) = delete;

 private:
  bool pinned_ = false;
  cpu_set_t before_{};
};

/// While it lives, OpenMP's regions in this thread have no other: a row has one thread, which also
/// generates its graph.
class OneThread {
 public:
  OneThread() { omp_set_num_threads(1); }
  ~OneThread() { omp_set_num_threads(before_); }
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

 private:
  int before_ = omp_get_max_threads();
};

}  // namespace ar3d
