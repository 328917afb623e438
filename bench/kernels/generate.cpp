// Random regular graphs against nauty-genrang (Debian package nauty), CPU seconds of both in the
// same run, interleaved. Usage: ar3d_bench_generate [N [REPETITIONS]]      (default 1000000 10)
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/time.h>

#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <string>

#include "ar3d/generators/random_regular.h"

namespace {

double own_cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double children_user_seconds() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) +
         1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

/// Edges and Graph, as every user of the library pays for them.
double time_ours(std::uint64_t n, std::uint32_t d, std::uint64_t seed) {
  const double start = own_cpu_seconds();
  const ar3d::Graph graph = ar3d::random_regular(n, d, seed);
  return graph.num_vertices() == n ? own_cpu_seconds() - start : -1;
}

/// genrang writes sparse6 to /dev/null; -1 if it cannot be run.
double time_genrang(std::uint64_t n, std::uint32_t d, std::uint64_t seed) {
  const double start = children_user_seconds();
  const std::string command =
      fmt::format("nauty-genrang -q -r{} -S{} {} 1 > /dev/null", d, seed, n);
  return std::system(command.c_str()) == 0 ? children_user_seconds() - start : -1;
}

}  // namespace

int main(int argc, char** argv) {
  const std::uint64_t n = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1000000;
  const std::uint64_t repetitions = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 10;
  fmt::print("n = {}, one thread, mean CPU seconds of {} seeds\n", n, repetitions);
  fmt::print("{:>3} {:>10} {:>10} {:>8}\n", "d", "ar3d", "genrang", "ratio");
  for (const std::uint32_t d : {3u, 4u}) {
    double ours = 0;
    double theirs = 0;
    for (std::uint64_t seed = 1; seed <= repetitions; ++seed) {
      ours += time_ours(n, d, seed);
      const double seconds = time_genrang(n, d, seed);
      if (seconds < 0) {
        fmt::print(stderr, "nauty-genrang cannot be run; install the package nauty\n");
        return 1;
      }
      theirs += seconds;
    }
    const auto count = static_cast<double>(repetitions);
    fmt::print("{:>3} {:>10.3f} {:>10.3f} {:>8.2f}\n", d, ours / count, theirs / count,
               theirs / ours);
  }
  return 0;
}
