// Theorem 3's drawing against a plain breadth-first search of the same graph, nanoseconds per
// vertex:
//   grid/draw/E  algorithm `grid` at effort E, without reading any bend
//   grid/search  breadth-first search of all components
// Random cubic graphs with n vertices (parameter). And for every family of maximum degree 3:
//   grid/size-of-FAMILY/N  eight graphs with shuffled vertices at the default effort: time a
//   vertex,
//                       medians of the extents / n and of volume / n^3, and the largest volume /
//                       n^3

#include "grid_kernel.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/random.h"
#include "ar3d/generators/catalog.h"
#include "search.h"

namespace ar3d {
namespace {

const Graph& random_cubic(std::uint64_t n) {
  static std::uint64_t size = 0;
  static Graph graph;
  if (size != n) graph = generate(find_family("random-cubic"), n, 1);
  size = n;
  return graph;
}

void draw_grid_kernel(benchmark::State& state, std::int64_t effort) {
  const Graph& graph = random_cubic(static_cast<std::uint64_t>(state.range(0)));
  for (auto _ : state) {
    benchmark::DoNotOptimize(draw(find_algorithm("grid"), graph, {{"effort", effort}}));
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

void search_kernel(benchmark::State& state) {
  const Graph& graph = random_cubic(static_cast<std::uint64_t>(state.range(0)));
  for (auto _ : state) {
    benchmark::DoNotOptimize(kernels::search_breadth_first(graph).data());
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

constexpr std::uint64_t kSeeds = 8;

Graph shuffled(const Graph& graph, std::uint64_t seed) {
  RandomStream random(seed, 1);
  std::vector<Vertex> name(graph.num_vertices());
  std::iota(name.begin(), name.end(), 0u);
  random.shuffle(std::span<Vertex>(name));
  return relabelled(graph, name);
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

void size_kernel(benchmark::State& state, const Family& family) {
  std::array<std::vector<double>, 4> shares;  // extents / n, volume / n^3
  double n = 0;
  for (auto _ : state) {
    double seconds = 0;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      const Graph graph =
          shuffled(generate(family, static_cast<std::uint64_t>(state.range(0)), seed), seed);
      n = graph.num_vertices();
      const auto start = std::chrono::steady_clock::now();
      const Drawing drawing = draw(find_algorithm("grid"), graph, {});
      seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      double volume = 1;
      const auto extents = bounding_box(drawing).extents();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        shares[axis].push_back(static_cast<double>(extents[axis]) / n);
        volume *= shares[axis].back();
      }
      shares[3].push_back(volume);
    }
    state.SetIterationTime(seconds);
  }
  state.counters["n"] = n;
  state.counters["x"] = median(shares[0]);
  state.counters["y"] = median(shares[1]);
  state.counters["z"] = median(shares[2]);
  state.counters["volume"] = median(shares[3]);
  state.counters["largest_volume"] = *std::ranges::max_element(shares[3]);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kSeeds * n));
}

const bool kRegistered = [] {
  for (std::int64_t effort = 0; effort <= 1; ++effort) {
    benchmark::RegisterBenchmark(("grid/draw/" + std::to_string(effort)).c_str(),
                                 [effort](benchmark::State& s) { draw_grid_kernel(s, effort); })
        ->RangeMultiplier(10)
        ->Range(10000, 1000000);
  }
  benchmark::RegisterBenchmark("grid/search", search_kernel)
      ->RangeMultiplier(10)
      ->Range(10000, 1000000);
  return true;
}();

}  // namespace

void kernels::register_grid_sizes() {
  for (const Family& family : families()) {
    if (family.max_degree > find_algorithm("grid").guarantee.max_degree) continue;
    benchmark::RegisterBenchmark(("grid/size-of-" + family.name).c_str(),
                                 [&family](benchmark::State& s) { size_kernel(s, family); })
        ->RangeMultiplier(10)
        ->Range(1000, 1000000)
        ->UseManualTime()
        ->Iterations(1);
  }
}

}  // namespace ar3d
