#pragma once

#include <chrono>
#include <ctime>

namespace ar3d {

/// Wall time, and CPU time of the calling thread, since construction.
class Stopwatch {
 public:
  double wall_s() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_).count();
  }
  double cpu_s() const { return thread_cpu_s() - cpu_; }

 private:
  static double thread_cpu_s() {
    std::timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  }

  double cpu_ = thread_cpu_s();
  std::chrono::steady_clock::time_point wall_ = std::chrono::steady_clock::now();
};

}  // namespace ar3d
