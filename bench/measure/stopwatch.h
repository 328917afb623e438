#pragma once

#include <chrono>
#include <ctime>

namespace ar3d {

/// Wall time since construction.
class Stopwatch {
 public:
  double wall_s() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// CPU time of the calling thread since construction. Reading it is a system call.
class CpuStopwatch {
 public:
  double cpu_s() const { return thread_cpu_s() - start_; }

 private:
  static double thread_cpu_s() {
    std::timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  }

  double start_ = thread_cpu_s();
};

}  // namespace ar3d
