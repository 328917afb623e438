#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ar3d/bench/measure/instruments.h"

namespace ar3d {

/// Fixed work whose time tells how fast the machine is at the moment (kYardsticks). Whoever asks
/// for them before every row spends at most 3 % of the time on them. Memory: 3 MB. Construct and
/// use it in one thread.
class Yardsticks {
 public:
  Yardsticks();
  /// CPU times in seconds. Measured anew if the thread has computed long enough since the last
  /// time, else those of then: the two short ones (25 us each) every 3 ms, that of memory (2 ms)
  /// every 200 ms.
  const std::array<double, 3>& now_s();

 private:
  using Heads = std::vector<std::uint32_t>;  ///< three for every vertex, where its edges lead

  Heads cached_;  ///< of a random graph of 2^10 vertices: 12 KB
  Heads memory_;  ///< of 2^17: 1.5 MB
  std::vector<std::uint32_t> queue_;
  std::vector<bool> seen_;
  std::array<double, 3> last_s_{};
  CpuStopwatch clock_;
  double next_short_s_ = 0, next_memory_s_ = 0;  ///< on `clock_`

  void search(const Heads& heads);
};

}  // namespace ar3d
