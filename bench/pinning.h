#pragma once

#include <sched.h>

#include <vector>

namespace ar3d {

/// Numbers of the cores that the calling thread may run on, increasing.
std::vector<int> allowed_cores();

/// Keeps the calling thread on one core for its lifetime. @throws InputError if the system refuses.
class Pinning {
 public:
  /// core < 0: no pinning.
  explicit Pinning(int core);
  ~Pinning();
  Pinning(const Pinning&) = delete;
  Pinning& operator=(const Pinning&) = delete;

 private:
  bool pinned_ = false;
  cpu_set_t before_{};
};

}  // namespace ar3d
