#include "ar3d/model/boost_graph.h"

#include <boost/concept/assert.hpp>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/adjacency_matrix.hpp>
#include <boost/graph/biconnected_components.hpp>
#include <boost/graph/boyer_myrvold_planar_test.hpp>
#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/filtered_graph.hpp>
#include <boost/graph/graph_concepts.hpp>
#include <boost/graph/isomorphism.hpp>

#include "support/graphs.h"

namespace ar3d::testing {
namespace {

BOOST_CONCEPT_ASSERT((boost::concepts::VertexListGraphConcept<Graph>));
BOOST_CONCEPT_ASSERT((boost::concepts::EdgeListGraphConcept<Graph>));
BOOST_CONCEPT_ASSERT((boost::concepts::IncidenceGraphConcept<Graph>));
BOOST_CONCEPT_ASSERT((boost::concepts::AdjacencyGraphConcept<Graph>));
BOOST_CONCEPT_ASSERT((boost::concepts::BidirectionalGraphConcept<Graph>));

TEST(BoostGraph, AlgorithmsRun) {
  const Graph g = disjoint_union({petersen(), path(3)});
  std::vector<int> component(g.num_vertices());
  EXPECT_EQ(boost::connected_components(g, component.data()), 2);
  std::vector<Vertex> cut;
  boost::articulation_points(g, std::back_inserter(cut));
  EXPECT_EQ(cut, std::vector<Vertex>{11});
  std::vector<std::size_t> block(g.num_edges());
  EXPECT_EQ(boost::biconnected_components(
                g, boost::make_iterator_property_map(block.begin(), get(boost::edge_index, g))),
            3u);
  EXPECT_FALSE(boost::boyer_myrvold_planarity_test(petersen()));
  EXPECT_TRUE(boost::boyer_myrvold_planarity_test(octahedron()));
  const std::vector<Vertex> reversed = {9, 8, 7, 6, 5, 4, 3, 2, 1, 0};
  EXPECT_TRUE(boost::isomorphism(petersen(), relabelled(petersen(), reversed)));
  EXPECT_FALSE(boost::isomorphism(petersen(), disjoint_union({octahedron(), cycle(4)})));
}

TEST(BoostGraph, BuildsFromBoostGraphs) {
  boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS> list(4);
  add_edge(0, 1, list);
  add_edge(3, 1, list);
  const Graph from_list = from_boost(list);
  EXPECT_EQ(from_list.num_vertices(), 4u);
  EXPECT_EQ(from_list.edge(1), (Edge{1, 3}));
  boost::adjacency_matrix<boost::undirectedS> matrix(3);
  add_edge(0, 2, matrix);
  EXPECT_EQ(from_boost(matrix).num_edges(), 1u);
  const Graph itself = from_boost(petersen());
  EXPECT_EQ(graph_hash(itself), graph_hash(petersen()));
  add_edge(1, 0, list);
  EXPECT_THROW(from_boost(list), InputError);
}

TEST(BoostGraph, IndexMapsNumberTheVerticesThatThereAre) {
  const Graph eight = cycle(8);
  const std::function<bool(Vertex)> is_low = [](Vertex v) { return v < 4; };
  const std::function<bool(Vertex)> is_high = [](Vertex v) { return v >= 4; };
  const auto kept = [&](const std::function<bool(Vertex)>& keeps) {
    return boost::filtered_graph<Graph, boost::keep_all, std::function<bool(Vertex)>>(eight, {},
                                                                                      keeps);
  };
  const Graph low = from_boost(kept(is_low));
  EXPECT_EQ(low.num_vertices(), 4u);
  EXPECT_EQ(low.num_edges(), 3u);
  EXPECT_THROW(from_boost(kept(is_high)), InputError);
  const auto shifted = boost::make_function_property_map<Vertex>([](Vertex v) { return v - 4; });
  EXPECT_EQ(graph_hash(from_boost(kept(is_high), shifted)), graph_hash(low));
  for (const std::uint64_t too_large : {UINT64_C(1) << 32, UINT64_C(5000000000), UINT64_C(8)}) {
    const auto map = boost::make_function_property_map<Vertex>(
        [=](Vertex v) { return v == 0 ? too_large : std::uint64_t{v}; });
    EXPECT_THROW(from_boost(eight, map), InputError) << too_large;
  }
  const auto constant = boost::make_function_property_map<Vertex>([](Vertex) { return 1; });
  EXPECT_THROW(from_boost(eight, constant), InputError);
}

}  // namespace
}  // namespace ar3d::testing
