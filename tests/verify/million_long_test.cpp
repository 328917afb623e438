// Generated, drawn and certified in one process: memory and times of all stages are printed
// (docs/verify.md, "Costs").
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <time.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/random.h"
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
  std::printf("%-32s n %8u  segments %9llu  certify %6.2f s  peak %.2f GiB, before %.2f GiB\n",
              what, graph.num_vertices(), static_cast<unsigned long long>(certificate.segments),
              certified, peak_gib(), before);
  ASSERT_TRUE(certificate.valid()) << certificate.violations.at(0).message;
  EXPECT_LT(peak_gib(), 8.0);
}

TEST(Million, RandomFourRegularOnTheDiamondLattice) {
  const Algorithm& diamond = find_algorithm("diamond");
  for (const std::uint64_t n : {1000u, 10000u, 100000u, 1000000u}) {
    Stopwatch watch;
    const Graph graph = generate(find_family("random-4-regular"), n, 1);
    const double generated = watch.lap();
    const Drawing drawing = draw(diamond, graph);
    std::printf("generate %.2f s, draw %.2f s: ", generated, watch.lap());
    certify_and_print("random-4-regular, diamond, counting", graph, drawing, diamond.guarantee, {});
  }
}

/// A drawing like those of Theorem 2, by hand: the lower half of the vertices have arms along their
/// own row y = 2r at 30 degrees, one to each side, the upper half along their own column x = 2c,
/// and a long vertical segment joins two arms where row and column meet. Every vertex has a range
/// of heights of its own.
class TallDrawing {
 public:
  TallDrawing(Vertex half, std::uint64_t seed)
      : half_(half), random_(seed), row_(places()), column_(places()) {
    for (Vertex v = 0; v < half_; ++v) join(v);
    place_vertices();
  }

  Graph graph() const { return Graph(2 * std::uint64_t{half_}, *edges_); }

  Drawing drawing() const {
    Coordinates vertices(2 * std::size_t{half_}, kMaxCoordinate);
    for (Vertex v = 0; v < 2 * half_; ++v) vertices.set(v, at_[v]);
    auto bends = std::make_shared<StoredBends>();
    for (const auto [u, v] : *edges_) {
      const std::int64_t x = at_[v].x;
      const std::int64_t y = at_[u].y;
      bends->add_edge(
          {{x, y, at_[u].z + std::abs(x - at_[u].x)}, {x, y, at_[v].z - std::abs(y - at_[v].y)}});
    }
    return Drawing("tall", kScaledZLattice, std::move(vertices), edges_, std::move(bends));
  }

 private:
  /// A random row or column for each vertex, all different.
  std::vector<std::int64_t> places() {
    std::vector<std::int64_t> values(2 * std::size_t{half_});
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = 2 * static_cast<std::int64_t>(i);
    random_.shuffle(std::span<std::int64_t>(values));
    return values;
  }

  /// Gives the lower vertex v one upper neighbour on each side, if a few tries find one.
  void join(Vertex v) {
    bool used[2] = {false, false};
    taken_.resize(2 * std::size_t{half_});
    for (int tries = 0; tries < 8; ++tries) {
      const Vertex w = half_ + random_.below(half_);
      const bool side = column_[w] > column_[v];
      const std::uint8_t from = row_[v] > row_[w] ? 1 : 2;
      if (used[side] || (taken_[w] & from) != 0) continue;
      used[side] = true;
      taken_[w] |= from;
      edges_->push_back({v, w});
    }
  }

  /// Every vertex above the arms of those before it.
  void place_vertices() {
    std::vector<std::int64_t> reach(2 * std::size_t{half_});
    for (const auto [u, v] : *edges_) {
      reach[u] = std::max(reach[u], std::abs(column_[u] - column_[v]));
      reach[v] = std::max(reach[v], std::abs(row_[u] - row_[v]));
    }
    std::int64_t z = 0;
    for (Vertex v = 0; v < 2 * half_; ++v) {
      const bool lower = v < half_;
      at_.push_back({column_[v], row_[v], lower ? z : z + reach[v]});
      z += reach[v] + 1;
    }
  }

  Vertex half_;
  RandomStream random_;
  std::vector<std::int64_t> row_;
  std::vector<std::int64_t> column_;
  std::vector<std::uint8_t> taken_;
  std::vector<Point> at_;
  std::shared_ptr<std::vector<Edge>> edges_ = std::make_shared<std::vector<Edge>>();
};

TEST(Million, TallDrawingsBySlabs) {
  Guarantee guarantee;
  guarantee.max_degree = 3;
  guarantee.max_bends = 2;
  guarantee.angle_rule = AngleRule::at_least;
  guarantee.cosine = {-1, 2};
  guarantee.lattice = kScaledZLattice;
  CertifyOptions options;
  options.crossing_test = CrossingTest::slabs;
  options.check_size = false;
  for (const Vertex half : {500u, 5000u, 50000u, 500000u}) {
    const TallDrawing tall(half, 1);
    certify_and_print("tall, slabs", tall.graph(), tall.drawing(), guarantee, options);
  }
}

}  // namespace
}  // namespace ar3d::testing
