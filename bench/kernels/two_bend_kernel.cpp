// Theorem 2's drawing against a plain breadth-first search of the same graph, nanoseconds per
// vertex:
//   two-bend/draw/E  algorithm `two-bend` at effort E, without reading any bend; counter
//   `searches`:
//                    its time in breadth-first searches of the same graph, timed in turn with it
// Random cubic graphs with n vertices (parameter).

#include <benchmark/benchmark.h>

#include <chrono>
#include <cstdint>
#include <string>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/generators/catalog.h"
#include "inputs.h"
#include "search.h"

namespace ar3d {
namespace {

void draw_two_bend_kernel(benchmark::State& state, std::int64_t effort) {
  using Clock = std::chrono::steady_clock;
  const Graph& graph =
      kernels::graph_of(find_family("random-cubic"), static_cast<std::uint64_t>(state.range(0)));
  Clock::duration drawing{};
  Clock::duration searching{};
  for (auto _ : state) {
    const auto start = Clock::now();
    benchmark::DoNotOptimize(draw(find_algorithm("two-bend"), graph, {{"effort", effort}}));
    const auto middle = Clock::now();
    state.PauseTiming();
    drawing += middle - start;
    benchmark::DoNotOptimize(kernels::search_breadth_first(graph).data());
    searching += Clock::now() - middle;
    state.ResumeTiming();
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
  state.counters["searches"] =
      static_cast<double>(drawing.count()) / static_cast<double>(searching.count());
}

const bool kRegistered = [] {
  for (std::int64_t effort = 0; effort <= 1; ++effort) {
    benchmark::RegisterBenchmark(("two-bend/draw/" + std::to_string(effort)).c_str(),
                                 [effort](benchmark::State& s) { draw_two_bend_kernel(s, effort); })
        ->RangeMultiplier(10)
        ->Range(10000, 1000000)
        ->Unit(benchmark::kMillisecond);
  }
  return true;
}();

}  // namespace
}  // namespace ar3d
