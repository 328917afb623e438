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

void count(benchmark::State& state, const Graph& graph, std::int64_t bytes) {
  state.SetItemsProcessed(state.iterations() * graph.num_vertices());
  state.SetBytesProcessed(state.iterations() * bytes);
}

void draw_kernel(benchmark::State& state, const Algorithm* algorithm, const Family* family,
                 std::uint64_t n) {
  const Graph& graph = graph_of(*family, n);
  for (auto _ : state) benchmark::DoNotOptimize(draw(*algorithm, graph));
  count(state, graph, bytes_of_graph(graph));
}

void search_kernel(benchmark::State& state, const Family* family, std::uint64_t n) {
  const Graph& graph = graph_of(*family, n);
  for (auto _ : state) benchmark::DoNotOptimize(search_breadth_first(graph).data());
  count(state, graph, bytes_of_graph(graph));
}

void certify_kernel(benchmark::State& state, const Algorithm* algorithm, const Family* family,
                    std::uint64_t n) {
  const Graph& graph = graph_of(*family, n);
  const Drawing drawing = draw(*algorithm, graph);
  bool valid = true;
  for (auto _ : state) valid = valid && !certify(graph, drawing, algorithm->guarantee).violated();
  if (!valid) state.SkipWithError("the certificate finds a violation");
  count(state, graph, bytes_of_graph(graph));
}

void generate_kernel(benchmark::State& state, const Family* family, std::uint64_t n) {
  for (auto _ : state) benchmark::DoNotOptimize(generate(*family, n, kSeed));
  const Graph& graph = graph_of(*family, n);
  count(state, graph, bytes_of_graph(graph));
}

void parse_kernel(benchmark::State& state, const GraphFormat* format, const Family* family,
                  std::uint64_t n) {
  const std::string& text = text_of(*format, *family, n);
  for (auto _ : state) {
    GraphReader reader(TextInput("memory", bytes_of(text)), {.format = format->name});
    benchmark::DoNotOptimize(reader.next());
  }
  count(state, graph_of(*family, n), static_cast<std::int64_t>(text.size()));
}

template <class Kernel, class... Arguments>
void add(const std::string& name, Kernel kernel, Arguments... arguments) {
  benchmark::RegisterBenchmark(name.c_str(), kernel, arguments...)
      ->Unit(benchmark::kMicrosecond)
      ->MeasureProcessCPUTime()
      ->UseRealTime();
}

/// @param n  a size that the family can make.
void add_input(const Family& family, std::uint64_t n) {
  const std::string suffix = fmt::format("{}/{}", family.name, n);
  for (const Algorithm& algorithm : algorithms()) {
    if (family.max_degree > algorithm.guarantee.max_degree) continue;
    if (algorithm.by_name_only) continue;
    add(fmt::format("draw/{}/{}", algorithm.name, suffix), draw_kernel, &algorithm, &family, n);
    add(fmt::format("certify/{}/{}", algorithm.name, suffix), certify_kernel, &algorithm, &family,
        n);
  }
  add("search/" + suffix, search_kernel, &family, n);
  add("generate/" + suffix, generate_kernel, &family, n);
  for (const GraphFormat& format : graph_formats()) {
    if (format.name == "graph6" && n > kLargestGraph6) continue;
    add(fmt::format("parse/{}/{}", format.name, suffix), parse_kernel, &format, &family, n);
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
    for (const std::uint64_t n : sizes) add_input(family, n);
  }
}

}  // namespace ar3d::kernels
