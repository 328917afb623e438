// The raw tokenising of a format's text on one core, nothing kept: the floor under parse/F of
// catalogue_kernel.cpp.
//   tokenize/F  a plain loop over the bytes in memory that extracts every integer; the text is a
//               random cubic graph with n vertices (parameter)
//   read/F      the same text read into a finished Graph, as parse/F
//   rows        a finished Graph from the edges alone

#include <benchmark/benchmark.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "inputs.h"

namespace ar3d::kernels {
namespace {

const std::string& random_cubic_text(const benchmark::State& state, const GraphFormat& format) {
  return text_of(format, find_family("random-cubic"), static_cast<std::uint64_t>(state.range(0)));
}

/// The sum of all numbers in the text.
std::uint64_t sum_of_numbers(const std::string& text) {
  std::uint64_t sum = 0;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at != end) {
    if (*at < '0' || *at > '9') {
      ++at;
      continue;
    }
    std::uint64_t value = 0;
    for (; at != end && *at >= '0' && *at <= '9'; ++at) {
      value = 10 * value + static_cast<unsigned>(*at - '0');
    }
    sum += value;
  }
  return sum;
}

void tokenize_numbers(benchmark::State& state, const GraphFormat* format) {
  const std::string& text = random_cubic_text(state, *format);
  for (auto _ : state) benchmark::DoNotOptimize(sum_of_numbers(text));
  state.SetBytesProcessed(static_cast<std::int64_t>(text.size()) * state.iterations());
}

void read_graph(benchmark::State& state, const GraphFormat* format) {
  const std::string& text = random_cubic_text(state, *format);
  for (auto _ : state) {
    state.PauseTiming();
    TextInput input("memory", bytes_of(text));
    state.ResumeTiming();
    GraphReader reader(std::move(input), {.format = format->name});
    benchmark::DoNotOptimize(reader.next());
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(text.size()) * state.iterations());
}

void build_rows(benchmark::State& state) {
  const Graph& graph =
      graph_of(find_family("random-cubic"), static_cast<std::uint64_t>(state.range(0)));
  for (auto _ : state) {
    state.PauseTiming();
    std::vector<Edge> edges(graph.edges().begin(), graph.edges().end());
    state.ResumeTiming();
    benchmark::DoNotOptimize(Graph(graph.num_vertices(), std::move(edges)));
  }
}

[[maybe_unused]] const bool kRegistered = [] {
  constexpr std::int64_t kTenMillionEdges = 6'666'666;
  const auto add = [](const std::string& name, auto... kernel) {
    benchmark::RegisterBenchmark(name.c_str(), kernel...)
        ->Arg(1'000'000)
        ->Arg(kTenMillionEdges)
        ->MeasureProcessCPUTime()
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
  };
  for (const char* name : {"matrixmarket", "edgelist", "dimacs", "metis", "adjlist"}) {
    add(std::string("tokenize/") + name, tokenize_numbers, &find_graph_format(name));
    add(std::string("read/") + name, read_graph, &find_graph_format(name));
  }
  add("read/sparse6", read_graph, &find_graph_format("sparse6"));
  add("rows", build_rows);
  return true;
}();

}  // namespace
}  // namespace ar3d::kernels
