// Uniform random regular graphs beside other programs', CPU time of a process for each graph; and
// ours by number of threads, wall time.
// GraphML from memory into a finished graph: one thread, CPU time, beside igraph.

#include <fmt/format.h>
#include <igraph/igraph.h>
#include <omp.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "../inputs.h"
#include "../peer_generators.h"
#include "../turns.h"
#include "ar3d/bench/measure/cores.h"
#include "ar3d/generators/random_graphs.h"
#include "limit.h"

namespace ar3d::kernels {
namespace {

/// Peers begin again until chance gives them a simple graph: genrang's times of one n differ by a
/// factor of forty, so there are more rounds than elsewhere, and means are compared.
constexpr int kRoundsPerRepetition = 4;
constexpr double kPeerSeconds = 90;

using Generator = void (*)(std::uint64_t, std::uint32_t, std::uint32_t);

void measure_peer(std::uint32_t degree, Generator peer, const RunSize& scale, Limit& limit) {
  std::uint32_t seed = 0;
  double bytes = 0;
  const double empty_bytes = cost_of([] {}).peak_bytes;
  const auto cost_of_ours = [&] {
    const Cost cost = cost_of([&] { generate_ours(scale.n, degree, seed); });
    bytes = std::max(bytes, cost.peak_bytes - empty_bytes);
    return cost.cpu_s;
  };
  const auto cost_of_peer = [&] {
    try {
      return cost_of([&] { peer(scale.n, degree, seed); }).cpu_s;
    } catch (const std::runtime_error& error) {
      throw NotMeasured(error.what());
    }
  };
  Turns turns({cost_of_ours, cost_of_peer});
  const int rounds = scale.repetitions == 1 ? 1 : kRoundsPerRepetition * scale.repetitions;
  turns.run(rounds, kPeerSeconds, [&] { ++seed; });
  const double mean = turns.mean_of(1);
  limit.measured = mean / turns.mean_of(0);
  limit.remark = fmt::format("means of {} graphs: {:.3g} s", turns.rounds(), mean);
  if (turns.rounds() > 1) {
    limit.remark += fmt::format(" ± {:.2g} s", turns.standard_error_of(1));
  }
  limit.remark += fmt::format(", ours {:.3g} s and {:.0f} bytes per vertex", turns.mean_of(0),
                              bytes / static_cast<double>(scale.n));
}

LimitGroup peer_group(std::uint32_t degree, const char* name, Generator peer, double goal,
                      const char* kind = "uniform random") {
  return {fmt::format("generate/{}/{}", degree, name),
          1'000'000,
          {{fmt::format("{} {}-regular graphs", kind, degree), name, at_least(goal, "× faster"),
            "the peer's time is chance, and the goal is from a run of few graphs"}},
          [degree, peer](const RunSize& scale, std::vector<Limit>& limits) {
            measure_peer(degree, peer, scale, limits[0]);
          }};
}

void measure_threads(std::uint32_t degree, const RunSize& scale, Limit& limit) {
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

std::vector<LimitGroup> generating_groups() {
  std::vector<LimitGroup> groups = {
      peer_group(3, "nauty-genrang", generate_genrang, 3.2),
      peer_group(4, "nauty-genrang", generate_genrang, 31),
      peer_group(3, "igraph", generate_igraph_uniform, 10),
      peer_group(4, "igraph", generate_igraph_uniform, 16),
      peer_group(3, "igraph_k_regular_game", generate_igraph, 8, "random"),
      peer_group(4, "igraph_k_regular_game", generate_igraph, 14, "random"),
  };
  for (const std::uint32_t degree : {3u, 4u}) {
    groups.push_back({fmt::format("generate/{}/threads", degree),
                      1'000'000,
                      {{fmt::format("uniform random {}-regular graphs, 2 threads", degree),
                        "1 thread", at_least(1.7)}},
                      [degree](const RunSize& scale, std::vector<Limit>& limits) {
                        measure_threads(degree, scale, limits[0]);
                      }});
  }
  return groups;
}

namespace {

void read_ours(const std::string& text) {
  GraphReader reader(TextInput("memory", bytes_of(text)), {.format = "graphml"});
  if (!reader.next()) throw std::runtime_error("no graph in the text");
}

void read_igraph(std::string& text) {
  igraph_set_error_handler(igraph_error_handler_ignore);
  std::FILE* file = fmemopen(text.data(), text.size(), "r");
  if (file == nullptr) throw std::runtime_error("a text cannot be opened as a file");
  igraph_t graph;
  const auto error = igraph_read_graph_graphml(&graph, file, 0);
  std::fclose(file);
  if (error != IGRAPH_SUCCESS) throw NotMeasured("igraph does not read GraphML here");
  igraph_destroy(&graph);
}

void measure_graphml(const RunSize& scale, std::vector<Limit>& limits) {
  const OneThread one_thread;
  const GraphFormat& format = find_graph_format("graphml");
  std::string text = text_of(format, find_family("random-cubic"), scale.n);
  Turns turns(
      {timed(Clock::cpu, [&] { read_ours(text); }), timed(Clock::cpu, [&] { read_igraph(text); })});
  turns.run(scale.repetitions, kSlowSeconds);
  const double megabytes = 1e-6 * static_cast<double>(text.size());
  limits[0].measured = megabytes / turns.median_of(0);
  limits[0].remark =
      fmt::format("{:.1f} MB, igraph {} {:.3g} MB/s{}", megabytes, IGRAPH_VERSION,
                  megabytes / turns.median_of(1), turns.rounds_remark(scale.repetitions));
}

}  // namespace

std::vector<LimitGroup> reading_groups() {
  return {{"read/graphml",
           300'000,
           {{"GraphML, random cubic", "none", at_least(100, " MB/s")}},
           measure_graphml}};
}

}  // namespace ar3d::kernels
