#include "ar3d/generators/lattices.h"

#include <gtest/gtest.h>

#include "ar3d/generators/catalog.h"
#include "ar3d/verify/certificate.h"
#include "support/graph_facts.h"

namespace ar3d::testing {
namespace {

Guarantee straight(std::uint32_t max_degree, Cosine vertex_angle) {
  Guarantee guarantee;
  guarantee.max_degree = max_degree;
  guarantee.max_bends = 0;
  guarantee.cosine = vertex_angle;
  return guarantee;
}

TEST(Lattices, PiecesAreCertifiedWithoutBends) {
  CertifyOptions options;
  options.check_size = false;
  for (const Count n : {1u, 2u, 30u, 700u}) {
    const LatticePiece diamond = diamond_lattice_piece(n);
    const Certificate tetrahedral = certify(
        diamond.graph, straight_drawing(diamond, "diamond-lattice"), straight(4, {-1, 3}), options);
    EXPECT_TRUE(tetrahedral.valid()) << n << ": " << tetrahedral.violations.front().message;
    const LatticePiece laves = laves_piece(n);
    const Certificate flat =
        certify(laves.graph, straight_drawing(laves, "laves-graph"), straight(3, {-1, 2}), options);
    EXPECT_TRUE(flat.valid()) << n << ": " << flat.violations.front().message;
  }
}

TEST(Lattices, PiecesHaveTheGirthOfTheirLattice) {
  EXPECT_EQ(girth(diamond_lattice_piece(200).graph), 6u);
  EXPECT_EQ(girth(laves_piece(400).graph), 10u);
  EXPECT_TRUE(bipartite(diamond_lattice_piece(200).graph));
  EXPECT_EQ(degree_counts(laves_piece(400).graph).rbegin()->first, 3u);
}

TEST(Lattices, OwnDrawingIsThatOfTheGeneratedGraph) {
  for (const char* name : {"diamond-lattice", "laves-graph"}) {
    const Family& family = find_family(name);
    const Graph graph = generate(family, 100, 1);
    ASSERT_NE(family.own_drawing, nullptr);
    const Drawing drawing = family.own_drawing(100, 1, {});
    ASSERT_EQ(drawing.num_edges(), graph.num_edges());
    for (EdgeId e = 0; e < graph.num_edges(); ++e) EXPECT_EQ(drawing.edge(e), graph.edge(e));
  }
}

}  // namespace
}  // namespace ar3d::testing
