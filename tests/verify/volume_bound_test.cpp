// Bounds of volume from below: the smallest box against all boxes, the routed bisection against all
// halves, and every bound against certified drawings (docs/lower-bounds.md).
#include "ar3d/verify/metrics/volume_bound.h"

#include <bit>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/generators/families.h"
#include "ar3d/generators/random_graphs.h"
#include "ar3d/verify/certificate.h"
#include "support/graphs.h"
#include "verify/draft.h"

namespace ar3d::testing {
namespace {

std::uint64_t volume_of(const Drawing& drawing) {
  std::uint64_t volume = 1;
  for (const std::int64_t extent : bounding_box(drawing).extents()) {
    volume *= static_cast<std::uint64_t>(extent) + 1;
  }
  return volume;
}

/// Whether some set of points that unit steps reach from each other, counted one by one, has so
/// many in a box; sides in any order.
bool holds(const BoxNeeds& needs, const std::array<std::uint64_t, 3>& sides) {
  const auto is_used = [&](std::uint64_t x, std::uint64_t y, std::uint64_t z, unsigned first) {
    switch (needs.steps) {
      case DrawnSteps::any:
        return true;
      case DrawnSteps::face_diagonals:
        return (x + y + z + first) % 2 == 0;
      case DrawnSteps::body_diagonals:
        break;
    }
    return (x + y + first) % 2 == 0 && (y + z + first / 2) % 2 == 0;
  };
  std::uint64_t points = 0, plane = 0, layer = ~std::uint64_t{0};
  for (unsigned first = 0; first < 4; ++first) {
    std::uint64_t in_all = 0;
    std::array<std::vector<std::uint64_t>, 3> across;
    for (std::size_t axis = 0; axis < 3; ++axis) across[axis].resize(sides[axis]);
    for (std::uint64_t x = 0; x < sides[0]; ++x) {
      for (std::uint64_t y = 0; y < sides[1]; ++y) {
        for (std::uint64_t z = 0; z < sides[2]; ++z) {
          if (!is_used(x, y, z, first)) continue;
          ++in_all, ++across[0][x], ++across[1][y], ++across[2][z];
        }
      }
    }
    points = std::max(points, in_all);
    for (const auto& counts : across) {
      plane = std::max(plane, *std::max_element(counts.begin(), counts.end()));
    }
  }
  // The fullest layer across each axis; the emptiest axis counts.
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::uint64_t a = sides[(axis + 1) % 3], b = sides[(axis + 2) % 3];
    const std::uint64_t full = needs.steps == DrawnSteps::any ? a * b
                               : needs.steps == DrawnSteps::face_diagonals
                                   ? (a * b + 1) / 2
                                   : ((a + 1) / 2) * ((b + 1) / 2);
    layer = std::min(layer, full);
  }
  return points >= needs.points && plane >= needs.in_plane && layer >= needs.in_layer &&
         *std::min_element(sides.begin(), sides.end()) >= needs.side;
}

TEST(VolumeBound, SmallestBoxIsTheSmallestOfAll) {
  for (const DrawnSteps steps :
       {DrawnSteps::any, DrawnSteps::body_diagonals, DrawnSteps::face_diagonals}) {
    for (const std::uint64_t points : {1u, 2u, 5u, 9u, 14u, 23u}) {
      for (const std::uint64_t in_plane : {0u, 1u, 4u, 7u}) {
        for (const std::uint64_t in_layer : {0u, 1u, 3u, 4u}) {
          const BoxNeeds needs{steps, points, in_plane, in_layer, 1 + points % 2};
          const std::uint64_t found = smallest_box(needs);
          std::uint64_t least = found + 1;
          for (std::uint64_t a = 1; a * a * a <= found; ++a) {
            for (std::uint64_t b = a; a * b * b <= found; ++b) {
              for (std::uint64_t c = b; a * b * c < least; ++c) {
                if (holds(needs, {a, b, c})) least = a * b * c;
              }
            }
          }
          EXPECT_EQ(found, least) << static_cast<int>(steps) << ' ' << points << ' ' << in_plane
                                  << ' ' << in_layer;
        }
      }
    }
  }
}

std::uint64_t bisection_width(const Graph& graph) {
  const int n = static_cast<int>(graph.num_vertices());
  std::uint64_t width = graph.num_edges();
  for (unsigned half = 0; half < 1u << n; ++half) {
    if (std::popcount(half) != n / 2) continue;
    std::uint64_t crossing = 0;
    for (const auto [u, v] : graph.edges()) crossing += ((half >> u) ^ (half >> v)) & 1;
    width = std::min(width, crossing);
  }
  return width;
}

std::vector<Vertex> all_vertices(const Graph& graph) {
  std::vector<Vertex> all(graph.num_vertices());
  for (Vertex v = 0; v < graph.num_vertices(); ++v) all[v] = v;
  return all;
}

std::uint64_t bisection_at_least(const Graph& graph, std::uint32_t most_visits) {
  const auto always = [](const RoutedBisection&) { return true; };
  return route_bisection(graph, all_vertices(graph), most_visits, always).back().first;
}

TEST(VolumeBound, BisectionsAreAtLeastWhatRoutingSays) {
  std::size_t tight = 0, graphs = 0;
  for (const char* arguments : {"-c -D4 4", "-c -D4 5", "-c -D4 6", "-c -D4 7", "-c -D3 -d3 10"}) {
    for (const Graph& graph : geng(arguments)) {
      const std::uint64_t bound = bisection_at_least(graph, 1000000);
      const std::uint64_t width = bisection_width(graph);
      ASSERT_LE(bound, width);
      ASSERT_GE(bound, 1u);
      tight += bound == width;
      ++graphs;
    }
  }
  EXPECT_GT(4 * tight, graphs);
  EXPECT_EQ(bisection_at_least(cycle(500), 1 << 24), 2u);
  EXPECT_EQ(bisection_at_least(cycle(2000), 1 << 24), 0u) << "its vertices are too far apart";
}

// Of random 4-regular graphs at least n/16; the second eigenvalue proves n/7.5 and Bollobas 1988
// n/5.
TEST(VolumeBound, ExpandersHaveLargeBisections) {
  const Graph expander = random_regular(1024, 4, 1);
  const Guarantee& compact = find_algorithm("compact").guarantee;
  const auto needs_with_bisection = [&](const Graph& graph) {
    GraphNeeds needs = needs_of(graph);
    seek_bisection(graph, compact, needs);
    return needs;
  };
  const GraphNeeds needs = needs_with_bisection(expander);
  EXPECT_GE(needs.bisection, 1024u / 8);
  EXPECT_LE(needs.bisection, 1024u / 4) << "random halves have half of the edges, good ones less";
  EXPECT_EQ(needs_of(expander).bisection, 0u);
  EXPECT_EQ(needs_with_bisection(random_regular(510, 4, 1)).bisection, 0u);
  EXPECT_EQ(needs_with_bisection(random_regular(16386, 4, 1)).bisection, 0u);
  EXPECT_GT(volume_at_least(needs, compact), volume_at_least(expander, compact));
}

// What is left out would change the volume by 2 % at most, and the order of the guarantees changes
// nothing.
TEST(VolumeBound, IsAsIfTheBisectionWereAlwaysLookedFor) {
  std::size_t gains = 0, spared = 0;
  for (const Family& family : families()) {
    const Graph graph = generate(family, 700, 1);
    GraphNeeds full = needs_of(graph);
    if (full.part_vertices != graph.num_vertices() || graph.num_vertices() < 512) continue;
    const Guarantee& body = find_algorithm("compact").guarantee;
    const Guarantee& face = find_algorithm("compact-120").guarantee;
    if (graph.max_degree() > body.max_degree) continue;
    full.bisection = bisection_at_least(graph, 1 << 25);
    GraphNeeds forwards = needs_of(graph), backwards = forwards;
    const auto volume = [&](const Guarantee& guarantee, GraphNeeds& needs) {
      seek_bisection(graph, guarantee, needs);
      const std::int64_t found = volume_at_least(needs, guarantee);
      EXPECT_LE(found, volume_at_least(full, guarantee)) << family.name;
      EXPECT_GE(50 * found, 49 * volume_at_least(full, guarantee)) << family.name;
      return found;
    };
    const std::int64_t body_first = volume(body, forwards), face_last = volume(face, forwards);
    EXPECT_EQ(volume(face, backwards), face_last) << family.name;
    EXPECT_EQ(volume(body, backwards), body_first) << family.name;
    gains += body_first > volume_at_least(needs_of(graph), body);
    spared += forwards.bisections.back().second > forwards.bisections.back().first;
  }
  EXPECT_GT(gains, 5u);
  EXPECT_GT(spared, 5u);
}

// Every algorithm's drawings: of all small graphs, and of every family.
void expect_below(const Algorithm& algorithm, const Graph& graph, const std::string& name) {
  const Drawing drawing = draw(algorithm, graph);
  GraphNeeds needs = needs_of(graph);
  if (graph.num_vertices() < 1500) seek_bisection(graph, algorithm.guarantee, needs);
  const std::int64_t bound = volume_at_least(needs, algorithm.guarantee);
  if (algorithm.guarantee.claim == Claim::measured) {
    EXPECT_EQ(bound, -1);
    return;
  }
  EXPECT_GE(bound, 1);
  EXPECT_GE(bound, graph.num_vertices());
  EXPECT_LE(static_cast<std::uint64_t>(bound), volume_of(drawing)) << algorithm.name << ' ' << name;
}

TEST(VolumeBound, IsBelowEveryDrawingOfSmallGraphs) {
  for (const char* arguments : {"-D4 2", "-D4 3", "-D4 4", "-D4 5", "-D4 6"}) {
    for (const Graph& graph : geng(arguments)) {
      for (const Algorithm* algorithm : proved_algorithms()) {
        if (graph.max_degree() <= algorithm->guarantee.max_degree) {
          expect_below(*algorithm, graph, arguments);
        }
      }
    }
  }
  for (const Algorithm& algorithm : algorithms()) expect_below(algorithm, Graph(0, {}), "none");
}

TEST(VolumeBound, IsBelowEveryDrawingOfEveryFamily) {
  for (const Family& family : families()) {
    for (const std::uint64_t n : {30u, 300u, 600u}) {
      const Graph graph = generate(family, n, 1);
      for (const Algorithm* algorithm : proved_algorithms()) {
        if (graph.max_degree() > algorithm->guarantee.max_degree) continue;
        expect_below(*algorithm, graph, family.name);
      }
    }
  }
}

// An edge with the guarantee of diamond, as small as it can be: up and down again.
TEST(VolumeBound, IsCloseToAnEdgeDrawnByHand) {
  const Guarantee& diamond = find_algorithm("diamond").guarantee;
  Draft draft;
  draft.vertices = {{0, 0, 0}, {2, 2, 0}};
  draft.edges = {{{0, 1}, {{1, 1, 1}}}};
  EXPECT_TRUE(certify(path(2), draft.drawing(), diamond, {.check_size = false}).valid());
  EXPECT_EQ(volume_at_least(path(2), diamond), 12);
  EXPECT_EQ(volume_of(draft.drawing()), 18u);
}

// Pieces of the two lattices, as they lie there: drawings without bends.
TEST(VolumeBound, IsWithinAFactorOfPiecesOfLattices) {
  Guarantee diamond;
  diamond.max_bends = 0;
  Guarantee laves = diamond;
  diamond.cosine = {-1, 3};
  diamond.directions = {{1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {-1, 1, 1}};
  laves.cosine = {-1, 2};
  laves.directions = {{1, 1, 0}, {1, -1, 0}, {1, 0, 1}, {1, 0, -1}, {0, 1, 1}, {0, 1, -1}};
  const auto expect_within = [](std::uint64_t factor, const auto& piece, const char* name,
                                const Guarantee& guarantee) {
    const auto bound = static_cast<std::uint64_t>(volume_at_least(piece.first, guarantee));
    const std::uint64_t volume = volume_of(drawing_from_points(name, piece.first, piece.second));
    EXPECT_LE(bound, volume);
    EXPECT_LE(volume, factor * bound) << name << ' ' << piece.first.num_vertices();
  };
  for (const std::uint64_t n : {10u, 100u, 1000u, 5000u}) {
    expect_within(6, diamond_lattice_piece(n), "diamond-lattice", diamond);
    expect_within(12, laves_piece(n), "laves-graph", laves);
  }
}

TEST(KnownOptimum, IsThatOfTheTableUnderAnyLabels) {
  const auto of = [](const Graph& graph, const char* algorithm) {
    return known_optimum(graph, find_algorithm(algorithm).guarantee);
  };
  for (const std::uint64_t seed : {0u, 1u, 2u}) {
    EXPECT_EQ(of(shuffled(complete(5), seed), "diamond"), 512);
    EXPECT_EQ(of(shuffled(complete(5), seed), "compact"), 336) << "five bends";
    EXPECT_EQ(of(shuffled(complete(4), seed), "grid"), 125);
    EXPECT_EQ(of(shuffled(cycle(5), seed), "diamond"), 64);
  }
  EXPECT_EQ(of(complete(4), "two-bend-120"), 216);
  EXPECT_EQ(of(complete(4), "two-bend"), -1) << "its angles are not exact";
  EXPECT_EQ(of(complete(4), "two-bend-paper"), -1);
  EXPECT_EQ(of(complete(1), "diamond"), -1);
  EXPECT_EQ(of(disjoint_union({path(2), path(2)}), "diamond"), -1) << "not connected";
  EXPECT_EQ(of(petersen(), "diamond"), -1);
}

TEST(KnownOptimum, IsBelowEveryDrawingAndAboveTheBound) {
  std::size_t known = 0;
  for (const int n : {2, 3, 4, 5}) {
    for (const Graph& graph : geng("-c -D4 " + std::to_string(n))) {
      for (const Algorithm* algorithm : proved_algorithms()) {
        const std::int64_t optimum = known_optimum(graph, algorithm->guarantee);
        if (optimum < 0) continue;
        ++known;
        Guarantee anywhere = algorithm->guarantee;
        anywhere.vertices_in_plane = false;
        EXPECT_LE(volume_at_least(graph, anywhere), optimum);
        EXPECT_LE(static_cast<std::uint64_t>(optimum), volume_of(draw(*algorithm, graph)));
      }
    }
  }
  EXPECT_GE(known, 30u + 30 + 19);
}

}  // namespace
}  // namespace ar3d::testing
