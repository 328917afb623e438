// Random regular graphs: this project's generator against nauty-genrang -r (Debian package nauty)
// and igraph's C library, each graph in a process of its own, so that CPU time and memory are
// measured in the same way for all; then wall times of ours by number of threads. --help tells the
// options.
#include <fmt/format.h>
#include <omp.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "ar3d/generators/random_graphs.h"
#include "peer_generators.h"
#include "turns.h"

namespace {

using namespace ar3d::kernels;

struct GenerateOptions {
  std::uint64_t n = 1000000;
  std::uint32_t seeds = 7;
  std::vector<std::uint32_t> degrees = {3, 4};
  std::vector<int> threads = {1, 2};
};

struct PeerGenerator {
  const char* name;
  std::function<void(std::uint64_t, std::uint32_t, std::uint32_t)> generate;
  std::vector<Cost> costs = {};
};

void compare(const GenerateOptions& options, std::uint32_t d, double empty_bytes) {
  std::vector<PeerGenerator> generators = {
      {"ar3d (uniform)", generate_ours},
      {"nauty-genrang -r (uniform)", generate_genrang},
      {"igraph_k_regular_game", generate_igraph},
      {"igraph configuration model (uniform)", generate_igraph_uniform}};
  for (std::uint32_t seed = 1; seed <= options.seeds; ++seed) {
    for (PeerGenerator& g : generators) {
      g.costs.push_back(cost_of([&] { g.generate(options.n, d, seed); }));
    }
  }
  const auto median_cpu = [](const PeerGenerator& g) {
    std::vector<double> values;
    for (const Cost& cost : g.costs) values.push_back(cost.cpu_s);
    return median(values);
  };
  for (const PeerGenerator& g : generators) {
    double bytes = 0;
    double slowest = 0;
    for (const Cost& cost : g.costs) {
      bytes = std::max(bytes, cost.peak_bytes - empty_bytes);
      slowest = std::max(slowest, cost.cpu_s);
    }
    fmt::print("{:>2}  {:<37} {:>9.3f} {:>9.3f} {:>7.2f} {:>11.1f}\n", d, g.name, median_cpu(g),
               slowest, median_cpu(g) / median_cpu(generators[0]),
               bytes / static_cast<double>(options.n));
  }
}

/// Wall times of the call, within this process; the threads are started before.
void compare_threads(const GenerateOptions& options, std::uint32_t d) {
  std::vector<std::vector<double>> walls(options.threads.size());
  for (std::uint32_t seed = 0; seed <= options.seeds; ++seed) {
    for (std::size_t t = 0; t < walls.size(); ++t) {
      omp_set_num_threads(options.threads[t]);
      const auto start = std::chrono::steady_clock::now();
      const ar3d::Graph graph = ar3d::random_regular(options.n, d, seed);
      const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
      if (seed > 0) walls[t].push_back(wall.count());
    }
  }
  for (std::size_t t = 0; t < walls.size(); ++t) {
    fmt::print("{:>2} {:>8} {:>9.4f} {:>9.2f}\n", d, options.threads[t], median(walls[t]),
               median(walls[0]) / median(walls[t]));
  }
}

void print_tables(const GenerateOptions& options) {
  const double empty_bytes = cost_of([] {}).peak_bytes;
  fmt::print(
      "n = {}, {} seeds, interleaved; one thread; the process without a graph is taken off "
      "the memory\n",
      options.n, options.seeds);
  fmt::print("{:>2}  {:<37} {:>9} {:>9} {:>7} {:>11}\n", "d", "generator", "CPU s", "slowest",
             "/ ar3d", "bytes/vertex");
  for (const std::uint32_t d : options.degrees) compare(options, d, empty_bytes);
  fmt::print("\n{:>2} {:>8} {:>9} {:>9}\n", "d", "threads", "wall s", "speed-up");
  for (const std::uint32_t d : options.degrees) compare_threads(options, d);
}

}  // namespace

int main(int argc, char** argv) {
  GenerateOptions options;
  CLI::App app(
      "Random regular graphs: ar3d, nauty-genrang and igraph side by side.\n"
      "Example: ar3d_bench_generate -n 1000000 --seeds 7");
  app.add_option("-n", options.n, "vertices, even")->capture_default_str();
  app.add_option("--seeds", options.seeds, "graphs of each kind; medians are shown")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--degree", options.degrees, "3, 4 or both")
      ->check(CLI::Range(3, 4))
      ->capture_default_str();
  app.add_option("--threads", options.threads, "numbers of threads of ours to compare")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    print_tables(options);
  } catch (const std::exception& error) {
    fmt::print(stderr, "ar3d_bench_generate: {}\n", error.what());
    return 1;
  }
  return 0;
}
