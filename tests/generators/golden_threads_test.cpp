#include <fmt/format.h>
#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <string>

#include "ar3d/generators/catalog.h"

namespace ar3d::testing {
namespace {

// The bytes of every family are part of the contract: a change of them changes
// golden_hashes.txt and the CHANGELOG. The race build runs these tests, too: compiled with clang++,
// the other builds with g++, so the recorded hashes hold for both.

/// Large enough that the generators and Graph share their work among threads.
constexpr std::uint64_t kLarge = 150000;

/// Sizes, seeds: small, and large enough that the fast paths of the generators are taken; random
/// families at kLarge, too.
std::string hashes_of(const Family& family) {
  std::string line = fmt::format("{} {} {}", family.name, graph_hash(generate(family, 100, 1)),
                                 graph_hash(generate(family, 5000, 2)));
  if (family.is_random) line += fmt::format(" {}", graph_hash(generate(family, kLarge, 3)));
  return line;
}

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

/// Graph's rows, too, are the same: their order is that of the edges.
void expect_equal(const Graph& a, const Graph& b) {
  ASSERT_EQ(graph_hash(a), graph_hash(b));
  for (Vertex v = 0; v < a.num_vertices(); ++v) {
    const auto row = a.incident(v);
    ASSERT_TRUE(std::equal(row.begin(), row.end(), b.incident(v).begin(), b.incident(v).end()));
  }
}

TEST(Golden, RandomGraphsAreTheSameOnAnyNumberOfThreads) {
  const int threads = omp_get_max_threads();
  for (const Family& family : families()) {
    if (!family.is_random) continue;
    SCOPED_TRACE(family.name);
    omp_set_num_threads(1);
    const Graph alone = generate(family, kLarge, 3);
    for (const int many : {2, 3, 4}) {
      omp_set_num_threads(many);
      expect_equal(generate(family, kLarge, 3), alone);
    }
  }
  omp_set_num_threads(threads);
}

}  // namespace
}  // namespace ar3d::testing
