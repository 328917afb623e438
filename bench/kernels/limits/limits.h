#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <functional>
#include <initializer_list>
#include <string>

#include "../inputs.h"

namespace ar3d::kernels {

/// Returns the benchmark's argument: vertices, unless its name says otherwise.
inline std::uint64_t size_of(const benchmark::State& state) {
  return static_cast<std::uint64_t>(state.range(0));
}

/// Registers NAME/n:SIZE for each size, with so many iterations a repetition that a million
/// vertices are treated, but at most ten. What the kernel throws becomes the error of its run.
/// The time is CPU time of the calling thread.
/// @param adjust  receives each benchmark, to choose another clock or threads.
template <class Kernel>
void add_limit(
    const std::string& name, std::initializer_list<std::int64_t> sizes, Kernel kernel,
    const std::function<void(benchmark::internal::Benchmark*)>& adjust = [](auto*) {},
    const char* argument = "n") {
  const auto careful = [kernel](benchmark::State& state) mutable {
    try {
      kernel(state);
    } catch (const std::exception& error) {
      state.SkipWithError(error.what());
    }
  };
  for (const std::int64_t size : sizes) {
    adjust(benchmark::RegisterBenchmark(name.c_str(), careful)
               ->Unit(benchmark::kMillisecond)
               ->ArgName(argument)
               ->Arg(size)
               ->Iterations(std::clamp<std::int64_t>(1'000'000 / size, 1, 10)));
  }
}

/// Returns the algorithm's default drawing of graph_of(random_family(algorithm), n). Those of at
/// most a million vertices are kept, and the last larger one.
const Drawing& drawing_of(const Algorithm& algorithm, std::uint64_t n);

// One file each.
void register_stages();
void register_threads();
void register_peers();
void register_machine();

}  // namespace ar3d::kernels
