#include "ar3d/verify/metrics/metrics.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/verify/examination.h"
#include "ar3d/verify/metrics/summary_pass.h"
#include "verify/random_drafts.h"

namespace ar3d::testing {
namespace {

using ::testing::ElementsAre;

MetricValue value_of(const std::string& name, const DrawingSummary& summary) {
  for (const Metric& metric : metrics()) {
    if (metric.name == name) return metric.value(summary);
  }
  throw std::runtime_error("no metric " + name);
}

TEST(Metrics, OfADrawingByHand) {
  Draft draft;
  draft.vertices = {{0, 0, 0}, {4, 4, 0}, {10, 0, 0}};
  draft.edges = {{{0, 1}, {{2, 2, 2}}}, {{1, 2}, {}}};
  const DrawingSummary summary = measure(draft.drawing());
  EXPECT_THAT(summary.box.extents(), ElementsAre(10, 4, 2));
  EXPECT_THAT(summary.bend_histogram, ElementsAre(1, 1));
  EXPECT_EQ(summary.segments, 3u);
  EXPECT_DOUBLE_EQ(summary.total_edge_length, 4 * std::sqrt(3.0) + std::sqrt(52.0));
  EXPECT_DOUBLE_EQ(summary.longest_edge_length, std::sqrt(52.0));
  EXPECT_DOUBLE_EQ(summary.smallest_vertex_distance, std::sqrt(32.0));
  EXPECT_DOUBLE_EQ(std::get<double>(value_of("log2_volume", summary)),
                   std::log2(11) + std::log2(5) + std::log2(3));
}

TEST(Metrics, LengthsAreThoseOfTheLattice) {
  Draft draft;
  draft.lattice = kScaledZLattice;
  draft.vertices = {{0, 0, 0}, {0, 0, 3}, {2, 0, 0}};
  draft.edges = {{{0, 1}, {}}};
  const DrawingSummary summary = measure(draft.drawing());
  EXPECT_DOUBLE_EQ(summary.total_edge_length, std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(summary.smallest_vertex_distance, std::sqrt(3.0));  // less than 2
}

TEST(Metrics, WhatDoesNotExistIsMissing) {
  const DrawingSummary empty = measure(Draft{}.drawing());
  EXPECT_TRUE(std::isnan(empty.smallest_vertex_distance));
  EXPECT_EQ(empty.total_edge_length, 0);
  EXPECT_EQ(std::get<double>(value_of("log2_volume", empty)), 0);
}

TEST(Metrics, OfACoordinateOutOfRangeAreMissing) {
  Draft draft;
  draft.vertices = {{0, 0, 0}, {4, 4, 0}, {10, 0, 0}};
  draft.edges = {{{0, 1}, {{2, 2, std::numeric_limits<std::int64_t>::max()}, {0, 0, -3}}},
                 {{1, 2}, {}}};
  const DrawingSummary summary = measure(draft.drawing());
  EXPECT_FALSE(summary.in_range);
  for (const Metric& metric : metrics()) {
    if (metric.name.starts_with("bends_")) continue;
    const MetricValue value = metric.value(summary);
    if (const auto* number = std::get_if<double>(&value)) {
      EXPECT_TRUE(std::isnan(*number)) << metric.name;
    } else {
      EXPECT_EQ(std::get<std::int64_t>(value), -1) << metric.name;
    }
  }
}

TEST(Metrics, TableIsComplete) {
  std::set<std::string> names;
  DrawingSummary summary;
  summary.box = {{0, 0, 0}, {7, 8, 9}};
  summary.bend_histogram = {10, 11, 12, 13, 14, 15, 16, 17, 18};
  for (const Metric& metric : metrics()) {
    EXPECT_TRUE(names.insert(metric.name).second) << metric.name;
    EXPECT_FALSE(metric.unit.empty() || metric.definition.empty()) << metric.name;
    const MetricValue value = metric.value(summary);
    EXPECT_EQ(metric.type == MetricType::int64, std::holds_alternative<std::int64_t>(value))
        << metric.name;
  }
  EXPECT_EQ(metric_values(summary).size(), metrics().size());
  EXPECT_EQ(value_of("extent_x", summary), MetricValue(std::int64_t{7}));
  EXPECT_EQ(value_of("extent_z", summary), MetricValue(std::int64_t{9}));
  EXPECT_EQ(value_of("bends_0", summary), MetricValue(std::int64_t{10}));
  EXPECT_EQ(value_of("bends_6", summary), MetricValue(std::int64_t{16}));
  EXPECT_EQ(value_of("bends_7", summary), MetricValue(std::int64_t{35}));
}

/// Comparable although missing numbers are NaN.
std::vector<std::string> texts(const std::vector<MetricValue>& values) {
  std::vector<std::string> result;
  for (const MetricValue& value : values) {
    result.push_back(std::visit([](auto number) { return fmt::format("{}", number); }, value));
  }
  return result;
}

/// What examine() tells in one pass is what the functions of its parts tell one by one.
TEST(Examination, IsItsParts) {
  RandomDrafts drafts(11, 3);
  for (std::uint32_t i = 0; i < 300; ++i) {
    const auto& directions = direction_sets()[i % direction_sets().size()];
    const Draft draft = drafts.walks(directions, 1 + i % 20, 12);
    const Drawing drawing = draft.drawing();
    const Guarantee guarantee = no_promise();
    const Examination all = examine(draft.graph(), drawing, guarantee);
    const Certificate certificate = certify(draft.graph(), drawing, guarantee);
    EXPECT_EQ(all.certificate.valid(), certificate.valid());
    EXPECT_EQ(all.certificate.violations.size(), certificate.violations.size());
    EXPECT_EQ(all.certificate.box, bounding_box(drawing));
    EXPECT_EQ(all.drawing_hash, drawing_hash(drawing));
    EXPECT_EQ(texts(metric_values(all.summary)), texts(metric_values(measure(drawing))));
  }
}

/// Counts how often an edge's bends are read.
class CountingBends final : public BendSource {
 public:
  explicit CountingBends(std::shared_ptr<const BendSource> source) : source_(std::move(source)) {}
  void append_bends(EdgeId e, Edge ends, Point at_u, Point at_v,
                    std::vector<Point>& out) const override {
    ++reads;
    source_->append_bends(e, ends, at_u, at_v, out);
  }
  mutable std::size_t reads = 0;

 private:
  std::shared_ptr<const BendSource> source_;
};

/// Certificate, metrics and hash of a right drawing take one pass over its polylines.
TEST(Examination, ReadsEveryPolylineOnce) {
  for (const char* name : {"diamond", "grid", "two-bend", "compact", "compact-120"}) {
    const Algorithm& algorithm = find_algorithm(name);
    const Graph graph = generate(find_family("random-cubic"), 200, 1);
    const Drawing drawn = draw(algorithm, graph);
    const auto bends = std::make_shared<CountingBends>(drawn.shared_bends());
    Coordinates vertices(drawn.num_vertices(), kMaxCoordinate);
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      vertices.set(v, drawn.vertex(static_cast<Vertex>(v)));
    }
    const Drawing drawing(drawn.algorithm(), drawn.lattice(), std::move(vertices),
                          drawn.shared_edges(), bends);
    EXPECT_TRUE(examine(graph, drawing, algorithm.guarantee).certificate.valid()) << name;
    EXPECT_EQ(bends->reads, drawing.num_edges()) << name;
  }
}

TEST(Examination, LeavesOutWhatIsNotWanted) {
  Draft draft;
  draft.vertices = {{0, 0, 0}, {4, 4, 0}};
  draft.edges = {{{0, 1}, {{2, 2, 2}}}};
  const Examination nothing = examine(draft.graph(), draft.drawing(), no_promise(),
                                      {.certificate = false, .metrics = false, .hash = false});
  EXPECT_TRUE(nothing.drawing_hash.empty());
  EXPECT_TRUE(std::isnan(nothing.summary.total_edge_length));
  EXPECT_EQ(nothing.certificate.segments, 0u);
  EXPECT_FALSE(nothing.certificate.complete) << "nothing was judged";
}

double squared_distance(const Drawing& drawing, verify::VertexPair pair) {
  const Vector apart = drawing.vertex(pair.first) - drawing.vertex(pair.second);
  const double length = approximate_length(drawing.lattice(), apart);
  return length * length;
}

void expect_closest(const Draft& draft) {
  const Drawing drawing = draft.drawing();
  const auto pair = verify::closest_pair(drawing);
  ASSERT_TRUE(pair.has_value());
  ASSERT_NE(pair->first, pair->second);
  double smallest = INFINITY;
  for (Vertex v = 0; v < drawing.num_vertices(); ++v) {
    for (Vertex u = 0; u < v; ++u) smallest = std::min(smallest, squared_distance(drawing, {u, v}));
  }
  ASSERT_NEAR(squared_distance(drawing, *pair), smallest, smallest * 1e-9);
  const auto plain = verify::closest_pair_by_tree(drawing);
  ASSERT_EQ(squared_distance(drawing, *pair), squared_distance(drawing, *plain));
}

TEST(ClosestPair, IsTheBestOfAllPairs) {
  RandomStream random(7);
  const Lattice skew{{{{5, 2, -1}, {2, 4, 1}, {-1, 1, 3}}}, 2};
  for (const Lattice& lattice : {kCubeLattice, kScaledZLattice, skew}) {
    for (int i = 0; i < 300; ++i) {
      Draft draft;
      draft.lattice = lattice;
      const std::uint32_t n = 2 + random.below(60);
      const std::uint32_t side = 1 + random.below(i % 3 == 0 ? 10 : 1000);
      const std::uint32_t height = i % 2 == 0 ? 1 : side;
      for (std::uint32_t v = 0; v < n; ++v) {
        draft.vertices.push_back({std::int64_t{random.below(side)} - side / 2, random.below(side),
                                  random.below(height)});
      }
      ASSERT_NO_FATAL_FAILURE(expect_closest(draft)) << i;
      ASSERT_NO_FATAL_FAILURE(expect_closest(RandomDrafts::far_away(draft))) << i;
    }
  }
}

TEST(ClosestPair, StripsGiveUpOnWhatTheyAreNotMadeFor) {
  Draft cloud;  // in space: a slab of strips has too many vertices that are near along one axis
  for (std::int64_t i = 0; i < 17 * 17 * 17; ++i) {
    cloud.vertices.push_back({i % 17 * 100, i / 17 % 17 * 100, i / 289 * 100});
  }
  EXPECT_FALSE(verify::closest_pair_by_strips(cloud.drawing()).has_value());
  ASSERT_NO_FATAL_FAILURE(expect_closest(cloud));
  Draft far;
  far.vertices = {{0, 0, 0}, {std::int64_t{1} << 41, 0, 0}};
  EXPECT_FALSE(verify::closest_pair_by_strips(far.drawing()).has_value());
  far.vertices = {{0, 0, 0}, {1 << 20, 1, 0}};
  EXPECT_FALSE(verify::closest_pair_by_strips(far.drawing()).has_value());
  EXPECT_TRUE(verify::closest_pair(far.drawing()).has_value());
}

/// Coordinates of any size, up to the largest: only how far apart the closest are matters.
TEST(ClosestPair, StripsTakeLargeCoordinates) {
  RandomStream random(9);
  const Lattice skew{{{{5, 2, -1}, {2, 4, 1}, {-1, 1, 3}}}, 2};
  const Lattice large{{{{1 << 29, 2, -1}, {2, 1 << 30, 1}, {-1, 1, 1 << 20}}}, 2};
  for (const Lattice& lattice : {kCubeLattice, kScaledZLattice, skew, large}) {
    for (int i = 0; i < 100; ++i) {
      Draft draft;
      draft.lattice = lattice;
      const std::int64_t far = kMaxCoordinate >> random.below(40);
      for (int v = 0; v < 60; ++v) {
        // Few places far from each other, and near each of them some vertices.
        const auto end = [&] { return random.below(2) == 0 ? far : -far; };
        const auto inwards = [&](std::int64_t c) {
          const std::int64_t step = random.below(400);
          return c > 0 ? c - step : c + step;
        };
        const Point p{inwards(end()), inwards(end()), inwards(end())};
        if (std::find(draft.vertices.begin(), draft.vertices.end(), p) == draft.vertices.end()) {
          draft.vertices.push_back(p);
        }
      }
      const Drawing drawing = draft.drawing();
      const auto strips = verify::closest_pair_by_strips(drawing);
      const auto tree = verify::closest_pair_by_tree(drawing);
      ASSERT_TRUE(tree.has_value());
      if (lattice.gram == large.gram && !strips) continue;  // no two may be near enough there
      ASSERT_TRUE(strips.has_value()) << i;
      ASSERT_EQ(squared_distance(drawing, *strips), squared_distance(drawing, *tree)) << i;
    }
  }
}

TEST(ClosestPair, ComparesExactlyWhereDoublesCannot) {
  const std::int64_t far = kMaxCoordinate;
  Draft draft;  // the pairs' distances differ by 1 in 2^61
  draft.vertices = {{-far, 0, 0}, {0, 0, 0}, {far - 1, 0, 0}};
  const auto sum = [](const Draft& of) {
    const auto [u, v] = verify::closest_pair(of.drawing()).value();
    return u + v;
  };
  EXPECT_EQ(sum(draft), 3u);
  draft.vertices = {{1 - far, 0, 0}, {0, 0, 0}, {far, 0, 0}};
  EXPECT_EQ(sum(draft), 1u);
  draft.vertices = {{-far, -far, -far}, {far, far, far}, {far, far, -far}};  // 2^62 apart and more
  ASSERT_NO_FATAL_FAILURE(expect_closest(draft));
}

}  // namespace
}  // namespace ar3d::testing
