// Memory of long arrays: used again inside a LongArrayReuse, and never seen through by a vector.
#include "ar3d/base/long_vector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <thread>

namespace ar3d::testing {
namespace {

constexpr std::size_t kLong = 2 * kLongArrayBytes;

using Bytes = LongVector<std::uint8_t>;

/// Where an array has been, full of sevens.
const void* freed_place(std::size_t size) {
  std::optional<Bytes> dirty(std::in_place, size, 7);
  const void* const place = dirty->data();
  dirty.reset();
  return place;
}

bool is_all(const Bytes& bytes, std::uint8_t value) {
  return std::all_of(bytes.begin(), bytes.end(), [&](std::uint8_t b) { return b == value; });
}

TEST(LongArrayReuse, GivesWhatIsFreedToTheNextArrayThatFits) {
  const LongArrayReuse reuse;
  const void* const place = freed_place(kLong);
  const Bytes shorter(kLong * 3 / 4, 1);
  EXPECT_EQ(shorter.data(), place);
  EXPECT_TRUE(is_all(shorter, 1));
}

TEST(LongVector, GrowsThroughEveryKindOfMemory) {
  LongVector<std::uint32_t> numbers;
  constexpr std::uint32_t kCount = 3'000'000;
  for (std::uint32_t i = 0; i < kCount; ++i) numbers.push_back(i);
  for (std::uint32_t i = 0; i < kCount; ++i) ASSERT_EQ(numbers[i], i);
}

/// From the shortest arrays that are given again on, below 4 MiB too.
TEST(LongArrayReuse, InitialisesElementsInUsedMemory) {
  for (const std::size_t size : {kReusableBytes, kLong}) {
    const LongArrayReuse reuse;
    const void* const place = freed_place(size);
    const Bytes clean(size);
    EXPECT_EQ(clean.data(), place) << size;
    EXPECT_TRUE(is_all(clean, 0)) << size;
  }
}

TEST(LongArrayReuse, LeavesMuchLongerArraysForOthers) {
  const LongArrayReuse reuse;
  const void* const place = freed_place(4 * kLong);
  const Bytes much_shorter(kLong, 1);
  EXPECT_NE(much_shorter.data(), place);
  const Bytes longer(5 * kLong, 1);
  EXPECT_NE(longer.data(), place);
}

TEST(LongArrayReuse, ArraysMayOutliveItAndInnerOnesEndNothing) {
  Bytes kept;
  {
    const LongArrayReuse reuse;
    const void* const place = [] {
      const LongArrayReuse inner;
      return freed_place(kLong);
    }();
    kept.assign(kLong, 3);
    EXPECT_EQ(kept.data(), place);
  }
  EXPECT_TRUE(is_all(kept, 3));
}

TEST(LongArrayReuse, TakesArraysOfOtherThreads) {
  const LongArrayReuse reuse;
  Bytes theirs;
  std::thread([&] { theirs.assign(kLong, 5); }).join();
  EXPECT_TRUE(is_all(theirs, 5));
  const std::uint8_t* const place = theirs.data();
  theirs = Bytes();
  const Bytes ours(kLong, 6);
  EXPECT_EQ(ours.data(), place);
  Bytes gone(kLong, 4);
  std::thread([array = std::move(gone)] { EXPECT_TRUE(is_all(array, 4)); }).join();
}

// More arrays than there is room for are given back.
TEST(LongArrayReuse, KeepsNoMoreThanItHasRoomFor) {
  const LongArrayReuse reuse;
  std::vector<Bytes> many;
  for (int i = 0; i < 100; ++i) many.emplace_back(kLongArrayBytes);
  many.clear();
  EXPECT_TRUE(is_all(Bytes(kLongArrayBytes), 0));
}

}  // namespace
}  // namespace ar3d::testing
