#include "ar3d/model/lattice.h"

#include <gtest/gtest.h>

#include "ar3d/model/error.h"
#include "ar3d/model/guarantee.h"
#include "ar3d/model/random.h"

namespace ar3d {
namespace {

constexpr Cosine kDiamond{-1, 3};
constexpr Cosine kHexagon{-1, 2};

TEST(Lattice, AnglesOfThePaperAreExact) {
  EXPECT_EQ(compare_cosine(kCubeLattice, {1, 1, 1}, {1, -1, -1}, kDiamond),
            std::strong_ordering::equal);
  EXPECT_EQ(compare_cosine(kCubeLattice, {1, -1, 0}, {-1, 0, 1}, kHexagon),
            std::strong_ordering::equal);
  EXPECT_EQ(compare_cosine(kTallLattice, {0, 0, -1}, {1, 0, 1}, kHexagon),
            std::strong_ordering::equal);
  EXPECT_EQ(compare_cosine(kTallLattice, {1, 0, -1}, {-1, 2, 1}, kHexagon),
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

TEST(Lattice, WideAndNarrowAgree) {
  RandomStream random(7);
  const auto number = [&] { return static_cast<std::int64_t>(random.below(41)) - 20; };
  for (int i = 0; i < 2000; ++i) {
    const Vector u{number(), number(), 21};
    const Vector v{number(), 21, number()};
    const auto narrow = compare_cosine(kTallLattice, u, v, kHexagon);
    // Scaling the lattice beyond the narrow path's Gram limit leaves angles alone.
    Lattice scaled = kTallLattice;
    for (auto& row : scaled.gram) {
      for (auto& g : row) g *= 1 << 10;
    }
    EXPECT_EQ(narrow, compare_cosine(scaled, u, v, kHexagon));
  }
}

TEST(Lattice, RefusesWhatIsNoMetric) {
  EXPECT_NO_THROW(kTallLattice.validate());
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
}  // namespace ar3d
