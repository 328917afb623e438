// Certifying drawings of random graphs, the proof by counting against the plain tests:
//   certificate/ALGORITHM/N  CPU time of certify(); counters from medians over the iterations,
//                            which time these in turns:
//     ns       nanoseconds per segment
//     widest   time with predicates in the widest integers, without the range check / that time
//     plain    time of the plain tests alone (plane sweep or slabs) / that time
//     examine  time of certificate, metrics and hash together / that time
//     draw     time of drawing / that time
//   closest/ALGORITHM/N  CPU time of the closest pair by strips; counters `ns`, nanoseconds per
//                        vertex, and `grid`, the randomised grid's time / that time

#include <benchmark/benchmark.h>

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/bench/measure/cores.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/verify/checks/examination.h"
#include "ar3d/verify/metrics/closest_pair.h"
#include "ar3d/verify/predicates/widths.h"
#include "inputs.h"
#include "turns.h"

namespace ar3d::kernels {
namespace {

using Function = std::function<void()>;

/// Times the functions in turns; the first is the kernel's own time, the others become counters.
void time_in_turns(benchmark::State& state, std::uint64_t items,
                   const std::vector<std::pair<std::string, Function>>& functions) {
  std::vector<std::function<double()>> works;
  for (const auto& named : functions) works.push_back(timed(Clock::cpu, named.second));
  Turns turns(std::move(works));
  const OneThread one_thread;
  for (auto _ : state) {
    turns.add_round();
    state.SetIterationTime(turns.last_of(0));
  }
  const double own = turns.median_of(0);
  state.counters["ns"] = own / static_cast<double>(items) * 1e9;
  for (std::size_t i = 1; i < functions.size(); ++i) {
    state.counters[functions[i].first] = turns.median_of(i) / own;
  }
}

const Graph& input(const Algorithm& algorithm, benchmark::State& state) {
  return graph_of(random_family(algorithm), static_cast<std::uint64_t>(state.range(0)));
}

void certify_kernel(benchmark::State& state, const Algorithm& algorithm) {
  const Graph& graph = input(algorithm, state);
  const Drawing drawing = draw(algorithm, graph);
  const Guarantee& guarantee = algorithm.guarantee;
  const auto require_valid = [](const Certificate& certificate) {
    if (!certificate.valid()) throw std::runtime_error("a drawing is not valid");
  };
  const CrossingTest plain =
      guarantee.directions.empty() ? CrossingTest::slabs : CrossingTest::plane_sweep;
  time_in_turns(
      state, certify(graph, drawing, guarantee).segments,
      {{"certify", [&] { require_valid(certify(graph, drawing, guarantee)); }},
       {"widest",
        [&] {
          const verify::WidestIntegers widest;
          require_valid(certify(graph, drawing, guarantee));
        }},
       {"plain",
        [&] { require_valid(certify(graph, drawing, guarantee, {.crossing_test = plain})); }},
       {"examine", [&] { require_valid(examine(graph, drawing, guarantee).certificate); }},
       {"draw", [&] { benchmark::DoNotOptimize(draw(algorithm, graph).num_edges()); }}});
}

void closest_kernel(benchmark::State& state, const Algorithm& algorithm) {
  const Graph& graph = input(algorithm, state);
  const Drawing drawing = draw(algorithm, graph);
  time_in_turns(
      state, graph.num_vertices(),
      {{"strips", [&] { benchmark::DoNotOptimize(verify::closest_pair_by_strips(drawing)); }},
       {"grid", [&] { benchmark::DoNotOptimize(verify::closest_pair_by_grid(drawing)); }}});
}

const bool kRegistered = [] {
  for (const Algorithm* row : proved_algorithms()) {
    const Algorithm& algorithm = *row;
    const auto add = [&](const char* what, auto kernel) {
      benchmark::RegisterBenchmark(
          (what + algorithm.name).c_str(),
          [kernel, &algorithm](benchmark::State& state) { kernel(state, algorithm); })
          ->RangeMultiplier(10)
          ->Range(10000, 1000000)
          ->Iterations(9)
          ->UseManualTime()
          ->Unit(benchmark::kMillisecond);
    };
    add("certificate/", certify_kernel);
    add("closest/", closest_kernel);
  }
  return true;
}();

}  // namespace
}  // namespace ar3d::kernels
