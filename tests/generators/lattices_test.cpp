#include <gtest/gtest.h>

#include "ar3d/generators/catalog.h"
#include "ar3d/generators/families.h"
#include "ar3d/verify/certificate.h"
#include "support/graph_facts.h"

namespace ar3d::testing {
namespace {

void expect_straight(const auto& piece, std::uint32_t max_degree, Cosine vertex_angle) {
  CertifyOptions options;
  options.check_size = false;
  const Guarantee guarantee = {
      .max_degree = max_degree, .max_bends = 0, .cosine = vertex_angle, .lattice = kCubeLattice};
  const Certificate made = certify(
      piece.first, drawing_from_points("lattice", piece.first, piece.second), guarantee, options);
  EXPECT_TRUE(made.valid()) << made.violations.front().message;
}

TEST(Lattices, PiecesAreCertifiedWithoutBends) {
  for (const Count n : {1u, 2u, 30u, 700u}) {
    expect_straight(diamond_lattice_piece(n), 4, {-1, 3});
    expect_straight(laves_piece(n), 3, {-1, 2});
  }
}

TEST(Lattices, PiecesHaveTheGirthOfTheirLattice) {
  EXPECT_EQ(girth(diamond_lattice_piece(200).first), 6u);
  EXPECT_EQ(girth(laves_piece(400).first), 10u);
  EXPECT_TRUE(bipartite(diamond_lattice_piece(200).first));
  EXPECT_EQ(degree_counts(laves_piece(400).first).rbegin()->first, 3u);
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
