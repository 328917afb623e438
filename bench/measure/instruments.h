#pragma once

#include <array>
#include <cstdint>
#include <ctime>
#include <string>
#include <vector>

#include "ar3d/base/new_file.h"

namespace ar3d {

/// Names the clock of the calling thread's CPU time. Reading it is a system call.
inline constexpr clockid_t kCpuTime = CLOCK_THREAD_CPUTIME_ID;

/// Measures time since construction: wall time, or that of another clock.
class Stopwatch {
 public:
  explicit Stopwatch(clockid_t clock = CLOCK_MONOTONIC) : clock_(clock) {}
  double seconds() const { return now_s() - start_s_; }

 private:
  double now_s() const {
    std::timespec now{};
    clock_gettime(clock_, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  }

  clockid_t clock_;
  double start_s_ = now_s();
};

/// Represents the hardware counters of one thread (Linux perf_event_open). Construct and use it in
/// that thread.
class HardwareCounters {
 public:
  HardwareCounters();

  void start();
  /// Returns instructions, cycles and cache misses since start(), in user space of the thread. -1:
  /// the kernel does not tell, or the hardware counter had to share the processor with others.
  std::array<std::int64_t, 3> stop();

  /// Returns "available", or "absent: <why>" naming the first hardware counter that cannot be had.
  const std::string& availability() const { return availability_; }

 private:
  std::array<Descriptor, 3> counters_;
  std::string availability_ = "available";
};

/// Says how much memory of the process the peak of a row stands for.
enum class MemoryScope {
  process,  ///< other rows are made at the same time: only the process's peak so far is known
  row,      ///< this row's own: the kernel's high-water mark is reset before it
  worker    ///< as row, in a process that does nothing else
};
const char* to_string(MemoryScope scope);

/// Measures the resident memory of a row. The kernel keeps a high-water mark for the process; where
/// no other row is made beside, it is reset at will (Linux: "5" written to /proc/self/clear_refs),
/// so that it speaks of what came after. Where the kernel refuses that, the scope is `process`.
/// Cost of a call: about 1 us.
class RowMemory {
 public:
  /// Construct it in the process that makes the rows.
  explicit RowMemory(MemoryScope scope);

  MemoryScope scope() const { return scope_; }

  /// Begins a row: gives what earlier rows have freed back to the system (if it is much), resets
  /// the mark. @return resident bytes now; -1 in scope process.
  std::int64_t begin_row();
  /// Forgets the peak so far; without effect in scope process.
  void restart();
  /// Returns the largest resident bytes since the last restart or begin_row, or of the process.
  std::int64_t peak_bytes() const;

 private:
  MemoryScope scope_;
  Descriptor clear_refs_;   ///< of /proc/self/clear_refs
  std::int64_t floor_ = 0;  ///< getrusage gives at least this, whatever has been reset
  std::int64_t first_base_ = 0;
};

/// Represents fixed work whose time tells how fast the machine is at the moment (kYardsticks).
/// Asking for them before every row takes at most 3 % of the time on them. Memory: 3 MB.
/// Construct and use it in one thread.
class Yardsticks {
 public:
  Yardsticks();
  /// Returns CPU times in seconds. Measured anew if the thread has computed long enough since the
  /// last time, else those of then: the two short ones (25 us each) every 3 ms, that of memory (2
  /// ms) every 200 ms.
  const std::array<double, 3>& now_s();

 private:
  using Heads = std::vector<std::uint32_t>;  ///< three for every vertex, where its edges lead

  Heads cached_;  ///< of a random graph of 2^10 vertices: 12 KB
  Heads memory_;  ///< of 2^17: 1.5 MB
  std::vector<std::uint32_t> queue_;
  std::vector<bool> seen_;
  std::array<double, 3> last_s_{};
  Stopwatch clock_{kCpuTime};
  double next_short_s_ = 0, next_memory_s_ = 0;  ///< on `clock_`

  void search(const Heads& heads);
};

}  // namespace ar3d
