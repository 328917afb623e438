#include "ar3d/model/drawing.h"

#include <gtest/gtest.h>

#include "ar3d/base/error.h"
#include "support/problem.h"

namespace ar3d::testing {
namespace {

Drawing one_edge(Point a, const std::vector<Point>& bends, Point b) {
  return drawing_from_points("test", Graph(2, {{0, 1}}), std::vector<Point>{a, b}, {bends});
}

TEST(Drawing, PointsThatDoNotFitTheGraphAreRefused) {
  const Graph edge(2, {{0, 1}});
  const std::vector<Point> points = {{0, 0, 0}, {1, 1, 1}};
  const auto refusal = [&](const std::vector<Point>& vertices, const auto& bends) {
    return problem([&] { drawing_from_points("own", edge, vertices, bends); });
  };
  using Bends = std::vector<std::vector<Point>>;
  EXPECT_EQ(refusal(points, Bends()), "");
  EXPECT_EQ(refusal({{0, 0, 0}}, Bends()), "1 points for vertices are given, the graph has 2");
  EXPECT_EQ(refusal(points, Bends(2)), "2 lists of bends for edges are given, the graph has 1");
  for (const std::int64_t far : {kMaxCoordinate + 1, -kMaxCoordinate - 1, INT64_MIN}) {
    const std::string said = "the coordinate " + std::to_string(far) +
                             " does not fit, the limit is " + std::to_string(kMaxCoordinate);
    EXPECT_EQ(refusal({{0, 0, 0}, {0, far, 0}}, Bends()), said);
    EXPECT_EQ(refusal(points, Bends{{{0, 0, far}}}), said);
  }
}

TEST(Drawing, PolylineHasBothEnds) {
  const Drawing drawing = one_edge({0, 0, 0}, {{1, 1, 1}, {2, 0, 5}}, {3, 3, 0});
  std::vector<Point> points = {{9, 9, 9}};
  drawing.polyline(0, points);
  EXPECT_EQ(points, (std::vector<Point>{{0, 0, 0}, {1, 1, 1}, {2, 0, 5}, {3, 3, 0}}));
  EXPECT_EQ(bounding_box(drawing), (Box{{0, 0, 0}, {3, 3, 5}}));
  EXPECT_EQ(bounding_box(drawing), bounding_box(at_level(drawing, Level::full)));
}

TEST(Drawing, HashTellsApartWhatIsDrawnAndNothingElse) {
  Drawing drawing = one_edge({0, 0, 0}, {{1, 1, 1}}, {3, 3, 0});
  const std::string hash = drawing_hash(drawing);
  EXPECT_EQ(hash.size(), 32u);
  drawing.counters.push_back({"H", 3});
  EXPECT_EQ(drawing_hash(drawing), hash);
  EXPECT_EQ(drawing_hash(at_level(drawing, Level::full)), hash);
  EXPECT_NE(drawing_hash(one_edge({0, 0, 0}, {{1, 1, 2}}, {3, 3, 0})), hash);
  EXPECT_NE(drawing_hash(one_edge({0, 0, 0}, {}, {3, 3, 0})), hash);
  EXPECT_NE(drawing_hash(one_edge({0, 0, 0}, {{1, 1, 1}}, {3, 3, 1})), hash);
}

TEST(Drawing, HashIsThatOfItsNumbersOneByOne) {
  for (const std::int64_t bends : {0, 1, 168, 169, 170, 171, 500}) {  // 4096 bytes, less and more
    std::vector<Point> points{{1, 2, 3}};
    for (std::int64_t i = 0; i < bends; ++i) points.push_back({i, -i, 2 * i});
    points.push_back({-7, 8, 9});
    HashStream hash;
    for (const std::int64_t entry : {1, 0, 0, 0, 1, 0, 0, 0, 1}) hash.put(entry);
    hash.put(std::int64_t{1});   // the denominator
    hash.put(std::uint64_t{2});  // vertices
    for (const Point p : {points.front(), points.back()}) {
      for (const std::int64_t c : {p.x, p.y, p.z}) hash.put(c);
    }
    hash.put(std::uint32_t{0});
    hash.put(std::uint32_t{1});
    hash.put(std::uint64_t{points.size()});
    for (const Point p : points) {
      for (const std::int64_t c : {p.x, p.y, p.z}) hash.put(c);
    }
    const std::vector<Point> inner(points.begin() + 1, points.end() - 1);
    EXPECT_EQ(drawing_hash(one_edge(points.front(), inner, points.back())), hash.digest()) << bends;
  }
}

TEST(Drawing, PolylinesInBlocksAreThoseOneByOne) {
  for (const std::size_t edges : {0u, 1u, 31u, 32u, 33u, 100u}) {
    Coordinates vertices(edges + 1, 1000);
    auto ends = std::make_shared<std::vector<Edge>>();
    auto bends = std::make_shared<StoredBends>();
    for (Vertex v = 0; v < edges; ++v) {
      vertices.set(v, {v, -std::int64_t{v}, 7});
      ends->push_back({v + 1, v});
      bends->add_edge(std::vector<Point>(v % 3, Point{1, 2, v}));
    }
    const Drawing drawing("test", kCubeLattice, std::move(vertices), ends, bends);
    EdgeId next = 0;
    std::vector<Point> expected;
    for_each_polyline(drawing, [&](EdgeId e, const std::vector<Point>& points) {
      EXPECT_EQ(e, next++);
      drawing.polyline(e, expected);
      EXPECT_EQ(points, expected);
    });
    EXPECT_EQ(next, drawing.num_edges());
  }
}

TEST(Drawing, EmptyDrawingHasNoExtent) {
  const Drawing drawing("test", kCubeLattice, Coordinates(0, 0),
                        std::make_shared<std::vector<Edge>>(), nullptr);
  EXPECT_EQ(bounding_box(drawing).extents(), (std::array<std::int64_t, 3>{0, 0, 0}));
}

TEST(Drawing, RefusesForeignVertices) {
  auto edges = std::make_shared<std::vector<Edge>>(1, Edge{0, 2});
  EXPECT_THROW(
      Drawing("test", kCubeLattice, Coordinates(2, 0), edges, std::make_shared<StoredBends>()),
      InputError);
  *edges = {{0, 1}, {1, 3}, {2, 3}};
  EXPECT_EQ(problem([&] {
              const Drawing refused("test", kCubeLattice, Coordinates(3, 0), edges,
                                    std::make_shared<StoredBends>());
            }),
            "edge 1 (1, 3) of the drawing: vertex out of range, it has 3 vertices");
}

TEST(Coordinates, WidthFollowsTheBound) {
  Coordinates narrow(1, 100);
  EXPECT_THROW(narrow.set(0, {101, 0, 0}), InternalError);
  narrow.set(0, {100, -100, 7});
  EXPECT_EQ(narrow[0], (Point{100, -100, 7}));
  Coordinates wide(1, std::int64_t{1} << 40);
  wide.set(0, {std::int64_t{1} << 40, 0, -1});
  EXPECT_EQ(wide[0], (Point{std::int64_t{1} << 40, 0, -1}));
  EXPECT_THROW(Coordinates(1, kMaxCoordinate + 1), InputError);
}

TEST(Coordinates, FillSetsARangeAndKeepsTheBound) {
  for (const std::int64_t bound :
       {std::int64_t{100}, std::int64_t{70'000}, std::int64_t{1} << 40}) {
    Coordinates points(5, bound);
    points.fill(1, 4, [&](std::size_t i) {
      return Point{bound, -bound, static_cast<std::int64_t>(i)};
    });
    for (std::size_t i = 0; i < 5; ++i) {
      const bool filled = i >= 1 && i < 4;
      EXPECT_EQ(points[i], filled ? (Point{bound, -bound, static_cast<std::int64_t>(i)}) : Point{});
    }
    for (const std::int64_t beyond : {bound + 1, -bound - 1}) {
      EXPECT_THROW(points.fill(0, 1,
                               [&](std::size_t) {
                                 return Point{0, beyond, 0};
                               }),
                   InternalError);
    }
  }
}

}  // namespace
}  // namespace ar3d::testing
