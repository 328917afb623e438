// Ids of nodes against a map.
#include "ar3d/formats/graphs/node_ids.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "ar3d/base/random.h"

namespace ar3d::testing {
namespace {

void expect_as_map(const std::vector<std::string>& texts) {
  NodeIds ids;
  std::map<std::string, Vertex> expected;
  for (const std::string& text : texts) {
    const auto next = static_cast<Vertex>(expected.size());
    ASSERT_EQ(ids.add(text), expected.emplace(text, next).second) << text;
    ASSERT_EQ(ids.size(), expected.size());
  }
  for (const auto& [text, number] : expected) ASSERT_EQ(ids.find(text), number) << text;
  for (const char* absent : {"n", "n00", "n99999999999", "x1", "n-1", "n1 ", "n4000000000"}) {
    EXPECT_EQ(ids.find(absent).has_value(), expected.contains(absent)) << absent;
  }
}

TEST(NodeIds, NumbersAndTextsOfAllKinds) {
  expect_as_map({});
  expect_as_map({"n0", "n1", "n2", "n1", "n3"});
  expect_as_map({"n1", "n01", "n001", "n", "n10", "n1", "n01", "", "1", ""});
  expect_as_map({"7", "8", "007", "7", "n7", "-7", "+7", "7.0"});
  expect_as_map({"n4000000000", "n0", "n4294967296", "n99999999999", "n18446744073709551616"});
  expect_as_map({"alpha", "beta", "alpha1", "alpha2", "beta", "alpha01"});
  expect_as_map({"v9v1", "v9v2", "v9v1", "v9", "v91"});
}

TEST(NodeIds, ShuffledAndSparseNumbers) {
  RandomStream random(3, 1);
  for (const std::uint32_t range : {50u, 3000u, 100000u, 4000000000u}) {
    std::vector<std::string> texts;
    for (int i = 0; i < 3000; ++i) texts.push_back("n" + std::to_string(random.below(range)));
    expect_as_map(texts);
  }
}

}  // namespace
}  // namespace ar3d::testing
