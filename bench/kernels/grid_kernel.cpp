// Theorem 3's drawing against a plain breadth-first search of the same graph, nanoseconds a vertex:
//   grid/draw/E  algorithm `grid` at effort E, without reading any bend
//   grid/search  breadth-first search of all components
// Random cubic graphs with n vertices (parameter).

#include <benchmark/benchmark.h>

#include <cstdint>
#include <string>
#include <vector>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/generators/catalog.h"

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
    std::vector<std::uint8_t> seen(graph.num_vertices(), 0);
    std::vector<Vertex> queue;
    for (Vertex start = 0; start < graph.num_vertices(); ++start) {
      if (seen[start]) continue;
      seen[start] = 1;
      std::size_t head = queue.size();
      queue.push_back(start);
      while (head < queue.size()) {
        for (const HalfEdge& half : graph.incident(queue[head++])) {
          if (seen[half.to]) continue;
          seen[half.to] = 1;
          queue.push_back(half.to);
        }
      }
    }
    benchmark::DoNotOptimize(queue.data());
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

const bool kRegistered = [] {
  for (std::int64_t effort = 0; effort <= 2; ++effort) {
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
}  // namespace ar3d
