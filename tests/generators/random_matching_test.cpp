#include "ar3d/generators/random_matching.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace ar3d::testing {
namespace {

constexpr std::uint32_t kInBuckets = 70000;  // more than one bucket holds

TEST(RandomPermutation, HoldsEveryNumberOnce) {
  for (const std::uint32_t count : {0u, 1u, 2u, 1000u, 65536u, 65537u, 600001u}) {
    RandomStream random(count);
    std::vector<int> seen(count, 0);
    for (const std::uint32_t number : random_permutation(count, random)) ++seen.at(number);
    EXPECT_EQ(seen, std::vector<int>(count, 1));
  }
}

/// Where a number comes to stand is uniform, and so is the order of two numbers: by eighths of the
/// permutation, chi-square of the 64 places of the numbers 0 and 1 over 640 permutations.
TEST(RandomPermutation, PlacesInBucketsAreUniform) {
  std::array<double, 64> seen{};
  constexpr int kSamples = 640;
  RandomStream random(5);
  int ascending = 0;
  for (int i = 0; i < kSamples; ++i) {
    const auto numbers = random_permutation(kInBuckets, random);
    std::array<std::uint32_t, 2> place{};
    for (std::uint32_t p = 0; p < kInBuckets; ++p) {
      if (numbers[p] < 2) place[numbers[p]] = p;
    }
    ++seen[8 * (8ull * place[0] / kInBuckets) + 8ull * place[1] / kInBuckets];
    ascending += place[0] < place[1] ? 1 : 0;
  }
  double chi_square = 0;
  for (const double count : seen) chi_square += (count - 10) * (count - 10) / 10;
  EXPECT_LT((chi_square - 63) / std::sqrt(2 * 63.0), 4.0);
  EXPECT_NEAR(ascending, kSamples / 2.0, 4 * std::sqrt(kSamples / 4.0));
}

TEST(RandomMatching, IsAnInvolutionWithoutFixedPoints) {
  for (const std::uint32_t count : {2u, 600u, kInBuckets, 600000u}) {
    RandomStream random(count);
    const auto partner = random_matching(count, random);
    for (std::uint32_t p = 0; p < count; ++p) {
      ASSERT_NE(partner[p], p);
      ASSERT_EQ(partner[partner[p]], p);
    }
  }
}

}  // namespace
}  // namespace ar3d::testing
