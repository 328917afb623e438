#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

#include "ar3d/bench/compare/commits.h"

namespace ar3d::testing {
namespace {

/// Searches with `culprit` as the first bad commit. @return how many commits were tried.
std::size_t search(Bisection& bisection, std::size_t culprit, std::size_t broken_from,
                   std::size_t broken_to) {
  std::size_t tried = 0;
  while (const auto next = bisection.next()) {
    ++tried;
    EXPECT_LT(tried, 1000U);
    if (*next >= broken_from && *next < broken_to) {
      bisection.skip(*next);
    } else if (*next >= culprit) {
      bisection.note_bad(*next);
    } else {
      bisection.note_good(*next);
    }
  }
  return tried;
}

TEST(Bisection, FindsEveryCulpritInLogarithmicallyManyTries) {
  for (std::size_t count = 1; count <= 40; ++count) {
    for (std::size_t culprit = 0; culprit < count; ++culprit) {
      Bisection bisection(count);
      const std::size_t tried = search(bisection, culprit, 0, 0);
      EXPECT_EQ(bisection.first(), culprit);
      EXPECT_EQ(bisection.last(), culprit);
      EXPECT_LE(tried, static_cast<std::size_t>(std::bit_width(count - 1))) << count;
    }
  }
}

TEST(Bisection, CommitsThatCannotBeTriedAreLeftWhereTheyMatter) {
  for (std::size_t culprit = 0; culprit < 16; ++culprit) {
    Bisection bisection(16);
    search(bisection, culprit, 5, 9);
    EXPECT_LE(bisection.first(), culprit);
    EXPECT_GE(bisection.last(), culprit);
    const bool is_hidden = culprit >= 5 && culprit <= 9;
    EXPECT_EQ(bisection.first() != bisection.last(), is_hidden) << culprit;
  }
}

}  // namespace
}  // namespace ar3d::testing
