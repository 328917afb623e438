// The safe layout of Step 2.10: its lemmas one by one, the arithmetic of Lemma 2.18, and the
// promised box on every drawing that is forced to use it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "algorithms/two_bend_graphs.h"
#include "algorithms/two_bend_support.h"
#include "ar3d/algorithms/two_bend/layout.h"
#include "ar3d/algorithms/two_bend/leans.h"
#include "ar3d/generators/catalog.h"

namespace ar3d::testing {
namespace {

using two_bend::far_b;
using two_bend::far_gap;
using two_bend::lean_fits;
using two_bend::lean_turns;

TEST(TwoBendSafe, NearLeansFitFromGap8) {  // Lemma 2.13
  for (std::int64_t y = 6; y < 3000; ++y) EXPECT_TRUE(lean_fits(-1, y)) << y;
  EXPECT_FALSE(lean_fits(-1, 5));
}

TEST(TwoBendSafe, FarLeansFitFromSevenSixteenths) {  // Lemma 2.14
  const auto check = [](std::int64_t k, bool alone) {
    const std::int64_t b = far_b(k, alone);
    const std::int64_t gap = far_gap(k, alone);
    EXPECT_LT(2 * b, gap);
    for (std::int64_t distance = gap | 1; distance < gap + 400; distance += 2) {
      const std::int64_t y = distance - 2 * b;
      EXPECT_TRUE(alone ? lean_turns(k - b, y) : lean_fits(k - b, y)) << k << " " << distance;
    }
  };
  for (std::int64_t k = 2; k < 3000; k += 2) {
    check(k, true);
    check(k, false);
  }
  for (std::int64_t k = 4096; k < std::int64_t{1} << 30; k += k / 8 * 2) {
    check(k, true);
    check(k, false);
  }
}

/// The gap is not much larger than needed: an angle forbids y below 0.39 e.
TEST(TwoBendSafe, FarLeansFailFromThreeEighths) {
  for (std::int64_t e = 64; e < 100000; e += e / 5) EXPECT_FALSE(lean_turns(e, 3 * e / 8)) << e;
}

bool has_primitive_pair(std::int64_t x, std::int64_t y, const std::array<std::int64_t, 2>& room) {
  for (std::int64_t i = 0; i < room[1]; ++i) {
    for (std::int64_t j = 0; j < room[0]; ++j) {
      if (std::gcd(x + 2 * i, y + 2 * j) == 1) return true;
    }
  }
  return false;
}

/// Lemma 2.9 for few nodes, every odd pair in a part of the range; and where primes crowd.
TEST(TwoBendSafe, RoomOfVvEdgesHoldsAPrimitiveLean) {
  const auto small = two_bend::vv_room(400);
  const auto large = two_bend::vv_room(401);
  for (std::int64_t x = -701; x < 700; x += 2) {
    for (std::int64_t y = -701; y < 700; y += 2)
      ASSERT_TRUE(has_primitive_pair(x, y, small)) << x << " " << y;
  }
  RandomStream random(5);
  for (int i = 0; i < 20000; ++i) {
    std::int64_t x = 3 * 5 * 7;  // many small primes
    for (const std::int64_t p : {11, 13, 17, 19, 23, 29}) {
      if (random.chance(1, 2) && x * p < 200'000'000) x *= p;
    }
    const std::int64_t y = 2 * std::int64_t{random.below(100'000'000)} + 1;
    ASSERT_TRUE(has_primitive_pair(x, y, large)) << x << " " << y;
    if (x < 4900) {
      ASSERT_TRUE(has_primitive_pair(x, y, small)) << x << " " << y;
    }
  }
}

/// Lemma 2.15: gaps and spreads of a joint component come to rest below the stated bound.
TEST(TwoBendSafe, GapsOfTwoPolesComeToRest) {
  for (std::int64_t n = 6; n < 192; n += 2) {
    std::int64_t gap_rows = 8;
    std::int64_t gap_columns = 8;
    std::int64_t rows = 0;
    std::int64_t columns = 0;
    for (int round = 0; round < 60; ++round) {
      rows = 5 * n - 18 + gap_rows + 11;
      columns = 3 * n - 6 + gap_columns + 11;
      gap_rows = std::max(gap_rows, far_gap(columns / 2 * 2, true) + 1);
      gap_columns = std::max(gap_columns, far_gap(rows / 2 * 2, true) + 1);
    }
    EXPECT_LE(std::max(rows, columns), 8 * n + 10) << n;
    EXPECT_EQ(rows, 5 * n - 18 + gap_rows + 11) << n;
  }
}

/// The sums of Lemma 2.18, evaluated for every n: what its three cases prove for the height.
struct HeightSum {
  double rows, columns;              // lengths of the trees, without the gaps of moved rows
  double all_rows, all_columns;      // with them
  double moved_rows, moved_columns;  // squares of what moves, times the edges that pass over it
  double linear;
  double value(double n, double unit) const {
    return unit * (rows * rows + columns * columns) +
           1.5 * (all_rows * all_rows + all_columns * all_columns) + moved_rows + moved_columns +
           linear + 6 * n;
  }
};

double promise(double n) { return 1000 * n * n + 1000; }

TEST(TwoBendSafe, ArithmeticOfTheBoxHoldsForSmallJointComponents) {
  for (double n = 6; n < 192; n += 2) {
    const double y = 7.82 * n + 2;
    const double x = 6.43 * n + 10;
    const double edges = std::min(n / 2 - 3, std::log2(2.5 * n) + 4);
    const HeightSum sum{5 * n - 18,
                        3 * n - 6,
                        y,
                        x,
                        edges * std::pow(7 * x / 16 + 19, 2),
                        edges * std::pow(7 * y / 16 + 19, 2),
                        (n + 2) * (x + y)};
    EXPECT_LE(sum.value(n, 6), promise(n)) << n;
  }
}

TEST(TwoBendSafe, ArithmeticOfTheBoxHoldsForLargeJointComponents) {
  for (double n = 192; n < 1e8; n = std::ceil(n * 1.01)) {
    const double y = 8 * n + 78;
    const double x = 4 * n + 95;
    const double edges = std::log2(4 * n) + 4;
    const HeightSum sum{8 * n, 4 * n, y, x, edges * 82 * 82, edges * 99 * 99, (n + 2) * (x + y)};
    EXPECT_LE(sum.value(n, 6), promise(n)) << n;
  }
}

/// A component that is not joint, with a number of SINKs and perhaps a SOURCE.
HeightSum other_component(double n, double sinks, bool has_source) {
  const double y = n <= 400 ? 5 * n + 38 * sinks : 8 * n + 20 * sinks;
  const double x = n <= 400 ? 10 * n / 3 : 4 * n;
  HeightSum sum{};
  sum.rows = has_source ? y : y / 2;  // the factor 4 is for the unit of a SOURCE
  sum.columns = x;
  if (sinks > 0) {
    sum.all_rows = y;
    sum.moved_rows = 1800 * n;
  }
  if (has_source) {
    sum.all_columns = x + 56;
    sum.moved_columns = 1800 * n;
  }
  sum.linear = (8 * n / 7 + 1) * (x + 56 + y);
  return sum;
}

TEST(TwoBendSafe, ArithmeticOfTheBoxHoldsForOtherComponents) {
  double largest = 0;
  for (double n = 2; n < 1e8; n = std::ceil(n * 1.01)) {
    for (const bool has_source : {false, true}) {
      const double most = std::floor(n / 7) - (has_source ? 1 : 0);
      if (has_source && n < 14) continue;
      for (const double sinks : {0.0, std::min(1.0, most), std::min(2.0, most), most}) {
        const double value = other_component(n, sinks, has_source).value(n, 4);
        EXPECT_LE(value, promise(n)) << n << " " << sinks;
        largest = std::max(largest, value / promise(n));
      }
    }
  }
  EXPECT_GT(largest, 0.7);  // the constant is what the proof gives
  EXPECT_LT(largest, 0.8);
}

/// How far a forced safe layout uses the box: parts of n, n and n^2.
class Largest {
 public:
  void draw(const Graph& graph) {
    const std::vector<Counter> counters = expect_certified(graph, {.force_safe_layout = true});
    for (const Counter& counter : counters)
      safe_ += counter.name == "safe_rounds" ? counter.value : 0;
    const double n = graph.num_vertices();
    const auto extents = bounding_box(two_bend::draw(graph, {.force_safe_layout = true})).extents();
    for (std::size_t axis = 0; axis < 3; ++axis)
      of_[axis] = std::max(of_[axis], static_cast<double>(extents[axis]) / (axis < 2 ? n : n * n));
  }
  double operator[](std::size_t axis) const { return of_[axis]; }
  std::int64_t safe() const { return safe_; }

 private:
  std::array<double, 3> of_{};
  std::int64_t safe_ = 0;
};

TEST(TwoBendSafe, SafeLayoutKeepsTheBoxOfEverySmallGraph) {
  for (int n = 1; n <= 8; ++n) {
    for (const Graph& graph : geng(fmt::format("-D3 {}", n)))
      expect_certified(graph, {.force_safe_layout = true});
  }
}

/// Both poles in one block: the case that needs the largest gaps.
TEST(TwoBendSafe, SafeLayoutKeepsTheBoxOfCubicGraphs) {
  Largest largest;
  std::uint64_t seed = 0;
  for (const int n : {6, 8, 10, 12}) {
    for (const Graph& graph : geng(fmt::format("-c -d3 -D3 {}", n))) {
      for (int i = 0; i < 4; ++i) largest.draw(shuffled(graph, ++seed));
    }
  }
  EXPECT_GT(largest.safe(), 300);
  // Not vacuous: these drawings are a tenth of the promise wide and a hundredth of it high.
  EXPECT_GT(largest[0], 2.5);
  EXPECT_GT(largest[1], 2.5);
  EXPECT_GT(largest[2], 5);
}

TEST(TwoBendSafe, SafeLayoutKeepsTheBoxOfRandomGraphsAndFamilies) {
  Largest largest;
  for (std::uint64_t seed = 1; seed <= 300; ++seed)
    largest.draw(shuffled(random_graph_of_any_kind(20, seed), seed));
  for (const Family& family : families()) {
    if (family.max_degree > 3) continue;
    SCOPED_TRACE(family.name);
    for (const std::uint64_t n : {20u, 300u, 1000u}) largest.draw(generate(family, n, 1));
  }
  EXPECT_GT(largest.safe(), 400);
}

}  // namespace
}  // namespace ar3d::testing
