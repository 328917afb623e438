// Uniform random regular graphs beside other programs', CPU time of a process for each graph; and
// ours by number of threads, wall time.
#include <fmt/format.h>
#include <igraph/igraph.h>
#include <omp.h>

#include "../peer_generators.h"
#include "ar3d/bench/measure/one_thread.h"
#include "ar3d/generators/random_graphs.h"
#include "limit.h"
#include "turns.h"

namespace ar3d::limits {
namespace {

/// Peers begin again until chance gives them a simple graph: genrang's times of one n differ by a
/// factor of forty, so there are more rounds than elsewhere, and means are compared.
constexpr int kRoundsPerRepetition = 4;
constexpr double kPeerSeconds = 90;

using Generator = void (*)(std::uint64_t, std::uint32_t, std::uint32_t);

void measure_peer(std::uint32_t degree, Generator peer, const Scale& scale, Limit& limit) {
  std::uint32_t seed = 0;
  const auto cost = [&](Generator generator) {
    return kernels::cost_of([&] { generator(scale.n, degree, seed); }).cpu_s;
  };
  const auto cost_of_peer = [&] {
    try {
      return cost(peer);
    } catch (const std::runtime_error& error) {
      throw NotMeasured(error.what());
    }
  };
  Turns turns({[&] { return cost(kernels::generate_ours); }, cost_of_peer});
  const int rounds = scale.repetitions == 1 ? 1 : kRoundsPerRepetition * scale.repetitions;
  turns.run(rounds, kPeerSeconds, [&] { ++seed; });
  const double mean = turns.mean_of(1);
  limit.measured = mean / turns.mean_of(0);
  limit.remark = fmt::format("means of {} graphs: {:.3g} s", turns.rounds(), mean);
  if (turns.rounds() > 1) {
    limit.remark += fmt::format(" ± {:.2g} s", turns.standard_error_of(1));
  }
  limit.remark += fmt::format(", ours {:.3g} s", turns.mean_of(0));
}

Group peer_group(std::uint32_t degree, const char* name, Generator peer, double goal) {
  return {fmt::format("generate/{}/{}", degree, name),
          1'000'000,
          {{fmt::format("uniform random {}-regular graphs", degree),
            name,
            {Goal::Kind::at_least, goal, "× faster"},
            "the peer's time is chance, and the goal is from a run of few graphs"}},
          [degree, peer](const Scale& scale, std::vector<Limit>& limits) {
            measure_peer(degree, peer, scale, limits[0]);
          }};
}

void measure_threads(std::uint32_t degree, const Scale& scale, Limit& limit) {
  const OneThread restore_afterwards;
  std::uint32_t seed = 0;
  const auto on_threads = [&](int threads) {
    return [&, threads] {
      omp_set_num_threads(threads);
      (void)random_regular(scale.n, degree, seed);
    };
  };
  Turns turns({timed(Clock::wall, on_threads(1)), timed(Clock::wall, on_threads(2))});
  turns.run(scale.repetitions, kNoLimit, [&] { ++seed; });
  limit.measured = turns.median_of(0) / turns.median_of(1);
  limit.remark = fmt::format("{:.3g} s and {:.3g} s", turns.median_of(0), turns.median_of(1));
}

}  // namespace

std::vector<Group> generating_groups() {
  std::vector<Group> groups = {
      peer_group(3, "nauty-genrang", kernels::generate_genrang, 3.2),
      peer_group(4, "nauty-genrang", kernels::generate_genrang, 31),
      peer_group(3, "igraph", kernels::generate_igraph_uniform, 10),
      peer_group(4, "igraph", kernels::generate_igraph_uniform, 16),
  };
  for (const std::uint32_t degree : {3u, 4u}) {
    groups.push_back({fmt::format("generate/{}/threads", degree),
                      1'000'000,
                      {{fmt::format("uniform random {}-regular graphs, 2 threads", degree),
                        "1 thread",
                        {Goal::Kind::at_least, 1.7}}},
                      [degree](const Scale& scale, std::vector<Limit>& limits) {
                        measure_threads(degree, scale, limits[0]);
                      }});
  }
  return groups;
}

}  // namespace ar3d::limits
