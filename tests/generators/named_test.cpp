
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "ar3d/base/error.h"
#include "ar3d/generators/families.h"
#include "support/graph_facts.h"

namespace ar3d::testing {
namespace {

const NamedGraph& find_named_graph(const std::string& name) {
  const auto at = std::ranges::find(named_graphs(), name, &NamedGraph::name);
  EXPECT_NE(at, named_graphs().end()) << name;
  return *at;
}

/// From the literature (Wolfram MathWorld, House of Graphs): degree, girth, diameter, bipartite,
/// planar.
struct Facts {
  std::string name;
  std::uint32_t degree;
  std::uint32_t girth;
  std::uint32_t diameter;
  bool bipartite;
  bool planar;
};

const std::vector<Facts> kFacts = {
    {"k4", 3, 3, 1, false, true},
    {"k5", 4, 3, 1, false, false},
    {"k33", 3, 4, 2, true, false},
    {"octahedron", 4, 3, 2, false, true},
    {"k44", 4, 4, 2, true, false},
    {"cube", 3, 4, 3, true, true},
    {"wagner", 3, 4, 2, false, false},
    {"petersen", 3, 5, 2, false, false},
    {"bidiakis", 3, 4, 3, false, true},
    {"franklin", 3, 4, 3, true, false},
    {"frucht", 3, 3, 4, false, true},
    {"truncated-tetrahedron", 3, 3, 3, false, true},
    {"tietze", 3, 3, 3, false, false},
    {"duerer", 3, 3, 4, false, true},
    {"chvatal", 4, 4, 2, false, false},
    {"heawood", 3, 6, 3, true, false},
    {"moebius-kantor", 3, 6, 4, true, false},
    {"tesseract", 4, 4, 4, true, false},
    {"pappus", 3, 6, 4, true, false},
    {"blanusa-1", 3, 5, 4, false, false},
    {"blanusa-2", 3, 5, 4, false, false},
    {"robertson", 4, 5, 3, false, false},
    {"desargues", 3, 6, 5, true, false},
    {"dodecahedron", 3, 5, 5, false, true},
    {"flower-snark-5", 3, 5, 4, false, false},
    {"mcgee", 3, 7, 4, false, false},
    {"nauru", 3, 6, 4, true, false},
    {"truncated-cube", 3, 3, 6, false, true},
    {"truncated-octahedron", 3, 4, 6, true, true},
    {"f26a", 3, 6, 5, true, false},
    {"holt", 4, 5, 3, false, false},
    {"coxeter", 3, 7, 4, false, false},
    {"double-star-snark", 3, 6, 4, false, false},
    {"tutte-coxeter", 3, 8, 4, true, false},
    {"dyck", 3, 6, 5, true, false},
    {"odd-4", 4, 6, 3, false, false},
    {"f40", 3, 8, 6, true, false},
    {"goldberg-snark-5", 3, 5, 6, false, false},
    {"tutte", 3, 4, 8, false, true},
    {"szekeres-snark", 3, 5, 7, false, false},
    {"watkins-snark", 3, 5, 7, false, false},
    {"gray", 3, 8, 6, true, false},
    {"c60", 3, 5, 9, false, true},
    {"truncated-dodecahedron", 3, 3, 10, false, true},
    {"harries", 3, 10, 6, true, false},
    {"balaban-10-cage", 3, 10, 6, true, false},
    {"foster", 3, 10, 8, true, false},
    {"biggs-smith", 3, 9, 7, false, false},
    {"balaban-11-cage", 3, 11, 8, false, false},
    {"ljubljana", 3, 10, 8, true, false},
    {"tutte-12-cage", 3, 12, 6, true, false},
};

TEST(NamedGraphs, HaveTheirPublishedInvariants) {
  ASSERT_EQ(kFacts.size(), named_graphs().size());
  for (const Facts& facts : kFacts) {
    const NamedGraph& named = find_named_graph(facts.name);
    const Graph graph = named.make();
    SCOPED_TRACE(facts.name);
    EXPECT_EQ(graph.num_vertices(), named.num_vertices);
    EXPECT_EQ(2 * graph.num_edges(), facts.degree * graph.num_vertices());
    EXPECT_EQ(graph.max_degree(), facts.degree);
    EXPECT_EQ(components(graph), 1u);
    EXPECT_EQ(bridges(graph), 0u);
    EXPECT_EQ(girth(graph), facts.girth);
    EXPECT_EQ(diameter(graph), facts.diameter);
    EXPECT_EQ(bipartite(graph), facts.bipartite);
    EXPECT_EQ(planar(graph), facts.planar);
  }
}

TEST(NamedGraphs, AreDistinctAndSorted) {
  std::set<std::string> names;
  Vertex last = 0;
  for (const NamedGraph& named : named_graphs()) {
    EXPECT_TRUE(names.insert(named.name).second) << named.name;
    EXPECT_GE(named.num_vertices, last) << named.name;
    last = named.num_vertices;
  }
}

TEST(Snarks, HaveNoThreeEdgeColouring) {
  for (const Graph& graph : {generalised_petersen(5, 2), find_named_graph("tietze").make(),
                             flower_snark(5), flower_snark(7), goldberg_snark(5),
                             double_star_snark(), szekeres_snark(), watkins_snark()}) {
    EXPECT_FALSE(three_edge_colourable(graph)) << graph.num_vertices();
  }
  for (const Count k : {1u, 2u, 3u}) {
    for (const Count type : {1u, 2u}) {
      EXPECT_FALSE(three_edge_colourable(blanusa_snark(k, type))) << k;
      EXPECT_EQ(girth(blanusa_snark(k, type)), 5u) << k;
    }
  }
  EXPECT_TRUE(three_edge_colourable(generalised_petersen(8, 3)));
}

TEST(Snarks, BadIndicesAreRefused) {
  EXPECT_THROW(flower_snark(6), InputError);
  EXPECT_THROW(goldberg_snark(6), InputError);
  EXPECT_THROW(goldberg_snark(3), InputError);
  EXPECT_THROW(blanusa_snark(1, 3), InputError);
  EXPECT_THROW(generalised_petersen(6, 3), InputError);
  EXPECT_THROW(lcf_graph({5, 5}, 7), InputError);
  EXPECT_THROW(lcf_graph({1}, 8), InputError);
  EXPECT_THROW(truncated(find_named_graph("k5").make()), InputError);
}

}  // namespace
}  // namespace ar3d::testing
