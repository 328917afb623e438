// Places, words, strips; the proof's zones: their count, their size, the theorem's constants.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "algorithms/strips_support.h"
#include "ar3d/generators/catalog.h"
#include "support/graphs.h"

namespace ar3d::compact_120 {
namespace {

constexpr std::array<Class, 3> kClasses = {Class::n, Class::s, Class::t};

TEST(Compact120Sites, AreReadBackFromPointsOfThePlane) {
  for (std::int32_t column = 0; column < 20; ++column) {
    for (std::int32_t row = 0; row < 12; ++row) {
      for (const Class of : kClasses) {
        const Site site{column, row, of};
        const Quad at = quad_of(site);
        EXPECT_EQ(height(at), 0);
        EXPECT_EQ(at[0] + at[1] + at[2] + at[3], 0);
        EXPECT_EQ(site_of(to_point(at)), site);
        EXPECT_GE(slant(site), 4 * row - 1);
        EXPECT_LE(slant(site), 4 * row + 3);
      }
    }
  }
}

/// All shapes of edges with the classes of their ends.
struct Case {
  Shape shape;
  Class tail;
  Class head;
};
std::vector<Case> all_cases() {
  std::vector<Case> cases;
  for (const bool right : {true, false}) {
    for (const Class tail : {Class::n, right ? Class::s : Class::t}) {
      for (const Class head : {Class::n, right ? Class::t : Class::s}) {
        for (const Arm arm : {k12, (head == Class::n) == right ? k20 : k01}) {
          const Arrival at = arrival_on(arm, head);
          for (unsigned i = 0; i < variants(at); ++i) cases.push_back({{right, at, i}, tail, head});
        }
      }
    }
  }
  return cases;
}

TEST(Compact120Words, JoinTheirEndsWithTheLengthsOfTheTable) {
  EXPECT_EQ(all_cases().size(), 20u);
  for (const auto& [shape, tail_class, head_class] : all_cases()) {
    const Site tail{10, 2, tail_class};
    const Site head{shape.right ? 15 : 5, 4, head_class};
    const Quad from = quad_of(tail);
    const Quad to = quad_of(head);
    const Route route(shape, from, to);
    EXPECT_TRUE(route.fits());
    std::vector<Point> points = {to_point(from)};
    route.append_bends(points);
    points.push_back(to_point(to));
    ASSERT_EQ(points.size(), 7u);
    const Word word = word_of(shape);
    Quad at = from;
    for (std::size_t i = 0; i < 6; ++i) {
      const std::int32_t length = i % 2 == 0 ? route.lengths()[i / 2] : 1;
      step(at, word[i], length);
      EXPECT_EQ(to_point(at), points[i + 1]);
      if (i > 0) {  // Lemma D.1
        EXPECT_NE(word[i], word[i - 1]);
        EXPECT_TRUE(word[i].gain == word[i - 1].gain || word[i].lose == word[i - 1].lose);
      }
    }
    const std::int32_t across = std::abs(to[0] - from[0]);
    const std::int32_t d = slant(head) - slant(tail);
    const std::int32_t shallow = 3 * across / 2 - d;
    const std::int32_t deep = 5 * across / 2 + d;
    std::array<std::int32_t, 3> lengths = {across, deep, shallow - 1};
    const Arrival seen = shape.right ? shape.at : mirrored(shape.at);
    if (seen == Arrival::on_12 && shape.variant == 0) lengths = {across + 1, deep + 1, shallow - 3};
    if (seen == Arrival::on_20) lengths = {across, shallow - 1, deep};
    if (seen == Arrival::on_01) lengths = {5 * across / 2 - d, deep - 1, shallow};
    EXPECT_EQ(route.lengths(), lengths);
  }
}

TEST(Compact120Strip, GivesBackWhatAVertexUsed) {
  const Graph graph = generate(find_family("random-cubic"), 60, 1);
  const NarrowOrder order = narrow_order(graph, strips::NumbersAhead(1));
  Census census;
  std::optional<Strip> strip =
      fill_narrow_strip(order, graph.num_edges(), {}, strips::NumbersAhead(1), census);
  ASSERT_TRUE(strip);
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    const Site site = strip->site(v);
    EXPECT_FALSE(strip->fits(v, site)) << "taken by itself";
    strip->remove(v);
    EXPECT_FALSE(strip->is_placed(v));
    ASSERT_TRUE(strip->try_place(v, site)) << "the edges' first variants may differ, but one fits";
  }
}

TEST(Compact120Strip, IsGivenUpAfterItsEjections) {
  const Graph graph = generate(find_family("random-cubic"), 200, 1);
  const NarrowOrder order = narrow_order(graph, strips::NumbersAhead(1));
  Census census;
  const Tightness tight{.cells = 15, .ejections = 50};
  EXPECT_FALSE(fill_narrow_strip(order, graph.num_edges(), tight, strips::NumbersAhead(1), census));
  EXPECT_LE(census.ejections, 100 + 20);
  EXPECT_LE(census.trials, 12 * (200 + 2 * 120 + 1));
  EXPECT_GT(narrow_size(order, strips::widened(tight)).columns, narrow_size(order, tight).columns);
}

TEST(Compact120Zones, KeepTheTheoremsBoxForEverySize) {
  const auto size_of = [](const auto& sizes, std::int64_t n) {
    const StripSize size = lay_out_zones(sizes).size;
    EXPECT_LE(size.columns, 36.14 * std::sqrt(static_cast<double>(n)) + 801);
    return size;
  };
  testing::expect_zones_fit(testing::compact_120_strips(), 76, 300, size_of, box_of);
}

/// Fills the zones, every vertex in its first (or last) free place, and compares the closed places
/// with the count of the proof.
void expect_count_holds(const Graph& graph, bool from_left) {
  const Order order = moved_order(graph);
  const Links links = assign_arms(graph, order, choose_owners(graph, order));
  const Order levels = in_levels(graph, order);
  const std::vector<std::int64_t> sizes = strips::sizes_of(levels.rank);
  const Zones zones = lay_out_zones(sizes);
  Strip strip(links, graph.num_edges(), zones.size, true);
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    const std::uint32_t level = levels.rank[v];
    const std::int32_t places = zones.width[level] * zones.size.rows;
    std::vector<Site> sites;
    for (std::int32_t i = 0; i < places; ++i) {
      const std::int32_t place = from_left ? i : places - 1 - i;
      sites.push_back(
          {zones.begin[level] + place / zones.size.rows, place % zones.size.rows, links.of[v]});
    }
    const std::int64_t most = most_closed_cells(sizes[level], zones.size.rows);
    ASSERT_NO_FATAL_FAILURE(testing::expect_few_closed(strip, v, sites, most));
  }
}

TEST(Compact120Zones, HaveNoMoreClosedPlacesThanTheProofCounts) {
  for (const Family& family : families()) {
    if (family.max_degree > 3) continue;
    for (const bool from_left : {true, false}) {
      expect_count_holds(generate(family, 100, 2), from_left);
    }
  }
  expect_count_holds(generate(find_family("random-cubic"), 3000, 2), true);
}

}  // namespace
}  // namespace ar3d::compact_120
