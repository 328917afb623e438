// Generated, drawn and certified in one process: memory and times of all stages are printed
// (docs/verify.md, "Costs").
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <time.h>

#include <cstdio>
#include <utility>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/verify/certificate.h"

namespace ar3d::testing {
namespace {

/// CPU time of this process, so that other programs' work does not count.
class Stopwatch {
 public:
  /// Seconds since the last call.
  double lap() {
    const double now = cpu_seconds();
    return now - std::exchange(last_, now);
  }

 private:
  static double cpu_seconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  double last_ = cpu_seconds();
};

/// Peak resident memory of this process so far, in GiB.
double peak_gib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / (1024.0 * 1024.0);
}

void certify_and_print(const char* what, const Graph& graph, const Drawing& drawing,
                       const Guarantee& guarantee, const CertifyOptions& options) {
  const double before = peak_gib();
  Stopwatch watch;
  const Certificate certificate = certify(graph, drawing, guarantee, options);
  const double certified = watch.lap();
  std::printf("%-10s n %8u  segments %9llu  certify %6.2f s  peak %.2f GiB, before %.2f GiB\n",
              what, graph.num_vertices(), static_cast<unsigned long long>(certificate.segments),
              certified, peak_gib(), before);
  ASSERT_TRUE(certificate.valid()) << certificate.violations.at(0).message;
  EXPECT_LT(peak_gib(), 8.0);
}

void draw_and_certify(const char* family, const char* name, const CertifyOptions& options) {
  const Algorithm& algorithm = find_algorithm(name);
  for (const std::uint64_t n : {1000u, 10000u, 100000u, 1000000u}) {
    Stopwatch watch;
    const Graph graph = generate(find_family(family), n, 1);
    const double generated = watch.lap();
    const Drawing drawing = draw(algorithm, graph);
    std::printf("generate %.2f s, draw %.2f s: ", generated, watch.lap());
    certify_and_print(name, graph, drawing, algorithm.guarantee, options);
  }
}

TEST(Million, DiamondByCounting) { draw_and_certify("random-4-regular", "diamond", {}); }

TEST(Million, TwoBendByHalving) {
  draw_and_certify("random-cubic", "two-bend", {.crossing_test = CrossingTest::halving});
}

}  // namespace
}  // namespace ar3d::testing
