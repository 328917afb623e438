// Algorithm `grid` (Theorem 3): named graphs, unions, the rules of its invariant.
#include "ar3d/algorithms/grid/grid.h"

#include "algorithms/grid_checks.h"
#include "ar3d/algorithms/grid/number_search.h"
#include "ar3d/algorithms/grid/planes.h"
#include "ar3d/base/random.h"
#include "ar3d/generators/catalog.h"
#include "support/graphs.h"

namespace ar3d::testing {
namespace {

using grid::Planes;

bool is_valid(const Graph& graph, const Drawing& drawing) {
  return certify(graph, drawing, find_algorithm("grid").guarantee).valid();
}

TEST(Grid, NumberSetAgreesWithAPlainSet) {
  RandomStream random(5);
  grid::NumberSet set(64);
  std::vector<bool> plain(4000, false);
  for (int i = 0; i < 6000; ++i) {
    const auto x = static_cast<std::int64_t>(random.below(2000)) - (i % 3 == 0 ? 1000 : 400);
    const auto at = static_cast<std::size_t>(x + 2000);
    EXPECT_EQ(set.insert(x), !plain[at]);
    plain[at] = true;
    const auto y = static_cast<std::int64_t>(random.below(3000)) - 1500;
    std::int64_t up = y;
    while (plain[static_cast<std::size_t>(up + 2000)]) ++up;
    std::int64_t down = y;
    while (plain[static_cast<std::size_t>(down + 2000)]) --down;
    ASSERT_EQ(set.next_outside(y), up);
    ASSERT_EQ(set.previous_outside(y), down);
    for (int j = 0; j < 64; ++j) {
      ASSERT_EQ((set.window(y) >> j) & 1, plain[static_cast<std::size_t>(y + j + 2000)] ? 1u : 0u);
    }
  }
}

TEST(Grid, PairsOfANumberSetAreItsNumbersAndTheirPredecessors) {
  RandomStream random(6);
  grid::NumberSet set(64);
  for (const std::int64_t x : {-128, -64, 0, 63, 127}) set.insert(x);  // borders of words
  for (int i = 0; i < 100; ++i) set.insert(static_cast<std::int64_t>(random.below(250)) - 125);
  const grid::NumberSet pairs = set.pairs();
  for (std::int64_t x = -600; x < 600; ++x) {
    ASSERT_EQ(pairs.contains(x), set.contains(x) || set.contains(x + 1)) << x;
    std::int64_t next = x;
    while (set.contains(next) || set.contains(next + 1)) ++next;
    ASSERT_EQ(pairs.next_outside(x), next) << x;
  }
}

TEST(Grid, DrawsTheGraphWithoutVertices) { EXPECT_EQ(grid::draw(Graph()).num_vertices(), 0u); }

TEST(Grid, FamiliesAreCertifiedAtEveryEffort) {
  for (const Family& family : families()) {
    for (const std::uint64_t n : {1u, 40u, 300u}) {
      const Graph graph = shuffled(generate(family, n, 3), n);
      if (graph.max_degree() > 3) continue;
      for (const int effort : {0, 1}) {
        ASSERT_EQ(grid_fault(graph, effort), "") << family.name << " n = " << n;
      }
    }
  }
}

TEST(Grid, UnionsOfSmallPiecesHitEveryCase) {
  CounterSums counts;
  const std::vector<Graph> cubic = geng("-c -d3 -D3 10");
  const std::vector<Graph> open = geng("-c -D3 7");
  RandomStream random(11);
  for (std::uint64_t i = 0; i < 300; ++i) {
    std::vector<Graph> parts = {Graph(random.below(3), {}), complete(4)};
    for (int j = 0; j < 4; ++j) {
      const auto& list = random.chance(1, 2) ? cubic : open;
      parts.push_back(list[random.below(static_cast<std::uint32_t>(list.size()))]);
    }
    const Graph graph = shuffled(disjoint_union(parts), i);
    ASSERT_EQ(grid_fault(graph, static_cast<std::int64_t>(i % 2), &counts), "");
  }
  expect_all_hit(counts);
}

TEST(Grid, InvariantHoldsOnFamiliesAndSmallGraphs) {
  std::vector<Graph> graphs = geng("-D3 7");
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    graphs.push_back(generate(find_family("random-cubic"), 2000, seed));
    const Planes planes = core_planes(graphs.back());
    EXPECT_TRUE(planes.counts.nt > 0 && planes.counts.pq > 0);
  }
  for (const Family& family : families()) {
    if (family.max_degree <= 3) graphs.push_back(shuffled(generate(family, 1000, 2), 3));
  }
  for (const Graph& graph : graphs) {
    EXPECT_EQ(grid::broken_invariant(graph, core_planes(graph)), "");
    EXPECT_EQ(grid::broken_invariant(graph, planes_of(graph, {})), "");
  }
}

TEST(Grid, InvariantHoldsForFlatNumbersWithManyDefects) {
  std::int64_t defects = 0;
  for (const char* family :
       {"random-cubic", "cubic-tree", "goldberg-snark", "union-flower-snark", "mixed-union"}) {
    for (const std::uint64_t longest_chain : {0u, 8u, 1000000u}) {
      const Graph graph = shuffled(generate(find_family(family), 2000, 2), 3);
      const Planes planes = planes_of(graph, {.longest_chain = longest_chain});
      EXPECT_EQ(grid::broken_invariant(graph, planes), "") << family;
      defects += planes.counts.flat_defects;
    }
  }
  EXPECT_GT(defects, 3000);
}

TEST(Grid, ColouredGraphsGetAFlatBox) {
  for (const char* family : {"random-cubic", "prism", "binary-tree", "union-k4", "cycle"}) {
    const Graph graph = shuffled(generate(find_family(family), 3000, 3), 8);
    const Drawing drawing = grid::draw(graph);
    EXPECT_EQ(counter_of(drawing, "flat_defects"), 0) << family;
    EXPECT_EQ(counter_of(drawing, "core_parts"), 0) << family;
    const auto extents = bounding_box(drawing).extents();
    EXPECT_LE(*std::ranges::min_element(extents), 300) << family;
  }
}

TEST(Grid, EveryFamilyKeepsItsVolumeAtTenThousandVertices) {
  for (const Family& family : families()) {
    const Graph graph = shuffled(generate(family, 10000, 2), 4);
    if (graph.max_degree() > 3 || graph.num_vertices() < 5000) continue;
    double volume = 1;
    for (const std::int64_t extent : bounding_box(grid::draw(graph)).extents()) {
      volume *= static_cast<double>(extent) / graph.num_vertices();
    }
    EXPECT_LE(volume, 100) << family.name;
  }
}

TEST(Grid, ComponentsWithoutFlatNumbersAreLeftToTheCore) {
  const Graph graph =
      shuffled(disjoint_union({generate(find_family("random-cubic"), 2000, 1), petersen(),
                               complete(4), generate(find_family("cubic-tree"), 40, 1)}),
               9);
  const Planes planes = planes_of(graph, {.flat_allowance = -150});  // none for n < 75
  EXPECT_EQ(planes.counts.core_parts, 3);
  EXPECT_EQ(grid::broken_invariant(graph, planes), "");
  EXPECT_TRUE(is_valid(graph, drawing_of(graph, planes)));
}

TEST(Grid, SnarksKeepADefectAndFlatNumbers) {
  for (const Graph& graph : {petersen(), generate(find_family("flower-snark"), 100, 0)}) {
    const Drawing drawing = grid::draw(graph);  // no proper edge colouring with three colours
    EXPECT_GE(counter_of(drawing, "flat_defects"), 2);
    EXPECT_EQ(counter_of(drawing, "core_parts"), 0);
  }
}

}  // namespace
}  // namespace ar3d::testing
