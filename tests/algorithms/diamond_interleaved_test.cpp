// Steps 1.1 and 1.2 by many walks at the same time against the plain walks: the same colouring and
// the same items, for every way of cutting.
#include <gtest/gtest.h>

#include <vector>

#include "ar3d/algorithms/diamond/fast/fast.h"
#include "ar3d/generators/catalog.h"

namespace ar3d::testing {
namespace {

using namespace diamond;
using fast::WalkSizes;

std::vector<WalkSizes> sizes() {
  return {{.stride = 1, .lanes = 1},
          {.stride = 2, .lanes = 3},
          {.stride = 4, .lanes = 40},
          {.stride = 8, .lanes = 2},
          {.stride = 32, .lanes = 8},
          {.stride = 128, .lanes = 1},
          {.stride = 64, .lanes = 5},
          {.stride = 8192, .lanes = 4},
          {.stride = 1, .lanes = 2, .threads = 2},
          {.stride = 4, .lanes = 3, .threads = 3},
          {.stride = 8192, .lanes = 3, .threads = 3}};
}

void expect_equal(const Items& a, const Items& b) {
  ASSERT_EQ(a.vertex, b.vertex);
  ASSERT_EQ(a.edge, b.edge);
  ASSERT_EQ(a.begin, b.begin);
}

void expect_plain_result(const Graph& graph, const WalkSizes& sizes) {
  const PaddedNeighbours neighbours = padded_neighbours(graph);
  const TwoColouring plain = two_colouring(graph, neighbours, balanced_orientation(neighbours));
  const TwoColouring interleaved = fast::colouring(graph, sizes);
  for (const Colour c : {kGreen, kRed}) {
    ASSERT_EQ(plain[c], interleaved[c]);
    ASSERT_NO_FATAL_FAILURE(expect_equal(extract_items(plain[c]), fast::items(plain[c], sizes)));
  }
}

Graph graph_of(const Family& family, std::uint64_t n, std::uint64_t seed, bool shuffled) {
  Settings given;
  if (shuffled) given.push_back({"shuffle", 1});
  return generate(family, family.nearest_n(n, complete_parameters(family, given)), seed, given);
}

TEST(Interleaved, EveryFamilyInItsOwnOrderAndShuffled) {
  int graphs = 0;
  for (const Family& family : families()) {
    if (family.max_degree > 4) continue;
    for (const std::uint64_t n : {1, 6, 60, 400}) {
      for (const bool shuffled : {false, true}) {
        const Graph graph = graph_of(family, n, n, shuffled);
        if (graph.num_vertices() > 5000) continue;
        ++graphs;
        for (const WalkSizes& s : sizes()) {
          ASSERT_NO_FATAL_FAILURE(expect_plain_result(graph, s))
              << family.name << " " << n << " " << shuffled << " stride " << s.stride;
        }
      }
    }
  }
  EXPECT_GT(graphs, 300);
}

TEST(Interleaved, LargeGraphsWithTheSizesThatAreUsed) {
  for (const char* name : {"random-4-regular", "random-cubic", "percolated-diamond-lattice"}) {
    ASSERT_NO_FATAL_FAILURE(expect_plain_result(graph_of(find_family(name), 60000, 3, true), {}))
        << name;
  }
}

TEST(Interleaved, ManySmallRandomGraphs) {
  const Family& family = find_family("random-4-regular");
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Graph graph = graph_of(family, 5 + seed % 40, seed, false);
    for (const WalkSizes& s : sizes()) {
      ASSERT_NO_FATAL_FAILURE(expect_plain_result(graph, s)) << seed;
    }
  }
}

}  // namespace
}  // namespace ar3d::testing
