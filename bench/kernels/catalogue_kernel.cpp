// Every row of the catalogues as a kernel, for every family that fits and every size:
//   draw/ALGORITHM/FAMILY/N     the call of the algorithm, no bend read
//   search/FAMILY/N             a plain breadth-first search: limits/table.py divides by it
//   certify/ALGORITHM/FAMILY/N  the proof of that drawing in exact integers
//   generate/FAMILY/N           edges and finished Graph
//   parse/FORMAT/FAMILY/N       from the text in memory to the finished Graph
// Default options and parameters; vertices in random order where a graph is given. Items are
// vertices; bytes are those of the text (parse) or of the graph in memory (the others). Growth with
// n is what a study measures, with its uncertainty.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <set>
#include <string>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/verify/certificate.h"
#include "inputs.h"

namespace ar3d::kernels {
namespace {

constexpr std::array<std::uint64_t, 4> kSizes = {1'000, 10'000, 100'000, 1'000'000};
constexpr std::uint64_t kLargestGraph6 = 10'000;  // n^2 / 2 bits

/// A family at a size it can make.
struct Input {
  const Family* family;
  std::uint64_t n;
  const Graph& graph() const { return graph_of(*family, n); }
};

void count(benchmark::State& state, const Graph& graph, std::int64_t bytes) {
  state.SetItemsProcessed(state.iterations() * graph.num_vertices());
  state.SetBytesProcessed(state.iterations() * bytes);
}

void draw_kernel(benchmark::State& state, const Algorithm* algorithm, Input input) {
  const Graph& graph = input.graph();
  for (auto _ : state) benchmark::DoNotOptimize(draw(*algorithm, graph));
  count(state, graph, bytes_of_graph(graph));
}

void search_kernel(benchmark::State& state, Input input) {
  const Graph& graph = input.graph();
  for (auto _ : state) benchmark::DoNotOptimize(search_breadth_first(graph).data());
  count(state, graph, bytes_of_graph(graph));
}

void certify_kernel(benchmark::State& state, const Algorithm* algorithm, Input input) {
  const Graph& graph = input.graph();
  const Drawing drawing = draw(*algorithm, graph);
  bool valid = true;
  for (auto _ : state) valid = valid && !certify(graph, drawing, algorithm->guarantee).violated();
  if (!valid) state.SkipWithError("the certificate finds a violation");
  count(state, graph, bytes_of_graph(graph));
}

void generate_kernel(benchmark::State& state, Input input) {
  for (auto _ : state) benchmark::DoNotOptimize(generate(*input.family, input.n, kSeed));
  count(state, input.graph(), bytes_of_graph(input.graph()));
}

void parse_kernel(benchmark::State& state, const GraphFormat* format, Input input) {
  const std::string& text = text_of(*format, *input.family, input.n);
  for (auto _ : state) {
    GraphReader reader(TextInput("memory", bytes_of(text)), {.format = format->name});
    benchmark::DoNotOptimize(reader.next());
  }
  count(state, input.graph(), static_cast<std::int64_t>(text.size()));
}

template <class Kernel, class... Arguments>
void add(const std::string& name, Kernel kernel, Arguments... arguments) {
  benchmark::RegisterBenchmark(name.c_str(), kernel, arguments...)
      ->Unit(benchmark::kMicrosecond)
      ->MeasureProcessCPUTime()
      ->UseRealTime();
}

void add_input(Input input) {
  const std::string place = fmt::format("{}/{}", input.family->name, input.n);
  for (const Algorithm& algorithm : algorithms()) {
    if (input.family->max_degree > algorithm.guarantee.max_degree) continue;
    if (algorithm.by_name_only) continue;
    add(fmt::format("draw/{}/{}", algorithm.name, place), draw_kernel, &algorithm, input);
    add(fmt::format("certify/{}/{}", algorithm.name, place), certify_kernel, &algorithm, input);
  }
  add("search/" + place, search_kernel, input);
  add("generate/" + place, generate_kernel, input);
  for (const GraphFormat& format : graph_formats()) {
    if (format.name == "graph6" && input.n > kLargestGraph6) continue;
    add(fmt::format("parse/{}/{}", format.name, place), parse_kernel, &format, input);
  }
}

constexpr std::array<const char*, 2> kDefaults = {
    "--benchmark_filter=^(generate|(draw|certify|parse)/[^/]+)/random-(cubic|4-regular)/10000/",
    "--benchmark_min_time=0.05"};

}  // namespace

std::span<const char* const> default_arguments() { return kDefaults; }

void register_catalogues() {
  for (const Family& family : families()) {
    std::set<std::uint64_t> sizes;
    for (const std::uint64_t size : kSizes) {
      sizes.insert(family.nearest_n(size, complete_parameters(family, {})));
    }
    for (const std::uint64_t n : sizes) add_input({&family, n});
  }
}

}  // namespace ar3d::kernels
