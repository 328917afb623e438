// Work by number of threads, wall time:
//   threads/WORK/threads:T/n:N    the work on T threads
//   at_once/WORK/n:N/threads:2    half of the time of two works side by side, each on one thread:
//                                 what a second thread can give where they share only the machine
//   study/rows/workers:T/rows:R   rows of a study, everything on (certificate, metrics, hashes)
#include <fmt/format.h>
#include <omp.h>

#include <stdexcept>

#include "ar3d/bench/measure/cores.h"
#include "ar3d/bench/plan/plan.h"
#include "ar3d/bench/run/session.h"
#include "ar3d/generators/random_graphs.h"
#include "ar3d/verify/certificate.h"
#include "limits.h"

namespace ar3d::kernels {
namespace {

using benchmark::State;

void in_wall_time(benchmark::internal::Benchmark* each) { each->UseRealTime(); }

/// Registers work on one thread, on two, and two at once. @param prepare  makes the work for n.
template <class Prepare>
void add_threads(const std::string& work, std::int64_t largest, Prepare prepare) {
  for (const int threads : {1, 2}) {
    add_limit(
        fmt::format("threads/{}/threads:{}", work, threads), {1'000, largest},
        [=](State& state) {
          const OneThread restore_afterwards;
          const auto once = prepare(size_of(state));
          omp_set_num_threads(threads);
          for (auto _ : state) once();
        },
        in_wall_time);
  }
  add_limit(
      "at_once/" + work, {1'000, largest},
      [=](State& state) {
        const OneThread one_thread;
        const auto once = prepare(size_of(state));
        for (auto _ : state) once();
      },
      [](benchmark::internal::Benchmark* each) { each->UseRealTime()->Threads(2); });
}

void study_limit(State& state, int workers) {
  const StudyPlan plan = plan_study(
      parse_study(fmt::format("study = \"limits\"\n[[sweep]]\nfamilies = \"random-cubic\"\n"
                              "sizes = 1000\nalgorithms = \"grid\"\ninstances = {}\n",
                              size_of(state)),
                  "limits.toml"));
  const RowSink sink = {.add = [](std::size_t, const RunRecord& run) {
    if (run.status != RunStatus::ok) throw std::runtime_error("a row failed: " + run.message);
  }};
  for (auto _ : state) {
    SessionPolicy policy;
    policy.workers = workers;
    run_session(plan, policy, sink);
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

}  // namespace

void register_threads() {
  const Algorithm& diamond = find_algorithm("diamond");
  add_threads("draw/diamond/effort:0", 10'000'000, [&diamond](std::uint64_t n) {
    const Graph& graph = graph_of(random_family(diamond), n);
    return [&] { benchmark::DoNotOptimize(draw(diamond, graph, {{"effort", 0}}).num_edges()); };
  });
  add_threads("certify/diamond", 1'000'000, [&diamond](std::uint64_t n) {
    const Graph& graph = graph_of(random_family(diamond), n);
    const Drawing& drawing = drawing_of(diamond, n);
    return [&] {
      if (!certify(graph, drawing, diamond.guarantee).valid()) {
        throw std::runtime_error("a drawing is not valid");
      }
    };
  });
  for (const std::uint32_t degree : {3u, 4u}) {
    add_threads(fmt::format("generate/{}", degree), 1'000'000, [degree](std::uint64_t n) {
      return [=] { benchmark::DoNotOptimize(random_regular(n, degree, kSeed).num_edges()); };
    });
  }
  for (const int workers : {1, 2}) {
    add_limit(
        fmt::format("study/rows/workers:{}", workers), {20, 2000},
        [workers](State& state) { study_limit(state, workers); },
        [](benchmark::internal::Benchmark* each) { each->UseRealTime()->Iterations(1); }, "rows");
  }
}

}  // namespace ar3d::kernels
