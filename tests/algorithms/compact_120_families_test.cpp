// All families of the catalogue, with their own labels and with others, and unions.

#include <gtest/gtest.h>

#include "algorithms/compact_120_support.h"
#include "ar3d/generators/catalog.h"
#include "support/graphs.h"
#include "support/names.h"

namespace ar3d {
namespace {

using testing::compact_120_fault;

class Compact120Families : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(Compact120Families, AreCertifiedInEveryMode) {
  for (const Family& family : families()) {
    if (family.max_degree > 3) continue;
    for (const int shuffle : {0, 1}) {
      const Graph graph = generate(family, GetParam(), 7, {{"shuffle", shuffle}});
      for (const compact_120::Options& options : testing::compact_120_modes()) {
        EXPECT_EQ(compact_120_fault(graph, options), "")
            << family.name << " shuffle " << shuffle << " effort " << options.effort;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, Compact120Families, ::testing::Values(4, 12, 40, 150, 600),
                         testing::named("n"));

TEST(Compact120Families, OfFiveThousandVerticesAreCertified) {
  for (const char* name : {"random-cubic", "union-k4", "path", "prism"}) {
    EXPECT_EQ(compact_120_fault(generate(find_family(name), 5000, 3), compact_120::Options{}), "")
        << name;
  }
}

TEST(Compact120Families, ProofsZonesTriedInTurnAreCertified) {
  for (const Family& family : families()) {
    if (family.max_degree > 3) continue;
    const Graph graph = generate(family, 100, 5);
    EXPECT_EQ(compact_120_fault(graph, testing::draw_120_by_scans(graph)), "") << family.name;
  }
}

TEST(Compact120Unions, OfManyKindsAreCertified) {
  const Graph point(1, {});
  std::vector<Graph> parts;
  for (int round = 0; round < 12; ++round) {
    for (const Graph& part : {point, testing::complete(4), testing::path(7), testing::cycle(3),
                              testing::petersen(), testing::complete(2)}) {
      parts.push_back(part);
    }
  }
  const Graph graph = testing::shuffled(testing::disjoint_union(parts), 1);
  for (const compact_120::Options& options : testing::compact_120_modes()) {
    EXPECT_EQ(compact_120_fault(graph, options), "");
  }
}

}  // namespace
}  // namespace ar3d
