// A routed drawing on several threads is the one on one thread, bit for bit, counters included.
#include <gtest/gtest.h>
#include <omp.h>

#include "ar3d/algorithms/routed/routed.h"
#include "ar3d/bench/measure/cores.h"
#include "ar3d/generators/catalog.h"

namespace ar3d::testing {
namespace {

TEST(RoutedThreads, AnyNumberOfThreadsDrawsTheSame) {
  const OneThread restore_afterwards;
  const Graph graph = generate(find_family("random-4-regular"), 250, 1);
  omp_set_num_threads(1);
  const Drawing one = routed::draw_109(graph, {.effort = 0, .bends = 5});
  for (const int threads : {2, 4}) {
    omp_set_num_threads(threads);
    const Drawing other = routed::draw_109(graph, {.effort = 0, .bends = 5});
    EXPECT_EQ(drawing_hash(other), drawing_hash(one)) << threads << " threads";
    EXPECT_EQ(other.counters, one.counters) << threads << " threads";
  }
}

}  // namespace
}  // namespace ar3d::testing
