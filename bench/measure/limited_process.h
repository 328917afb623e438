#pragma once

#include <functional>
#include <optional>
#include <span>

namespace ar3d {

/// What a step may use in a process of its own.
struct StepLimits {
  std::optional<double> cpu_s;         ///< kept to the next whole second
  std::optional<double> memory_bytes;  ///< address space above the caller's; not where the build is
                                       ///< sanitised, which needs all of it
};

enum class StepEnd { done, out_of_time, out_of_memory, failed };

/// Runs `step` in a forked process and copies what it wrote into `result`, which holds plain bytes,
/// back here. The process dies with this one. To be called while no other thread runs.
/// @return out_of_memory also if std::bad_alloc left the step. `result` counts only if done.
/// @throws InputError if the system has no process or pipe left.
StepEnd run_within(const StepLimits& limits, std::span<char> result,
                   const std::function<void()>& step);

}  // namespace ar3d
