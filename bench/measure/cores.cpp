// Keeps a thread on a core. Timed rows need that, because a thread that moves loses its caches.
#include "ar3d/bench/measure/cores.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>

namespace ar3d {
std::vector<int> allowed_cores() {
  std::vector<int> cores;
  cpu_set_t set;
  CPU_ZERO(&set);
  if (sched_getaffinity(0, sizeof(set), &set) != 0) return cores;
  for (int core = 0; core < CPU_SETSIZE; ++core) {
    if (CPU_ISSET(core, &set)) cores.push_back(core);
  }
  return cores;
}

Pinning::Pinning(int core) {
  if (core < 0) return;
  CPU_ZERO(&before_);
  cpu_set_t only;
  CPU_ZERO(&only);
  CPU_SET(core, &only);
  if (sched_getaffinity(0, sizeof(before_), &before_) != 0 ||
      sched_setaffinity(0, sizeof(only), &only) != 0) {
    throw InputError(fmt::format("cannot pin to core {}: {}", core, std::strerror(errno)));
  }
  pinned_ = true;
}

Pinning::~Pinning() {
  if (pinned_) sched_setaffinity(0, sizeof(before_), &before_);
}

}  // namespace ar3d
