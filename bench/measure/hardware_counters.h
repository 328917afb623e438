#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace ar3d {

/// What the processor counted in user space of the calling thread; -1: the kernel does not tell.
struct CountedEvents {
  std::int64_t instructions = -1;
  std::int64_t cycles = -1;
  std::int64_t cache_misses = -1;
};

/// The hardware counters of one thread (Linux perf_event_open). Construct and use it in that
/// thread.
class HardwareCounters {
 public:
  HardwareCounters();
  ~HardwareCounters();
  HardwareCounters(const HardwareCounters&) = delete;
  HardwareCounters& operator=(const HardwareCounters&) = delete;

  void start();
  /// Events since start(). A hardware counter that had to share the processor with others is not
  /// told.
  CountedEvents stop();

  /// "available", or "absent: <why>" naming the first hardware counter that cannot be had.
  const std::string& availability() const { return availability_; }

 private:
  static constexpr std::size_t kCounters = 3;
  std::array<int, kCounters> descriptors_{-1, -1, -1};
  std::string availability_ = "available";
};

}  // namespace ar3d
