// A drawing on several threads is the one on one thread, bit for bit. The plain walks are compared
// in diamond_interleaved_test.cpp.
#include <gtest/gtest.h>
#include <omp.h>

#include <string>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/algorithms/diamond/fast/fast.h"
#include "ar3d/bench/measure/cores.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/model/drawing.h"

namespace ar3d::testing {
namespace {

constexpr std::uint64_t kN = 140'000;  // threads are used from 2^17 on

TEST(DiamondThreads, AnyNumberOfThreadsDrawsTheSame) {
  const OneThread restore_afterwards;
  for (const char* family : {"random-4-regular", "torus", "square-grid"}) {
    const Graph graph = generate(find_family(family), kN, 1, {{"shuffle", 1}});
    for (const std::int64_t effort : {0, 1}) {
      std::string one;
      for (const int threads : {1, 2, 3, 7}) {
        omp_set_num_threads(threads);
        const std::string hash =
            drawing_hash(draw(find_algorithm("diamond"), graph, {{"effort", effort}}));
        if (threads == 1) one = hash;
        EXPECT_EQ(hash, one) << family << " effort " << effort << ", " << threads << " threads";
      }
    }
  }
}

TEST(DiamondThreads, WalksOfSeveralThreadsFindThePlainColours) {
  const Graph graph = generate(find_family("random-4-regular"), 20'000, 3, {{"shuffle", 1}});
  const diamond::PaddedNeighbours neighbours = diamond::padded_neighbours(graph);
  const diamond::TwoColouring plain =
      diamond::two_colouring(graph, neighbours, diamond::balanced_orientation(neighbours));
  for (const std::uint32_t threads : {1u, 2u, 5u}) {
    for (const std::uint32_t stride : {1u, 16u, 512u}) {
      const diamond::fast::WalkSizes sizes{.stride = stride, .lanes = 4, .threads = threads};
      const diamond::TwoColouring colouring = diamond::fast::colouring(graph, sizes);
      EXPECT_EQ(colouring, plain) << threads << " threads, stride " << stride;
    }
  }
}

}  // namespace
}  // namespace ar3d::testing
