// Random numbers made in advance are those of the stream.
#include <gtest/gtest.h>

#include "ar3d/algorithms/strips/numbers_ahead.h"

namespace ar3d::strips {
namespace {

TEST(StripNumbers, OfBlocksAreThoseOfTheStream) {
  for (const std::uint64_t first :
       {std::uint64_t{0}, std::uint64_t{0xfffffffc}, std::uint64_t{1} << 40}) {
    for (const std::uint64_t seed : {std::uint64_t{1}, ~std::uint64_t{0}, std::uint64_t{1} << 33}) {
      std::array<std::uint32_t, 32> fast, plain;
      make_blocks(seed, seed / 3, first, fast.data());
      make_blocks_plainly(seed, seed / 3, first, plain.data());
      EXPECT_EQ(fast, plain) << first << " " << seed;
    }
  }
}

TEST(StripNumbers, GoOnBehindWhatWasTaken) {
  RandomStream stream(5, 9);
  NumbersAhead numbers(5, 9);
  RandomStream choice(1);
  for (int step = 0; step < 20000; ++step) {
    const std::size_t count = 1 + choice.below(NumbersAhead::kMostAhead);
    const std::uint32_t* ahead = numbers.ahead(count);
    const std::size_t taken = choice.below(static_cast<std::uint32_t>(count));
    for (std::size_t i = 0; i < taken; ++i) ASSERT_EQ(ahead[i], stream.next32());
    numbers.skip(taken);
    if (step % 7 == 0) {
      ASSERT_EQ(numbers.next32(), stream.next32());
    }
    const std::uint32_t bound = step % 3 == 0 ? 0xc0000000u : 1 + choice.below(1000);
    ASSERT_EQ(numbers.below(bound), stream.below(bound));
  }
}

}  // namespace
}  // namespace ar3d::strips
