// How long drawing takes beside a plain breadth-first search of the same graph:
//   time/ALGORITHM/FAMILY/N  both in turns, vertices shuffled: medians of the CPU time in
//   nanoseconds
//                            per vertex (search_ns; draw_ns at the default effort), and effort_0,
//                            effort_1: the time of drawing at that effort / that of the search
// No bend is read. N from 10^3 to 10^7. The most costly effort is left out.

#include "draw_time_kernel.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/algorithms/effort.h"
#include "ar3d/bench/measure/one_thread.h"
#include "ar3d/bench/measure/stopwatch.h"
#include "ar3d/generators/catalog.h"
#include "inputs.h"
#include "search.h"

namespace ar3d::kernels {
namespace {

template <class Work>
double nanoseconds(const Work& work) {
  const CpuStopwatch time;  // what else runs on the machine counts less
  work();
  return 1e9 * time.cpu_s();
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// The efforts that are timed; one unnamed setting for an algorithm without efforts.
std::map<std::string, Settings> timed_efforts(const Algorithm& algorithm) {
  if (std::ranges::none_of(algorithm.options,
                           [](const SettingSpec& option) { return option.name == "effort"; })) {
    return {{"draw", {}}};
  }
  return {{"effort_0", {{"effort", 0}}}, {"effort_1", {{"effort", 1}}}};
}

void time_kernel(benchmark::State& state, const Algorithm& algorithm, const Family& family) {
  const Graph graph =
      generate(family, static_cast<std::uint64_t>(state.range(0)), kSeed, {{"shuffle", 1}});
  const double n = graph.num_vertices();
  const auto efforts = timed_efforts(algorithm);
  std::map<std::string, std::vector<double>> draws;
  std::vector<double> searches;
  const OneThread one_thread;
  for (auto _ : state) {
    searches.push_back(
        nanoseconds([&] { benchmark::DoNotOptimize(search_breadth_first(graph).data()); }) / n);
    for (const auto& effort : efforts) {
      draws[effort.first].push_back(
          nanoseconds([&] { benchmark::DoNotOptimize(draw(algorithm, graph, effort.second)); }) /
          n);
    }
    state.SetIterationTime(draws.rbegin()->second.back() * n / 1e9);
  }
  state.counters["n"] = n;
  state.counters["search_ns"] = median(searches);
  state.counters["draw_ns"] = median(draws.rbegin()->second);
  for (const auto& [name, times] : draws) state.counters[name] = median(times) / median(searches);
}

}  // namespace

void register_draw_times() {
  constexpr std::int64_t kDrawn = 2'000'000;  // vertices, in at least three drawings
  for (const Algorithm* row : proved_algorithms()) {
    const Algorithm& algorithm = *row;
    for (const Family& family : families()) {
      if (family.max_degree > algorithm.guarantee.max_degree) continue;
      for (const std::int64_t n : {1'000, 10'000, 100'000, 1'000'000, 10'000'000}) {
        benchmark::RegisterBenchmark(
            ("time/" + algorithm.name + "/" + family.name).c_str(),
            [&](benchmark::State& state) { time_kernel(state, algorithm, family); })
            ->Arg(n)
            ->UseManualTime()
            ->Iterations(std::clamp<std::int64_t>(kDrawn / n, 3, 99));
      }
    }
  }
}

}  // namespace ar3d::kernels
