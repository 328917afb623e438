#include "ar3d/model/lattice.h"

#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <compare>
#include <cstdlib>

#include "ar3d/base/error.h"
#include "ar3d/base/random.h"
#include "ar3d/model/guarantee.h"

namespace ar3d::testing {
namespace {

constexpr Cosine kDiamond{-1, 3};
constexpr Cosine kHexagon{-1, 2};

TEST(Lattice, AnglesOfThePaperAreExact) {
  EXPECT_EQ(compare_cosine(kCubeLattice, {1, 1, 1}, {1, -1, -1}, kDiamond),
            std::strong_ordering::equal);
  EXPECT_EQ(compare_cosine(kCubeLattice, {1, -1, 0}, {-1, 0, 1}, kHexagon),
            std::strong_ordering::equal);
  EXPECT_EQ(compare_cosine(kScaledZLattice, {0, 0, -1}, {1, 0, 1}, kHexagon),
            std::strong_ordering::equal);
  EXPECT_EQ(compare_cosine(kScaledZLattice, {1, 0, -1}, {-1, 2, 1}, kHexagon),
            std::strong_ordering::equal);
  EXPECT_EQ(compare_cosine(kCubeLattice, {1, 0, 0}, {-1, 0, 0}, kHexagon),
            std::strong_ordering::less);
  EXPECT_EQ(compare_cosine(kCubeLattice, {1, 0, 0}, {0, 1, 0}, kHexagon),
            std::strong_ordering::greater);
  EXPECT_EQ(compare_cosine(kCubeLattice, {1, 0, 0}, {1, 0, 0}, {1, 1}),
            std::strong_ordering::equal);
}

TEST(Lattice, OneUnitOffIsSeenAtTheLargestCoordinates) {
  const std::int64_t big = (std::int64_t{1} << 61) - 1;
  EXPECT_EQ(compare_cosine(kCubeLattice, {big, big, big}, {big, -big, -big}, kDiamond),
            std::strong_ordering::equal);
  // Not a multiple of a short vector, so the widest integers decide.
  EXPECT_NE(compare_cosine(kCubeLattice, {big, big, big - 1}, {big, -big, -big}, kDiamond),
            std::strong_ordering::equal);
}

/// compare_cosine in 1024 bits only.
std::strong_ordering compare_wide(const Lattice& lattice, Vector u, Vector v, Cosine c) {
  using Wide = boost::multiprecision::checked_int1024_t;
  const auto inner = [&](Vector a, Vector b) {
    const std::array<std::int64_t, 3> p{a.x, a.y, a.z};
    const std::array<std::int64_t, 3> q{b.x, b.y, b.z};
    Wide sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) sum += Wide(p[i]) * lattice.gram[i][j] * q[j];
    }
    return sum;
  };
  const auto signed_square = [](const Wide& w) { return w < 0 ? Wide(-w * w) : Wide(w * w); };
  // p / sqrt(uu vv) against num / den: both sides times den sqrt(uu vv), then squared with sign.
  const Wide left = signed_square(inner(u, v) * c.denominator);
  const Wide right = inner(u, u) * inner(v, v) * signed_square(Wide(c.numerator));
  return left < right   ? std::strong_ordering::less
         : left > right ? std::strong_ordering::greater
                        : std::strong_ordering::equal;
}

TEST(Lattice, WideAndNarrowAgree) {
  RandomStream random(7);
  const auto number = [&](unsigned bits) {
    const auto drawn =
        (std::uint64_t{random.below(1u << 31)} << 31 | random.below(1u << 31)) >> (62 - bits);
    return random.chance(1, 2) ? static_cast<std::int64_t>(drawn)
                               : -static_cast<std::int64_t>(drawn);
  };
  int equal = 0;
  for (int i = 0; i < 20000; ++i) {
    const unsigned a = 1 + random.below(61);
    const unsigned b = i % 2 == 0 ? a : 1 + random.below(61);
    Vector u{number(a), number(a), number(a)};
    Vector v{number(b), number(b), number(b)};
    if (i % 4 == 0) {  // exactly 120 degrees in the tall lattice, or nearly
      const std::int64_t k = std::abs(number(a)) + 1;
      u = {0, 0, -k};
      v = {k, 0, i % 8 == 0 ? k : k - 1};
    }
    if (u == Vector{} || v == Vector{}) continue;
    for (const Cosine c : {kHexagon, kDiamond, Cosine{1, 1}, Cosine{0, 1}, Cosine{-30, 31}}) {
      ASSERT_EQ(compare_cosine(kScaledZLattice, u, v, c), compare_wide(kScaledZLattice, u, v, c))
          << to_string(u) << to_string(v) << c.numerator;
    }
    equal += compare_cosine(kScaledZLattice, u, v, kHexagon) == 0;
  }
  EXPECT_GT(equal, 2000);
}

TEST(Lattice, RefusesWhatIsNoMetric) {
  EXPECT_NO_THROW(kScaledZLattice.validate());
  EXPECT_THROW((Lattice{{{{1, 1, 0}, {0, 1, 0}, {0, 0, 1}}}, 1}.validate()), InputError);
  EXPECT_THROW((Lattice{{{{1, 2, 0}, {2, 1, 0}, {0, 0, 1}}}, 1}.validate()), InputError);
  EXPECT_THROW((Lattice{kCubeLattice.gram, 0}.validate()), InputError);
}

TEST(AxisBound, DecidesExactly) {
  const AxisBound third = linear(16, 3);
  EXPECT_TRUE(third.holds(16, 3));
  EXPECT_FALSE(third.holds(17, 3));
  EXPECT_EQ(third.formula(), "16/3 n");
  const AxisBound root = sqrt_n(3) + 2;
  EXPECT_TRUE(root.holds(11, 9));
  EXPECT_FALSE(root.holds(12, 9));
  EXPECT_EQ(root.formula(), "3 sqrt(n) + 2");
  EXPECT_EQ((quadratic(64) + 64).formula(), "64 n^2 + 64");
  EXPECT_EQ(cubic(1).formula(), "n^3");
  EXPECT_TRUE(quadratic(64).holds(64 * 25, 5));
  EXPECT_FALSE(quadratic(64).holds(64 * 25 + 1, 5));
  const AxisBound ninth{.numerator = 1, .half_power = 18};
  EXPECT_TRUE(ninth.holds(std::int64_t{1} << 61, 1u << 31));
}

}  // namespace
}  // namespace ar3d::testing
