// The proof's zones: their count, their size, the theorem's constants.
#include <gtest/gtest.h>

#include "algorithms/strips_support.h"
#include "ar3d/generators/catalog.h"
#include "support/graphs.h"

namespace ar3d::compact {
namespace {

TEST(CompactZones, KeepTheTheoremsBoxForEverySize) {
  testing::expect_zones_fit(
      testing::compact_strips(), 5, 3000,
      [](const auto& sizes, std::int64_t) { return lay_out_zones(sizes).size; }, box_of);
}

/// All sites of zone k with the vertex's type.
std::vector<Site> sites_of_zone(const Zones& zones, std::size_t k, std::int32_t type) {
  std::vector<Site> sites;
  for (std::int32_t column = 0; column < zones.width[k]; ++column) {
    for (std::int32_t row = 0; row < zones.size.rows; ++row) {
      const std::int32_t at = zones.begin[k] + column;
      if ((at ^ row) & 1) continue;
      sites.push_back({at, row, type});
    }
  }
  return sites;
}

/// Fills the zones, every vertex in its first (or last) free cell, and compares the closed cells
/// with the count of the proof.
void expect_count_holds(const Graph& graph, bool from_left) {
  const Decomposition links = decompose(graph);
  const std::vector<std::uint8_t> colours = greedy_colours(graph);
  const std::vector<std::int64_t> sizes = strips::sizes_of(colours);
  const Zones zones = lay_out_zones(sizes);
  Strip strip(links, graph.num_edges(), zones.size, zones.cap);
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    const Vertex head = links.at[v][kGreenOut].to;
    const std::int32_t type = head != kNobody && colours[head] < colours[v] ? 1 : 0;
    std::vector<Site> sites = sites_of_zone(zones, colours[v], type);
    if (!from_left) std::reverse(sites.begin(), sites.end());
    const std::int64_t most =
        most_closed_cells(sizes[colours[v]], graph.num_vertices(), zones.size.rows, zones.cap);
    ASSERT_NO_FATAL_FAILURE(testing::expect_few_closed(strip, v, sites, most));
  }
}

TEST(CompactZones, HaveNoMoreClosedCellsThanTheProofCounts) {
  for (const Family& family : families()) {
    if (family.max_degree > 4) continue;
    for (const bool from_left : {true, false}) {
      expect_count_holds(generate(family, 60, 2), from_left);
    }
  }
  expect_count_holds(generate(find_family("random-4-regular"), 400, 2), true);
}

TEST(CompactZones, ColoursAreProper) {
  for (const Graph& graph :
       {testing::complete(5), generate(find_family("random-4-regular"), 500, 2)}) {
    const std::vector<std::uint8_t> colours = greedy_colours(graph);
    for (const Edge& edge : graph.edges()) EXPECT_NE(colours[edge.u], colours[edge.v]);
    for (const std::uint8_t colour : colours) EXPECT_LT(colour, 5);
  }
}

TEST(CompactCaps, CloseAValueAtTheCap) {
  Caps caps(2, 100);
  const Shape shape;
  const Shape other{.tail_type = 1, .right = false};
  const Letters at{5, 3, 2, 0};
  for (int i = 0; i < 2; ++i) {
    EXPECT_TRUE(caps.is_open(shape, at));
    caps.add(shape, at);
  }
  EXPECT_FALSE(caps.is_open(shape, at));
  EXPECT_FALSE(caps.is_open(shape, {6, 0, 3, 0}));  // the same AC
  EXPECT_TRUE(caps.is_open(shape, {6, 0, 2, 0}));
  EXPECT_TRUE(caps.is_open(other, at));
}

}  // namespace
}  // namespace ar3d::compact
