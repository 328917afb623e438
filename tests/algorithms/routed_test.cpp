// Algorithms `routed` and `routed-120`: small graphs, unions and options; the search against the
// plain search over all points, the check of routings against broken ones.
#include <bit>
#include <functional>
#include <map>
#include <queue>
#include <set>

#include "algorithms/routed_support.h"
#include "ar3d/algorithms/catalog.h"
#include "ar3d/algorithms/routed/boxes.h"
#include "ar3d/algorithms/routed/check.h"
#include "ar3d/generators/catalog.h"
#include "support/problem.h"

namespace ar3d::testing {
namespace {

using routed::CostBox;
using routed::Directions;
using routed::End;
using routed::PointClass;
using routed::Route;
using routed::Routing;
using routed::Spot;

const PointClass& class_of(bool is_body) {
  return is_body ? PointClass::body() : PointClass::face();
}

TEST(Routed, DifferentStepsOfAClassHaveDifferentMiddles) {
  for (const bool is_body : {true, false}) {
    const PointClass& points = class_of(is_body);
    std::map<std::tuple<int, int, int>, int> middles;
    for (int i = 0; i < 6 * 6 * 6; ++i) {
      const Spot p = {i % 6, i / 6 % 6, i / 36};
      if (!points.contains(p)) continue;
      for (int d = 0; d < points.num_directions(); d += 2) {  // one of two opposite ones
        const Spot q = p + points.step(d);
        EXPECT_TRUE(points.contains(q));
        ++middles[{p.x + q.x, p.y + q.y, p.z + q.z}];
      }
    }
    EXPECT_GT(middles.size(), 150u);
    for (const auto& [middle, steps] : middles) EXPECT_EQ(steps, 1);
  }
}

TEST(Routed, ClassesHaveTheAnglesOfTheTwoRows) {
  EXPECT_EQ(PointClass::body().frames().size(), 2u);
  EXPECT_EQ(PointClass::face().frames().size(), 8u);
  for (const bool is_body : {true, false}) {
    const PointClass& points = class_of(is_body);
    for (int d = 0; d < points.num_directions(); ++d) {
      EXPECT_EQ(points.step(PointClass::opposite(d)), -1 * points.step(d));
      EXPECT_EQ(std::popcount(points.turns(d)), is_body ? 3 : 4);
    }
  }
}

/// The cheapest walk of at most so many bends, by Dijkstra over points, directions and bends.
int plain_search(const CostBox& box, const PointClass& points, const End& u, const End& v,
                 int bends) {
  using State = std::tuple<int, int, int, int, int>;  // x, y, z, direction, bends
  std::map<State, int> cost;
  std::priority_queue<std::pair<int, State>> queue;
  const auto reach = [&](Spot from, int d, int bent, int so_far) {
    const Spot p = from + points.step(d);
    if (!box.contains(p)) return;
    int more = CostBox::kStep;
    if (p == v.at) {
      if (!routed::has(v.arms, PointClass::opposite(d))) return;
    } else {
      if (box.cost(box.index(p)) == CostBox::kBlocked) return;
      more += box.cost(box.index(p));
    }
    const State state{p.x, p.y, p.z, d, bent};
    const auto [at, is_new] = cost.try_emplace(state, so_far + more);
    if (!is_new && at->second <= so_far + more) return;
    at->second = so_far + more;
    queue.emplace(-at->second, state);
  };
  for (int d = 0; d < points.num_directions(); ++d) {
    if (routed::has(u.arms, d)) reach(u.at, d, 0, 0);
  }
  while (!queue.empty()) {
    const auto [negative, state] = queue.top();
    queue.pop();
    const auto [x, y, z, d, bent] = state;
    if (cost.at(state) != -negative) continue;
    if (Spot{x, y, z} == v.at) return -negative;
    reach({x, y, z}, d, bent, -negative);
    for (int e = 0; e < points.num_directions() && bent < bends; ++e) {
      if (routed::has(points.turns(d), e)) reach({x, y, z}, e, bent + 1, -negative);
    }
  }
  return CostBox::kNoRoute;
}

/// Thirty vertices and thirty routes in a small box; the points of ten more, which are free.
std::vector<Spot> fill(CostBox& box, const PointClass& points, RandomStream& random) {
  std::vector<Spot> spots;
  while (spots.size() < 40) {
    const Spot p = {static_cast<int>(random.below(10)) - 3, static_cast<int>(random.below(9)),
                    static_cast<int>(random.below(10))};
    if (!points.contains(p) || box.has_vertex(box.index(p))) continue;
    if (spots.size() < 30) box.put_vertex(box.index(p));
    spots.push_back(p);
  }
  for (int i = 0; i < 30; ++i) {
    const auto d =
        static_cast<int>(random.below(static_cast<std::uint32_t>(points.num_directions())));
    const Route route{1, {static_cast<std::uint8_t>(d)}, {4}};
    const Spot from = spots[random.below(30)];
    if (box.contains(from + 4 * points.step(d))) box.put(from, route);
  }
  box.remember_shared(3);
  return spots;
}

TEST(Routed, TheSearchFindsWhatThePlainSearchFinds) {
  for (const bool is_body : {true, false}) {
    const PointClass& points = class_of(is_body);
    for (const int bends : {3, 4, 5}) {
      routed::RouteSearch search(points, bends);
      RandomStream random(7);
      int routes = 0, equal = 0;
      for (int go = 0; go < 60; ++go) {
        CostBox box(points, {{-3, 0, 0}, {6, 8, 9}});
        const std::vector<Spot> spots = fill(box, points, random);
        const auto frame = [&](std::uint32_t i) {
          return points.frames()[i % points.frames().size()];
        };
        const End u{spots[0], frame(random.below(8))};
        const End v{spots[1], frame(random.below(8))};
        Route route;
        const int cost = search.find(box, u, v, CostBox::kBlocked, true, random, route);
        const int plain = plain_search(box, points, u, v, bends);
        EXPECT_GE(cost, std::min<int>(plain, CostBox::kBlocked));
        if (plain < CostBox::kBlocked) ++routes;
        if (!route) continue;
        EXPECT_EQ(cost, box.cost_of(u.at, route));
        equal += cost == plain;
      }
      EXPECT_GT(routes, 20);
      EXPECT_GE(equal, routes - routes / 20) << "a walk that meets itself is no route";
    }
  }
}

/// The least sum of costs at a point, by all choices of different arms of a frame.
int plain_sum(const CostBox& box, const PointClass& points, Spot at, std::span<const End> ends,
              Directions free, int bends) {
  if (ends.empty()) return 0;
  int least = CostBox::kBlocked;
  for (int d = 0; d < points.num_directions(); ++d) {
    if (!routed::has(free, d)) continue;
    const End moved{at, static_cast<Directions>(1u << d)};
    const int here = plain_search(box, points, ends[0], moved, bends);
    if (here >= least) continue;
    least = std::min(
        least, here + plain_sum(box, points, at, ends.subspan(1), routed::without(free, d), bends));
  }
  return least;
}

TEST(Routed, TheBestPlaceOfAVertexIsThatOfAllPlaces) {
  for (const bool is_body : {true, false}) {
    const PointClass& points = class_of(is_body);
    routed::RouteSearch search(points, 3);
    RandomStream random(8);
    for (int go = 0; go < 6; ++go) {
      CostBox box(points, {{-3, 0, 0}, {6, 8, 9}});
      const std::vector<Spot> spots = fill(box, points, random);
      if (box.uses(box.index(spots[2])) > 0) continue;
      const std::vector<End> ends = {{spots[0], points.frames()[0]},
                                     {spots[1], points.frames()[0]}};
      const std::size_t frame = is_body ? 0 : 3;
      routed::Trial found;
      const int cost = search.find_place(box, spots[2], ends, std::array{frame}, 2,
                                         CostBox::kBlocked, random, found);
      CostBox without_it = box;
      without_it.take_vertex(box.index(spots[2]));
      int least = CostBox::kBlocked;
      for (int i = 0; i < 5 * 5 * 5; ++i) {
        const Spot p = spots[2] + Spot{i % 5 - 2, i / 5 % 5 - 2, i / 25 - 2};
        if (!points.contains(p) || !box.contains(p)) continue;
        const int at = box.index(p);
        if (!(p == spots[2]) && box.has_vertex(at)) continue;
        const int sum = plain_sum(without_it, points, p, ends, points.frames()[frame], 3);
        least = std::min(least, sum + box.cost_of_vertex(at));
      }
      EXPECT_EQ(cost, least);
    }
  }
}

TEST(Routed, AVertexOnARouteIsAConflictThatBothPayFor) {
  const PointClass& points = PointClass::body();
  CostBox box(points, {{0, 0, 0}, {8, 8, 8}});
  const Route route{1, {0}, {4}};
  const Spot from = {0, 0, 0};
  const int middle = box.index(2 * points.step(0));
  box.put(from, route);
  EXPECT_FALSE(box.is_shared(from, route));
  const int before = box.cost_of(from, route);
  box.put_vertex(middle);
  EXPECT_TRUE(box.is_shared(from, route));
  EXPECT_GT(box.cost_of(from, route), before);
  const int of_vertex = box.cost_of_vertex(middle);
  EXPECT_GT(of_vertex, 0);
  box.remember_shared(5);
  EXPECT_EQ(box.cost_of_vertex(middle), of_vertex + 5);
  box.take(from, route);
  EXPECT_EQ(box.cost_of_vertex(middle), 5);
  EXPECT_EQ(box.cost_of_vertex(box.index(points.step(0))), 0);
}

TEST(Routed, SmallGraphsAreNearTheSmallestBoxesAtEffortTwo) {
  const Graph k33(6, {{0, 3}, {0, 4}, {0, 5}, {1, 3}, {1, 4}, {1, 5}, {2, 3}, {2, 4}, {2, 5}});
  const std::vector<std::pair<Graph, double>> smallest = {// results/reference/optima.csv
                                                          {complete(4), 125},
                                                          {octahedron(), 294},
                                                          {k33, 280},
                                                          {cycle(3), 64}};
  for (const auto& [graph, optimum] : smallest) {
    const Drawing drawing = routed::draw_109(graph, {.effort = 2});
    const auto e = bounding_box(drawing).extents();
    const double volume = static_cast<double>((e[0] + 1) * (e[1] + 1) * (e[2] + 1));
    EXPECT_LE(volume, 1.3 * optimum) << graph.num_edges();
    EXPECT_GE(volume, optimum) << graph.num_edges();
  }
}

TEST(Routed, SmallGraphsAreRoutedAndCertified) {
  int fall_backs = 0;
  for (int n = 1; n <= 5; ++n) {
    for (const Graph& graph : geng("-D4 " + std::to_string(n))) {
      ASSERT_EQ(routed_fault(graph, routed::row_109(), 3, 0, &fall_backs), "");
      if (graph.max_degree() > 3) continue;
      ASSERT_EQ(routed_fault(graph, routed::row_120(), 3, 0, &fall_backs), "");
    }
  }
  EXPECT_EQ(fall_backs, 0);
  const Graph several = disjoint_union({complete(5), octahedron(), Graph(3, {}), cycle(7)});
  for (const std::int64_t bends : {3, 4, 5}) {
    EXPECT_EQ(routed_fault(several, routed::row_109(), bends, 0), "") << bends;
    EXPECT_EQ(routed_fault(petersen(), routed::row_120(), bends, 0), "") << bends;
  }
  EXPECT_EQ(routed_fault(petersen(), routed::row_120(), 3, 1), "");
  EXPECT_EQ(routed_fault(Graph(0, {}), routed::row_109(), 3, 1), "");
}

TEST(Routed, OptionsOutOfRangeAndTooLittleMemoryAreRefused) {
  const auto refusal = [](const Graph& graph, const routed::Options& options) {
    return problem([&] { routed::draw_109(graph, options); }, "drawn");
  };
  EXPECT_THAT(refusal(path(3), {.bends = 2}), HasSubstr("routed takes bends from 3 to 5, not 2"));
  EXPECT_THAT(refusal(path(3), {.effort = 3}), HasSubstr("routed has efforts 0 to 2, not 3"));
  EXPECT_THAT(refusal(path(4999), {.effort = 0, .megabytes = 10}),
              HasSubstr("box, but option megabytes allows 10"));
  EXPECT_EQ(value_of(routed::draw_109(path(10001), {.effort = 0}).counters, "routed"), 0);
}

/// A routing of K4 that is a drawing.
Routing routing_of_k4(const Graph& graph) {
  routed::BoxCounts counts;
  const auto found = routed::smallest_routing(graph, PointClass::body(), 3, 0, 1 << 20, counts);
  return found.value();
}

TEST(Routed, BrokenRoutingsAreNoDrawings) {
  const Graph graph = complete(4);
  const PointClass& points = PointClass::body();
  const Routing right = routing_of_k4(graph);
  ASSERT_TRUE(routed::is_drawing(graph, points, 3, right));
  int most = 0;
  for (const Route& route : right.routes) most = std::max(most, route.segments - 1);
  EXPECT_TRUE(routed::is_drawing(graph, points, most, right));
  EXPECT_FALSE(routed::is_drawing(graph, points, most - 1, right)) << "a bend too many";
  EXPECT_FALSE(routed::is_drawing(graph, PointClass::face(), 3, right)) << "wrong class";
  Routing broken = right;
  broken.layout.frame[0] ^= 1;
  EXPECT_FALSE(routed::is_drawing(graph, points, 3, broken)) << "wrong frame";
  broken = right;
  broken.layout.at[0] = broken.layout.at[1];
  EXPECT_FALSE(routed::is_drawing(graph, points, 3, broken)) << "two vertices at one point";
  broken = right;
  broken.routes[0].length[0] += 2;
  EXPECT_FALSE(routed::is_drawing(graph, points, 3, broken)) << "misses its end";
  broken = right;
  broken.routes[0] = {};
  EXPECT_FALSE(routed::is_drawing(graph, points, 3, broken)) << "no route";
  broken = right;
  broken.layout.limits.high = broken.layout.limits.high - Spot{1, 1, 1};
  EXPECT_FALSE(routed::is_drawing(graph, points, 3, broken)) << "outside of the box";
}

TEST(Routed, TheVerifierFindsAPointUsedTwiceAWrongFrameAndABendTooMany) {
  const Graph graph = octahedron();
  const Guarantee guarantee = routed::row_109().guarantee;
  const Drawing drawing = routed::draw_109(graph, {.effort = 0});
  const auto kinds = [&](const std::function<void(std::vector<std::vector<Point>>&)>& change,
                         const Guarantee& promised) {
    std::vector<std::vector<Point>> lines;
    for_each_polyline(drawing,
                      [&](EdgeId, const std::vector<Point>& line) { lines.push_back(line); });
    change(lines);
    auto bends = std::make_shared<StoredBends>();
    for (const auto& line : lines) bends->add_edge({line.begin() + 1, line.end() - 1});
    Coordinates at(graph.num_vertices(), 1000);
    for (Vertex v = 0; v < graph.num_vertices(); ++v) at.set(v, drawing.vertex(v));
    const Drawing other("routed", kCubeLattice, std::move(at), graph.shared_edges(), bends);
    std::set<ViolationKind> found;
    for (const Violation& violation : certify(graph, other, promised).violations) {
      found.insert(violation.kind);
    }
    return found;
  };
  const auto nothing = [](auto&) {};
  EXPECT_EQ(kinds(nothing, guarantee).size(), 0u);
  Guarantee fewer = guarantee;
  fewer.max_bends = 2;
  EXPECT_EQ(kinds(nothing, fewer).count(ViolationKind::bends), 1u);
  const auto twice = [](auto& lines) { lines[0].insert(lines[0].begin() + 1, lines[5][1]); };
  EXPECT_FALSE(kinds(twice, guarantee).empty());
  EXPECT_EQ(kinds(twice, guarantee).count(ViolationKind::vertex_on_edge) +
                    kinds(twice, guarantee).count(ViolationKind::crossing) >
                0,
            true);
  const auto same_arm = [](auto& lines) {
    const Point p = lines[0][0];
    const Vector d = lines[1][1] - lines[1][0];
    lines[0][1] = p + primitive(d);
  };
  EXPECT_EQ(kinds(same_arm, guarantee).count(ViolationKind::vertex_angle), 1u);
}

}  // namespace
}  // namespace ar3d::testing
