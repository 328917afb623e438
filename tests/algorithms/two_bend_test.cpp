#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>

#include "algorithms/two_bend_graphs.h"
#include "algorithms/two_bend_support.h"
#include "ar3d/generators/catalog.h"

namespace ar3d::testing {
namespace {

/// Sums of the counters of many runs.
class Totals {
 public:
  void add(const std::vector<Counter>& counters) {
    for (const Counter& counter : counters) sums_[counter.name] += counter.value;
  }
  std::int64_t operator[](const std::string& name) const { return sums_.at(name); }

 private:
  std::map<std::string, std::int64_t> sums_;
};

TEST(TwoBend, DrawsFamiliesOfEverySmallKind) {
  for (Vertex n = 0; n < 5; ++n) expect_certified(Graph(n, {}));
  for (Vertex n = 2; n < 9; ++n) expect_certified(path(n));
  for (Vertex n = 3; n < 12; ++n) expect_certified(cycle(n));
  expect_certified(complete(4));
  expect_certified(petersen());
  expect_certified(disjoint_union({complete(4), path(1), petersen(), cycle(5), path(2)}));
}

/// The whole variety of vertex types, specials and fixed bodies is met and certified.
TEST(TwoBend, MeetsEveryPartOfTheConstruction) {
  Totals totals;
  for (std::uint64_t seed = 1; seed <= 600; ++seed) {
    const Graph graph = shuffled(random_graph_of_any_kind(24, seed), seed);
    totals.add(expect_certified(graph));
  }
  for (const Graph& graph : geng("-c -d3 -D3 10")) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
      totals.add(expect_certified(shuffled(graph, seed)));
  }
  for (const char* part : {"q_bodies", "stations", "vv_leans", "sinks_a", "sinks_v", "sources_a",
                           "sources_v", "adjacent_poles"}) {
    EXPECT_GT(totals[part], 0) << part;
  }
  EXPECT_EQ(totals["safe_rounds"], 0);
}

TEST(TwoBend, DrawsEveryFamilyOfTheCatalogue) {
  for (const Family& family : families()) {
    if (family.max_degree > 3) continue;
    for (const std::uint64_t n : {6u, 20u, 64u, 150u}) {
      const Graph graph = generate(family, n, 1);
      SCOPED_TRACE(family.name);
      expect_certified(graph);
      expect_certified(shuffled(graph, n));
    }
  }
}

/// Edges by their number of bends, and the volume.
struct Price {
  std::array<std::int64_t, 3> edges{};
  double volume = 0;

  explicit Price(const Drawing& drawing) {
    std::vector<Point> line;
    for (EdgeId e = 0; e < drawing.num_edges(); ++e) {
      drawing.polyline(e, line);
      ++edges.at(line.size() - 2);
    }
    const auto extents = bounding_box(drawing).extents();
    volume = 1;
    for (const std::int64_t extent : extents) volume *= static_cast<double>(extent + 1);
  }
  std::int64_t bends() const { return edges[1] + 2 * edges[2]; }
};

TEST(TwoBend, EffortSavesBendsAndVolume) {
  std::array<std::int64_t, 2> bends{};
  std::array<double, 2> volume{};
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Graph graph = generate(find_family("random-cubic"), 400, seed);
    for (const int effort : {0, 1}) {
      expect_certified(graph, {.effort = effort});
      const Price price(two_bend::draw(graph, {.effort = effort}));
      bends[static_cast<std::size_t>(effort)] += price.bends();
      volume[static_cast<std::size_t>(effort)] += price.volume;
    }
  }
  EXPECT_LT(bends[1], bends[0] * 9 / 10);
  EXPECT_LT(volume[1], volume[0]);
}

/// The goal for random cubic graphs is a volume of at most n^4 / 2; 0.26 to 0.29 was met.
TEST(TwoBend, KeepsTheVolumeOfRandomCubicGraphsBelowAThirdOfN4) {
  const double n = 10000;
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const Graph graph = generate(find_family("random-cubic"), 10000, seed);
    const auto e = bounding_box(two_bend::draw(graph)).extents();
    const double x = static_cast<double>(e[0]);
    const double y = static_cast<double>(e[1]);
    const double z = static_cast<double>(e[2]);
    EXPECT_LT(x / n * (y / n) * (z / n / n), 0.33) << seed;
  }
}

/// Vertices of degree 1 and 2 take the bends of their edge.
TEST(TwoBend, LowDegreesCostHardlyABend) {
  const Price ring(two_bend::draw(cycle(30)));
  EXPECT_LE(ring.bends(), 4);  // at the STATION
  const Graph tree = generate(find_family("binary-tree"), 1000, 1);
  const Price price(two_bend::draw(tree));
  EXPECT_GE(price.edges[0], 500);  // the leaves' edges
  EXPECT_LE(price.edges[2], 40);
}

TEST(TwoBend, IsDeterministic) {
  const Graph graph = random_graph_of_any_kind(60, 5);
  const Drawing a = two_bend::draw(graph);
  const Drawing b = two_bend::draw(graph);
  std::vector<Point> p;
  std::vector<Point> q;
  for (EdgeId e = 0; e < graph.num_edges(); ++e) {
    a.polyline(e, p);
    b.polyline(e, q);
    EXPECT_EQ(p, q);
  }
}

TEST(TwoBend, RefusesDegree4AndUnknownEfforts) {
  EXPECT_THROW(two_bend::draw(octahedron()), InputError);
  EXPECT_THROW(draw(find_algorithm("two-bend"), complete(5)), InputError);
  EXPECT_THROW(two_bend::draw(path(3), {.effort = 2}), InputError);
  EXPECT_THROW(two_bend::draw(path(3), {.effort = -1}), InputError);
}

/// The drawing with the lower end of the lean of one edge a step higher; nothing if it has no lean.
std::optional<Drawing> with_a_flatter_lean(const Drawing& drawing, EdgeId spoilt) {
  auto bends = std::make_shared<StoredBends>();
  auto edges = std::make_shared<std::vector<Edge>>();
  std::vector<Point> points;
  bool found = false;
  for (EdgeId e = 0; e < drawing.num_edges(); ++e) {
    drawing.polyline(e, points);
    std::vector<Point> inner(points.begin() + 1, points.end() - 1);
    if (e == spoilt && inner.size() == 2) {
      const Vector lean = inner[1] - inner[0];
      found = lean.x != 0 && lean.y != 0;
      if (found) ++inner[lean.z > 0 ? 0 : 1].z;
    }
    bends->add_edge(inner);
    edges->push_back(drawing.edge(e));
  }
  if (!found) return std::nullopt;
  Coordinates vertices(drawing.num_vertices(), kMaxCoordinate);
  for (Vertex v = 0; v < drawing.num_vertices(); ++v) vertices.set(v, drawing.vertex(v));
  return Drawing(drawing.algorithm(), drawing.lattice(), std::move(vertices), edges, bends);
}

/// Leans are as low as Lemmas 2.2 and 2.3 allow: one step less, and an angle is too sharp.
TEST(TwoBend, VerifierSeesEveryLeanThatIsTooLow) {
  const Graph graph = generate(find_family("random-cubic"), 40, 1);
  const Drawing drawing = two_bend::draw(graph);
  std::size_t leans = 0;
  for (EdgeId e = 0; e < graph.num_edges(); ++e) {
    const std::optional<Drawing> spoilt = with_a_flatter_lean(drawing, e);
    if (!spoilt) continue;
    ++leans;
    const Certificate certificate = certify(graph, *spoilt, find_algorithm("two-bend").guarantee);
    const auto is_sharp = [](const Violation& violation) {
      return violation.kind == ViolationKind::bend_angle ||
             violation.kind == ViolationKind::vertex_angle;
    };
    EXPECT_TRUE(std::any_of(certificate.violations.begin(), certificate.violations.end(), is_sharp))
        << "edge " << e;
  }
  EXPECT_GT(leans, 5u);
}

}  // namespace
}  // namespace ar3d::testing
