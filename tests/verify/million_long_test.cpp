// Generated, drawn and certified in one process: the table of docs/verify.md is this test's output.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <cstdio>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/verify/certificate.h"

namespace ar3d {
namespace {

class Stopwatch {
 public:
  /// Seconds since the last call.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> passed = now - last_;
    last_ = now;
    return passed.count();
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Peak resident memory of this process so far, in GiB.
double peak_gib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / (1024.0 * 1024.0);
}

void draw_and_certify(const char* family, const char* algorithm, std::uint64_t n,
                      const OptionValues& options) {
  Stopwatch watch;
  const Graph graph = generate(find_family(family), n, 1);
  const double generated = watch.lap();
  const Algorithm& row = find_algorithm(algorithm);
  const Drawing drawing = draw(row, graph, options);
  const double drawn = watch.lap();
  const double before = peak_gib();
  const Certificate certificate = certify(graph, drawing, row.guarantee);
  std::printf(
      "%-16s %-10s n %8u  segments %9llu  generate %6.2f s  draw %6.2f s  certify %6.2f s"
      "  peak %.2f GiB, %.2f before certifying\n",
      family, algorithm, graph.num_vertices(),
      static_cast<unsigned long long>(certificate.segments), generated, drawn, watch.lap(),
      peak_gib(), before);
  EXPECT_TRUE(certificate.valid()) << certificate.violations.at(0).message;
  EXPECT_LT(peak_gib(), 8.0);
}

TEST(Million, RandomFourRegularOnTheDiamondLattice) {
  for (const std::uint64_t n : {1000u, 10000u, 100000u, 1000000u}) {
    draw_and_certify("random-4-regular", "diamond", n, {});
  }
}

}  // namespace
}  // namespace ar3d
