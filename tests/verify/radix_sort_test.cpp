#include "ar3d/verify/crossings/radix_sort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "ar3d/base/random.h"

namespace ar3d::verify {
namespace {

/// Keys below `limit` in random order, numbered as they stand.
std::vector<Keyed> random_items(std::size_t count, std::uint64_t limit) {
  RandomStream random(7);
  std::vector<Keyed> items(count);
  for (std::size_t i = 0; i < count; ++i) {
    items[i] = {random.below64(limit), static_cast<std::uint32_t>(i)};
  }
  return items;
}

TEST(Order, SortsAsAStableSortDoes) {
  std::vector<Keyed> buffer;
  for (const std::size_t count : {0u, 1u, 255u, 256u, 5000u}) {
    for (const std::uint64_t limit :
         {std::uint64_t{1}, std::uint64_t{100}, std::uint64_t{1} << 11, std::uint64_t{1} << 40,
          std::numeric_limits<std::uint64_t>::max()}) {
      auto items = random_items(count, limit);
      auto expected = items;
      std::stable_sort(expected.begin(), expected.end(),
                       [](const Keyed& a, const Keyed& b) { return a.key < b.key; });
      sort_by_key(items, buffer);
      ASSERT_EQ(items.size(), expected.size());
      for (std::size_t i = 0; i < items.size(); ++i) {
        ASSERT_EQ(items[i].key, expected[i].key);
        ASSERT_EQ(items[i].item, expected[i].item);
      }
    }
  }
}

}  // namespace
}  // namespace ar3d::verify
