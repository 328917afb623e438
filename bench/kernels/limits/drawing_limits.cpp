// Drawing beside a plain breadth-first search of the same graph: one thread, CPU time, vertices
// shuffled, no bend read. And one drawing on two threads beside one: wall time.
#include <fmt/format.h>
#include <omp.h>

#include <array>
#include <cstddef>

#include "../inputs.h"
#include "../turns.h"
#include "ar3d/algorithms/catalog.h"
#include "ar3d/bench/measure/cores.h"
#include "limit.h"

namespace ar3d::kernels {
namespace {

struct DrawingCase {
  const char* algorithm;
  const char* family;
  const char* family_words;
  std::vector<int> efforts;
  std::uint64_t n;
  std::vector<double> goals;  ///< by effort
  const char* why_missed;
};

// docs/performance.md says why.
constexpr const char* kDiamondPasses =
    "some 14 random accesses per vertex, four of them of the walks over all edges";
constexpr const char* kGridPasses =
    "Kempe chains, whose steps wait for one another, then the breadth-first order and its copies";
constexpr const char* kTwoBendPasses =
    "two depth-first searches, whose steps wait for one another, and some twenty passes";
constexpr const char* kCompactTries =
    "29 cells tried per vertex, and waiting for lines and ejected neighbours";

void measure_drawing(const DrawingCase& drawn, const RunSize& scale, std::vector<Limit>& limits) {
  const OneThread one_thread;
  const Graph graph = shuffled(find_family(drawn.family), scale.n);
  const Algorithm& algorithm = find_algorithm(drawn.algorithm);
  std::vector<std::function<double()>> works = {
      timed(Clock::cpu, [&] { (void)search_breadth_first(graph); })};
  for (const int effort : drawn.efforts) {
    const Settings options = effort < 0 ? Settings{} : Settings{{"effort", effort}};
    works.push_back(timed(Clock::cpu, [&, options] { (void)draw(algorithm, graph, options); }));
  }
  Turns turns(std::move(works));
  turns.run(scale.repetitions);
  const double search = turns.median_of(0);
  const double per_vertex = 1e9 / static_cast<double>(graph.num_vertices());
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const double drawing = turns.median_of(i + 1);
    limits[i].measured = drawing / search;
    limits[i].remark = fmt::format("{:.0f} ns per vertex, search {:.0f} ns", drawing * per_vertex,
                                   search * per_vertex);
  }
}

LimitGroup drawing_group(const DrawingCase& drawn) {
  LimitGroup group{fmt::format("draw/{}/{}", drawn.algorithm, drawn.n), drawn.n, {}, {}};
  for (std::size_t i = 0; i < drawn.efforts.size(); ++i) {
    const std::string effort =
        drawn.efforts[i] < 0 ? "" : fmt::format(" effort {}", drawn.efforts[i]);
    group.limits.push_back(
        {fmt::format("draw `{}`{}, {}", drawn.algorithm, effort, drawn.family_words),
         "breadth-first search", at_most(drawn.goals[i]), drawn.why_missed});
  }
  group.measure = [drawn](const RunSize& scale, std::vector<Limit>& limits) {
    measure_drawing(drawn, scale, limits);
  };
  return group;
}

void measure_threads(const RunSize& scale, std::vector<Limit>& limits) {
  const OneThread restore_afterwards;
  const Graph graph = shuffled(find_family("random-4-regular"), scale.n);
  const Algorithm& diamond = find_algorithm("diamond");
  std::array<std::vector<double>, 3> of_main;  // its CPU time, by number of threads
  const auto on_threads = [&](int threads) {
    return [&, threads] {
      omp_set_num_threads(threads);
      const CpuStopwatch time;
      (void)draw(diamond, graph, {{"effort", 0}});
      of_main[static_cast<std::size_t>(threads)].push_back(time.cpu_s());
    };
  };
  Turns turns(
      {timed(Clock::wall, on_threads(1)), timed(Clock::wall, on_threads(2)), side_by_side([&] {
         (void)draw(diamond, graph, {{"effort", 0}});
       })});
  turns.run(scale.repetitions);
  limits[0].measured = turns.median_of(0) / turns.median_of(1);
  limits[0].remark =
      fmt::format("{:.3g} s and {:.3g} s; CPU time of the calling thread {:.3g} s and {:.3g} s",
                  turns.median_of(0), turns.median_of(1), median(of_main[1]), median(of_main[2]));
  limits[0].why_missed =
      fmt::format("two drawings side by side, which share only the machine, gain {:.2f}×",
                  turns.median_of(0) / turns.median_of(2));
}

}  // namespace

std::vector<LimitGroup> drawing_groups() {
  constexpr const char* kFour = "random 4-regular";
  constexpr const char* kCubic = "random cubic";
  std::vector<LimitGroup> groups;
  for (const DrawingCase& drawn : std::vector<DrawingCase>{
           {"diamond", "random-4-regular", kFour, {0, 1}, 1'000'000, {2.0, 2.0}, kDiamondPasses},
           {"diamond", "random-4-regular", kFour, {0, 1}, 10'000'000, {1.5, 1.5}, kDiamondPasses},
           {"grid", "random-cubic", kCubic, {0, 1}, 1'000'000, {8, 8}, kGridPasses},
           {"two-bend", "random-cubic", kCubic, {0, 1}, 1'000'000, {12, 12}, kTwoBendPasses},
           {"compact", "random-4-regular", kFour, {-1}, 1'000'000, {15}, kCompactTries}}) {
    groups.push_back(drawing_group(drawn));
  }
  groups.push_back(
      {"draw/threads",
       10'000'000,
       {{"draw `diamond` effort 0, random 4-regular, 2 threads", "1 thread", at_least(1.6)}},
       measure_threads});
  return groups;
}

}  // namespace ar3d::kernels
