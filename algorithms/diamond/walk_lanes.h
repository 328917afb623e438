#pragma once

#include <cstdint>
#include <vector>

namespace ar3d::diamond {

/// Sizes that decide how chains are walked, never what comes out; tests set them small.
struct WalkSizes {
  /// Every so many-th vertex cuts the chains through it into stretches; a power of two.
  std::uint32_t stride = 512;
  /// Stretches that a thread walks at the same time.
  std::uint32_t lanes = 48;
  std::uint32_t threads = 1;
};

/// The fastest sizes for n vertices: within the caches, few lanes are enough, and their last
/// stretches, which nobody accompanies, shall be short.
inline WalkSizes walk_sizes(std::uint64_t n, std::uint32_t threads = 1) {
  constexpr std::uint64_t kInCaches = std::uint64_t{1} << 19;
  return n < kInCaches ? WalkSizes{.stride = 256, .lanes = 16, .threads = threads}
                       : WalkSizes{.threads = threads};
}

/// Walks many stretches of chains in turns. A step of a walk reads a place in memory that only the
/// step before it knows, so one walk alone waits for the memory at every step; of many, each asks
/// for its next place and waits while the others step.
/// @param walk  start(lane) begins the next stretch in a lane, false if there is none left;
///              advance(lane) makes a step, false if the stretch ends with it.
template <class Walk>
void walk_in_lanes(Walk& walk, std::uint32_t lanes) {
  std::vector<std::uint32_t> running;
  for (std::uint32_t lane = 0; lane < lanes && walk.start(lane); ++lane) running.push_back(lane);
  while (!running.empty()) {
    for (std::size_t i = 0; i < running.size();) {
      if (walk.advance(running[i]) || walk.start(running[i])) {
        ++i;
      } else {
        running[i] = running.back();
        running.pop_back();
      }
    }
  }
}

}  // namespace ar3d::diamond
