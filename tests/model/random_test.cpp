#include "ar3d/base/random.h"

#include <gtest/gtest.h>

#include <vector>

namespace ar3d::testing {
namespace {

TEST(RandomStream, GoldenNumbers) {
  RandomStream random(1, 2);
  const std::vector<std::uint32_t> first = {random.next32(), random.next32(), random.next32()};
  RandomStream again(1, 2);
  again.seek(2);
  EXPECT_EQ(again.next32(), first[2]);
  again.seek(0);
  EXPECT_EQ(again.next32(), first[0]);
  // Philox4x32-10 of the zero key and counter, from the Random123 distribution's known answers.
  RandomStream zero(0, 0);
  EXPECT_EQ(zero.next32(), 0x6627e8d5u);
  EXPECT_EQ(zero.next32(), 0xe169c58du);
  EXPECT_EQ(zero.next32(), 0xbc57ac4cu);
  EXPECT_EQ(zero.next32(), 0x9b00dbd8u);
}

TEST(RandomStream, BelowIsInRangeAndEven) {
  RandomStream random(5);
  std::vector<int> count(6, 0);
  for (int i = 0; i < 60000; ++i) ++count[random.below(6)];
  for (const int c : count) EXPECT_NEAR(c, 10000, 500);
  for (int i = 0; i < 1000; ++i)
    EXPECT_LT(random.below64(std::uint64_t{3} << 40), std::uint64_t{3} << 40);
  EXPECT_EQ(random.below(1), 0u);
}

}  // namespace
}  // namespace ar3d::testing
