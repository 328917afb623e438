#pragma once

#include <omp.h>

namespace ar3d {

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
