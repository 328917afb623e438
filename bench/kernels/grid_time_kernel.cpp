// Growth of algorithm `grid`'s time on every family that it draws:
//   grid/time/FAMILY/N  the drawing at the default effort and a plain breadth-first search of the
//   same graph, in turns, vertices shuffled: medians in nanoseconds a vertex, and their ratio
// No bend is read. N from 10^4 to 10^7.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <vector>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/generators/catalog.h"
#include "grid_kernel.h"
#include "inputs.h"
#include "search.h"

namespace ar3d::kernels {
namespace {

template <class Work>
double nanoseconds(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

void time_kernel(benchmark::State& state, const Family& family) {
  const Graph graph =
      generate(family, static_cast<std::uint64_t>(state.range(0)), kSeed, {{"shuffle", 1}});
  const double n = graph.num_vertices();
  std::vector<double> draws;
  std::vector<double> searches;
  for (auto _ : state) {
    searches.push_back(
        nanoseconds([&] { benchmark::DoNotOptimize(search_breadth_first(graph).data()); }) / n);
    draws.push_back(
        nanoseconds([&] { benchmark::DoNotOptimize(draw(find_algorithm("grid"), graph)); }) / n);
    state.SetIterationTime(draws.back() * n / 1e9);
  }
  state.counters["n"] = n;
  state.counters["draw_ns"] = median(draws);
  state.counters["search_ns"] = median(searches);
  state.counters["ratio"] = median(draws) / median(searches);
}

}  // namespace

void register_grid_times() {
  constexpr std::int64_t kDrawn = 750'000;  // vertices, in at least three drawings
  for (const Family& family : families()) {
    if (family.max_degree > find_algorithm("grid").guarantee.max_degree) continue;
    for (const std::int64_t n : {10'000, 100'000, 1'000'000, 10'000'000}) {
      benchmark::RegisterBenchmark(("grid/time/" + family.name).c_str(),
                                   [&family](benchmark::State& s) { time_kernel(s, family); })
          ->Arg(n)
          ->UseManualTime()
          ->Iterations(std::max<std::int64_t>(3, kDrawn / n));
    }
  }
}

}  // namespace ar3d::kernels
