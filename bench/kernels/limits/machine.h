#pragma once

#include <cstddef>

namespace ar3d::limits {

/// What one thread gets from the machine's memory, measured now.
struct MemorySpeed {
  double read_gb_per_s = 0;  ///< a sum over an array that no cache holds
  double copy_gb_per_s = 0;  ///< bytes read and written
  double latency_ns = 0;     ///< a chain of dependent reads at random places
  double overlapped_ns = 0;  ///< the same, 32 chains in turns
};

/// Medians of `rounds` on arrays of `bytes` bytes.
MemorySpeed measure_memory(std::size_t bytes, int rounds);

}  // namespace ar3d::limits
