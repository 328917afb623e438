#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <string>

#include "ar3d/generators/catalog.h"

namespace ar3d {
namespace {

/// Sizes, seeds: small, and large enough that the fast paths of the generators are taken.
std::string hashes_of(const Family& family) {
  return fmt::format("{} {} {}", family.name, graph_hash(generate(family, 100, 1)),
                     graph_hash(generate(family, 5000, 2)));
}

/// The bytes of every family are part of the contract: whoever changes them changes this file and
/// the CHANGELOG.
TEST(Golden, EveryFamilyGivesTheRecordedGraphs) {
  std::ifstream file(AR3D_SOURCE_DIR "/tests/generators/golden_hashes.txt");
  std::map<std::string, std::string> recorded;
  for (std::string line; std::getline(file, line);) {
    recorded.emplace(line.substr(0, line.find(' ')), line);
  }
  for (const Family& family : families()) {
    EXPECT_EQ(hashes_of(family), recorded[family.name]);
    recorded.erase(family.name);
  }
  for (const auto& [name, line] : recorded) ADD_FAILURE() << "recorded, but no family: " << line;
}

}  // namespace
}  // namespace ar3d
