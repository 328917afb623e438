// Algorithm `grid-paper` (Theorem 3 as the paper builds it): small graphs under every setting,
// families, unions, its stages against plain searches, each repair left out.
#include "ar3d/algorithms/grid_paper/grid_paper.h"

#include <fmt/format.h>

#include <algorithm>

#include "algorithms/grid_paper_support.h"
#include "ar3d/algorithms/catalog.h"
#include "ar3d/algorithms/grid_paper/builder.h"
#include "ar3d/base/random.h"
#include "verify/draft.h"

namespace ar3d::testing {
namespace {

using grid_paper::GrowthStage;
using grid_paper::Options;
using grid_paper::RepairSwitches;
using grid_paper::Spread;

TEST(GridPaper, AllSmallGraphsUnderEverySettingAreCertified) {
  CounterSums sums;
  for (int n = 1; n <= 7; ++n) {
    for (const Graph& graph : geng(fmt::format("-D3 {}", n))) {
      for (const Options& options : all_grid_paper_options()) {
        ASSERT_EQ(grid_paper_fault(graph, options), "") << "n = " << n;
      }
      for (const std::uint64_t seed : {1u, 2u, 3u}) {
        ASSERT_EQ(grid_paper_fault(graph, {}, {.random_cycles = seed}, &sums), "");
      }
    }
  }
  for (const char* name : {"connections", "middles", "moved", "same_cycle", "three_of_cycle",
                           "past_layer", "k4s", "merges", "threes", "ways_down", "spread"}) {
    EXPECT_GT(sums[name], 0) << name;
  }
  EXPECT_EQ(grid_paper_fault(Graph()), "");
}

TEST(GridPaper, ConnectedCubicGraphsRelabelledAndWithRandomCycles) {
  std::uint64_t seed = 0;
  for (int n = 4; n <= 10; n += 2) {
    for (const Graph& graph : geng(fmt::format("-c -d3 -D3 {}", n))) {
      const Graph other = shuffled(graph, ++seed);
      for (const Options& options : all_grid_paper_options()) {
        ASSERT_EQ(grid_paper_fault(other, options), "");
      }
      ASSERT_EQ(grid_paper_fault(other, {Spread::least, true}, {.random_cycles = seed}), "");
    }
  }
}

TEST(GridPaper, FamiliesAreCertified) {
  for (const Family& family : families()) {
    if (family.max_degree > 3) continue;
    for (const std::uint64_t n : {1u, 40u, 200u}) {
      const Graph graph = shuffled(generate(family, n, 3), n);
      for (const Options& options :
           {Options{}, Options{Spread::columns, false, true}, Options{Spread::least, true}}) {
        ASSERT_EQ(grid_paper_fault(graph, options), "") << family.name << " n = " << n;
      }
    }
  }
}

TEST(GridPaper, UnionsOfSmallPieces) {
  const std::vector<Graph> cubic = geng("-c -d3 -D3 8");
  const std::vector<Graph> open = geng("-c -D3 6");
  RandomStream random(11);
  for (std::uint64_t i = 0; i < 60; ++i) {
    std::vector<Graph> parts = {Graph(random.below(3), {}), complete(4), path(2)};
    for (int j = 0; j < 4; ++j) {
      const auto& list = random.chance(1, 2) ? cubic : open;
      parts.push_back(list[random.below(static_cast<std::uint32_t>(list.size()))]);
    }
    ASSERT_EQ(grid_paper_fault(shuffled(disjoint_union(parts), i)), "");
  }
}

/// By hand: planes 0, 4 and 2, all lines even, the fourth vertex by Step G.11.
TEST(GridPaper, DrawsK4AsTheStepsSay) {
  const Drawing drawing = grid_paper::draw(complete(4));
  const std::vector<std::vector<Point>> polylines = {
      {{-1, 3, 4}, {-1, -1, 0}, {-3, -3, 0}, {-4, -3, 1}, {-4, -2, 2}},
      {{-1, 3, 4}, {-5, 3, 8}, {-7, 1, 8}, {-7, 0, 7}, {-6, 0, 6}},
      {{-1, 3, 4}, {0, 4, 4}, {1, 4, 5}, {1, 3, 6}, {0, 2, 6}},
      {{-4, -2, 2}, {-6, -2, 4}, {-6, 0, 6}},
      {{-4, -2, 2}, {-3, -1, 2}, {-1, -1, 4}, {0, 0, 4}, {0, 2, 6}},
      {{-6, 0, 6}, {-5, 1, 6}, {-3, 1, 8}, {-2, 2, 8}, {0, 2, 6}}};
  for_each_polyline(drawing, [&](EdgeId e, const std::vector<Point>& points) {
    EXPECT_EQ(points, polylines[e]) << e;
  });
}

TEST(GridPaper, RefusesWhatIsNotProved) {
  EXPECT_THROW(grid_paper::draw(octahedron()), InputError);
  EXPECT_THROW(grid_paper::draw(Graph(grid_paper::kMostVertices + 1, {})), InputError);
  const double n = grid_paper::kMostVertices;
  EXPECT_LT((4 * n * n * n + 11 * n * n + 7 * n) / 3 + 2 * n + 4 * n * n + 11 * n,
            static_cast<double>(kMaxCoordinate))
      << "y + z as Lemma G.5 has them";
}

TEST(GridPaper, TheCatalogueRowTakesEveryOptionAndIsNotMeantByAll) {
  const Algorithm& row = find_algorithm("grid-paper");
  for (const Algorithm* named : proved_algorithms()) EXPECT_NE(named->name, row.name);
  EXPECT_EQ(row.guarantee.claim, Claim::proved);
  const Graph graph = generate(find_family("random-cubic"), 40, 1);
  const auto hash = [&](const Settings& options) {
    return drawing_hash(draw(row, graph, options));
  };
  EXPECT_EQ(hash({}), hash({{"spread", 1}, {"gap", 0}, {"cycle", 0}}));
  for (const Settings& options : {Settings{{"spread", 0}}, Settings{{"spread", 2}},
                                  Settings{{"gap", 1}}, Settings{{"cycle", 1}}}) {
    EXPECT_NE(hash({}), hash(options)) << settings_text(options);
  }
  EXPECT_THROW(draw(row, graph, {{"spread", 3}}), InputError);
}

/// The text's extents are a part of the drawing's: the skewed box holds all points.
TEST(GridPaper, SkewedExtentsAreThoseOfTheDrawing) {
  const Graph graph = generate(find_family("random-cubic"), 60, 2);
  const Drawing drawing = grid_paper::draw(graph);
  GrowingBox doubled;
  for_each_polyline(drawing, [&](EdgeId, const std::vector<Point>& points) {
    for (const Point p : points) {
      doubled.add({p.y + p.z - p.x, p.x + p.y - p.z, p.x + p.z - p.y});
    }
  });
  const auto extents = doubled.box().extents();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(2 * drawing.counters[axis].value, extents[axis]) << drawing.counters[axis].name;
  }
}

/// Length of a shortest cycle of what is outside, by searching from every vertex; 0 if none.
std::size_t plain_girth(const Graph& graph, const std::vector<bool>& gone) {
  const std::size_t n = graph.num_vertices();
  std::size_t girth = 0;
  for (const Edge e : graph.edges()) {  // a shortest way between its ends without it
    if (gone[e.u] || gone[e.v]) continue;
    std::vector<std::size_t> depth(n, n);
    std::vector<Vertex> reached{e.u};
    depth[e.u] = 0;
    for (std::size_t i = 0; i < reached.size(); ++i) {
      const Vertex a = reached[i];
      for (const HalfEdge half : graph.incident(a)) {
        const Vertex b = half.to;
        if (gone[b] || depth[b] < n || (a == e.u && b == e.v)) continue;
        depth[b] = depth[a] + 1;
        reached.push_back(b);
      }
    }
    if (depth[e.v] < n && (girth == 0 || depth[e.v] + 1 < girth)) girth = depth[e.v] + 1;
  }
  return girth;
}

void expect_chordless(const Graph& graph, const std::vector<Vertex>& cycle) {
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    std::vector<Vertex> on_cycle;
    for (const HalfEdge half : graph.incident(cycle[i])) {
      if (std::ranges::find(cycle, half.to) != cycle.end()) on_cycle.push_back(half.to);
    }
    EXPECT_THAT(on_cycle,
                ::testing::UnorderedElementsAre(cycle[(i + 1) % cycle.size()],
                                                cycle[(i + cycle.size() - 1) % cycle.size()]));
  }
}

/// The drawing of a cycle with a vertex at the end of every leg, in the layer z = 0.
Drawing flat_drawing(const Graph& graph, const grid_paper::FlatCycle& flat) {
  const auto point = [](const grid_paper::LayerPoint& p) { return Point{p.y(), p.x + p.y(), p.x}; };
  Draft draft;
  for (const auto& p : flat.at) draft.vertices.push_back(point(p));
  for (const auto& p : flat.at) draft.vertices.push_back(point({p.h + 2, p.x}));
  for (const Edge e : graph.edges()) {
    draft.edges.push_back({e, {}});
    if (e.v >= flat.at.size()) continue;
    for (const auto& p : e.v > e.u + 1 ? flat.bends.back() : flat.bends[e.u]) {
      draft.edges.back().bends.push_back(point(p));
    }
  }
  return draft.drawing();
}

TEST(GridPaperFlatCycle, AnyEvenNumbersGiveACycleWithoutContact) {
  RandomStream random(4);
  for (int i = 0; i < 400; ++i) {
    const std::uint32_t k = 3 + random.below(20), values = 1 + random.below(i % 2 == 0 ? 4 : 40);
    std::vector<std::int64_t> x;
    std::vector<Edge> edges;
    for (Vertex v = 0; v < k; ++v) {
      x.push_back(2 * std::int64_t{random.below(values)});
      edges.insert(edges.end(), {{v, (v + 1) % k}, {v, k + v}});
    }
    x[1] = x[0] + 2 + 2 * std::int64_t{random.below(values)};
    const Graph graph(2 * std::uint64_t{k}, edges);
    for (const Spread spread : {Spread::columns, Spread::conditional, Spread::least}) {
      const Drawing drawing = flat_drawing(graph, grid_paper::draw_flat_cycle(x, spread, 1, true));
      const Certificate found =
          certify(graph, drawing, grid_paper::row().guarantee, {.check_size = false});
      ASSERT_TRUE(found.valid()) << i << ": " << found.violations.at(0).message;
    }
  }
}

class GridPaperRepairs : public ::testing::TestWithParam<LeftOutRepair> {};

TEST(GridPaperGrowth, CyclesAreShortestAndClosuresClosed) {
  for (const char* family : {"random-cubic", "prism", "random-subcubic", "union-petersen"}) {
    const Graph graph = shuffled(generate(find_family(family), 90, 5), 6);
    for (const bool any_cycle : {false, true}) {
      std::vector<int> times(graph.num_vertices());
      for (const auto& [vertices, stages] : grid_paper::grow(graph, any_cycle, {})) {
        std::vector<bool> gone(graph.num_vertices(), true);
        for (const Vertex v : vertices) gone[v] = false;
        for (const GrowthStage& stage : stages) {
          if (!stage.cycle.empty()) expect_chordless(graph, stage.cycle);
          if (!stage.cycle.empty() && !any_cycle) {
            EXPECT_EQ(stage.cycle.size(), plain_girth(graph, gone));
          }
          for (const auto* list : {&stage.cycle, &stage.between, &stage.closure}) {
            for (const Vertex v : *list) {
              gone[v] = true;
              ++times[v];
            }
          }
          for (const Vertex v : vertices) {
            const auto outside = std::ranges::count_if(
                graph.incident(v), [&](HalfEdge half) { return !gone[half.to]; });
            EXPECT_TRUE(gone[v] ? outside <= 1 : outside >= 2);
          }
        }
      }
      for (const int t : times) EXPECT_EQ(t, 1) << family;
    }
  }
}

TEST_P(GridPaperRepairs, AreNeededByTheirSmallestGraphAndByNoSmallerOne) {
  const auto& [name, switches, graph] = GetParam();
  EXPECT_EQ(grid_paper_fault(graph, {}, {.random_cycles = switches.random_cycles}), "");
  EXPECT_NE(grid_paper_fault(graph, {}, switches), "");
  for (Vertex n = 1; n < std::min<Vertex>(graph.num_vertices(), 7); ++n) {
    for (const Graph& smaller : geng(fmt::format("-c -D3 {}", n))) {
      EXPECT_EQ(grid_paper_fault(smaller, {}, switches), "") << n;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Switches, GridPaperRepairs, ::testing::ValuesIn(left_out_repairs()),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(GridPaper, ComponentsNeedPlacesOfTheirOwn) {
  EXPECT_EQ(grid_paper_fault(Graph(2, {})), "");
  EXPECT_NE(grid_paper_fault(Graph(2, {}), {}, {.apart = false}), "");
}

}  // namespace
}  // namespace ar3d::testing
