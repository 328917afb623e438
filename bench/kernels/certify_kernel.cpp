// Certifying drawings of random graphs, and other ways to judge, which are only measured; CPU time
// of one thread:
//   certificate/WAY/ALGORITHM/N  `counting`, the proof by counting; `widest`, the same with
//                                predicates in the widest integers, without the range check;
//                                `plain`, the plain tests alone (slabs); `examine`,
//                                certificate, metrics and hash together; `draw`, the drawing
//   closest/WAY/ALGORITHM/N      the closest pair by `strips` and by the `tree`

#include <benchmark/benchmark.h>

#include <cstdint>
#include <string>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/bench/measure/cores.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/verify/examination.h"
#include "ar3d/verify/metrics/closest_pair.h"
#include "ar3d/verify/metrics/metrics.h"
#include "ar3d/verify/predicates/widths.h"
#include "inputs.h"

namespace ar3d::kernels {
namespace {

/// Holds what a kernel works on.
struct Drawn {
  const Graph& graph;
  const Algorithm& algorithm;
  Drawing drawing;
  const Guarantee& guarantee() const { return algorithm.guarantee; }
};

bool proved(const Drawn& drawn, const CertifyOptions& options = {}) {
  return certify(drawn.graph, drawn.drawing, drawn.guarantee(), options).valid();
}

bool proved_in_widest(const Drawn& drawn) {
  const verify::WidestIntegers widest;
  return proved(drawn);
}

bool plain_tests_pass(const Drawn& drawn) {
  return proved(drawn, {.crossing_test = CrossingTest::slabs});
}

/// Registers WHAT/ALGORITHM/N. @param judge  (const Drawn&) -> bool, which must be true.
template <class Judge>
void add(const std::string& what, const Algorithm& algorithm, std::int64_t largest, Judge judge) {
  const auto kernel = [judge, &algorithm](benchmark::State& state) {
    const OneThread one_thread;
    const Graph& graph =
        graph_of(random_family(algorithm), static_cast<std::uint64_t>(state.range(0)));
    const Drawn drawn{graph, algorithm, draw(algorithm, graph)};
    bool right = true;
    for (auto _ : state) right = judge(drawn) && right;
    if (!right) state.SkipWithError("a drawing is not valid");
    state.counters["vertices"] = graph.num_vertices();
    state.counters["segments"] = static_cast<double>(measure(drawn.drawing).segments);
  };
  benchmark::RegisterBenchmark((what + "/" + algorithm.name).c_str(), kernel)
      ->RangeMultiplier(10)
      ->Range(largest / 100, largest)
      ->Unit(benchmark::kMillisecond);
}

const bool kRegistered = [] {
  constexpr std::int64_t kLargest = 1'000'000;
  for (const Algorithm* row : proved_algorithms()) {
    add("certificate/counting", *row, kLargest, [](const Drawn& drawn) { return proved(drawn); });
    add("certificate/widest", *row, kLargest, proved_in_widest);
    add("certificate/plain", *row, kLargest, plain_tests_pass);
    add("certificate/examine", *row, kLargest, [](const Drawn& drawn) {
      return examine(drawn.graph, drawn.drawing, drawn.guarantee()).certificate.valid();
    });
    add("certificate/draw", *row, kLargest, [](const Drawn& drawn) {
      return draw(drawn.algorithm, drawn.graph).num_edges() == drawn.graph.num_edges();
    });
    add("closest/strips", *row, kLargest, [](const Drawn& drawn) {
      return verify::closest_pair_by_strips(drawn.drawing).has_value();
    });
    add("closest/tree", *row, kLargest,
        [](const Drawn& drawn) { return verify::closest_pair_by_tree(drawn.drawing).has_value(); });
  }
  return true;
}();

}  // namespace
}  // namespace ar3d::kernels
