#include <gtest/gtest.h>

#include <algorithm>
#include <boost/graph/boyer_myrvold_planar_test.hpp>
#include <map>
#include <utility>
#include <vector>

#include "ar3d/base/error.h"
#include "ar3d/generators/families.h"
#include "ar3d/model/boost_graph.h"
#include "support/graph_facts.h"
#include "support/names.h"

namespace ar3d::testing {
namespace {

/// The neighbours of each vertex in their order around it; a 3-connected planar graph has one such
/// order and its mirror image.
using Embedding = std::vector<std::vector<Vertex>>;

Embedding embedding_of(const Graph& graph) {
  std::vector<std::vector<BoostEdge>> around(graph.num_vertices());
  EXPECT_TRUE(
      boost::boyer_myrvold_planarity_test(boost::boyer_myrvold_params::graph = graph,
                                          boost::boyer_myrvold_params::embedding = around.data()));
  Embedding result(graph.num_vertices());
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    for (const BoostEdge& e : around[v]) result[v].push_back(graph.other_end(e.id, v));
  }
  return result;
}

std::size_t place_of(const std::vector<Vertex>& list, Vertex v) {
  return static_cast<std::size_t>(std::find(list.begin(), list.end(), v) - list.begin());
}

/// Lengths of the faces of a cubic embedding -> how many.
std::map<std::size_t, std::size_t> faces_of(const Embedding& embedding) {
  std::map<std::size_t, std::size_t> faces;
  std::vector<std::vector<bool>> seen(embedding.size(), std::vector<bool>(3, false));
  for (Vertex start = 0; start < embedding.size(); ++start) {
    for (std::size_t first = 0; first < 3; ++first) {
      std::size_t length = 0;
      Vertex v = start;
      for (std::size_t at = first; !seen[v][at]; ++length) {
        seen[v][at] = true;
        const Vertex next = embedding[v][at];
        at = (place_of(embedding[next], v) + 1) % 3;
        v = next;
      }
      if (length > 0) ++faces[length];
    }
  }
  return faces;
}

/// Does an automorphism keep the order around each vertex (turn = 1) or mirror it (2), with the
/// edge from vertex 0 to its first neighbour becoming the edge from `image` to its neighbour
/// `place`? Such a map is determined by these.
bool is_symmetry(const Embedding& embedding, Vertex image, std::size_t place, std::size_t turn) {
  const auto unset = static_cast<Vertex>(embedding.size());
  std::vector<Vertex> to(embedding.size(), unset);
  std::vector<std::size_t> shift(embedding.size(), 0);  // where the first neighbour goes
  std::vector<Vertex> queue = {0};
  to[0] = image;
  shift[0] = place;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const Vertex v = queue[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const Vertex next = embedding[v][k];
      const Vertex next_image = embedding[to[v]][(shift[v] + turn * k) % 3];
      const std::size_t back = place_of(embedding[next], v);
      const std::size_t back_image = place_of(embedding[next_image], to[v]);
      const std::size_t next_shift = (back_image + 3 * turn - turn * back) % 3;
      if (to[next] == unset) {
        to[next] = next_image;
        shift[next] = next_shift;
        queue.push_back(next);
      } else if (to[next] != next_image || shift[next] != next_shift) {
        return false;
      }
    }
  }
  std::sort(to.begin(), to.end());
  return std::adjacent_find(to.begin(), to.end()) == to.end();
}

std::size_t symmetries(const Embedding& embedding, std::size_t turn) {
  std::size_t count = 0;
  for (Vertex v = 0; v < embedding.size(); ++v) {
    for (std::size_t place = 0; place < 3; ++place) {
      count += is_symmetry(embedding, v, place, turn) ? 1 : 0;
    }
  }
  return count;
}

class GoldbergCoxeter : public ::testing::TestWithParam<std::pair<Count, Count>> {};

TEST_P(GoldbergCoxeter, IsAFullereneWithTheRotationsOfTheIcosahedron) {
  const auto [a, b] = GetParam();
  const Count size = a * a + a * b + b * b;
  const Graph graph = goldberg_coxeter(a, b);
  ASSERT_EQ(graph.num_vertices(), 20 * size);
  ASSERT_EQ(graph.num_edges(), 30 * size);
  for (Vertex v = 0; v < graph.num_vertices(); ++v) ASSERT_EQ(graph.degree(v), 3u);
  const Embedding embedding = embedding_of(graph);
  std::map<std::size_t, std::size_t> faces = {{5, 12}};
  if (size > 1) faces[6] = 10 * (size - 1);
  EXPECT_EQ(faces_of(embedding), faces);
  EXPECT_EQ(symmetries(embedding, 1), 60u);
  EXPECT_EQ(symmetries(embedding, 2), b == 0 || a == b ? 60u : 0u);
  if (size <= 4) {
    EXPECT_EQ(connectivity(graph, 4), 3u);
  }
}

INSTANTIATE_TEST_SUITE_P(Small, GoldbergCoxeter,
                         ::testing::Values(std::pair{1, 0}, std::pair{1, 1}, std::pair{2, 0},
                                           std::pair{2, 1}, std::pair{3, 0}, std::pair{2, 2},
                                           std::pair{3, 1}, std::pair{3, 2}, std::pair{4, 1},
                                           std::pair{5, 2}, std::pair{3, 3}, std::pair{5, 3},
                                           std::pair{4, 0}, std::pair{6, 5}, std::pair{7, 1}),
                         named("a_b"));

TEST(Fullerenes, RefuseOtherPairs) {
  EXPECT_THROW(goldberg_coxeter(0, 0), InputError);
  EXPECT_THROW(goldberg_coxeter(1, 2), InputError);
  EXPECT_THROW(goldberg_coxeter(8001, 0), InputError);
}

TEST(Fullerenes, TubesArePlanarWithoutShortCycles) {
  for (const Graph& graph : {nanotube(5, 4), nanotube(6, 3)}) {
    EXPECT_TRUE(planar(graph));
    EXPECT_EQ(girth(graph), 5u);
    EXPECT_EQ(graph.max_degree(), 3u);
    EXPECT_EQ(2 * graph.num_edges(), 3 * graph.num_vertices());
  }
  EXPECT_EQ(diameter(goldberg_coxeter(1, 0)), 5u);  // the dodecahedron
  EXPECT_EQ(diameter(nanotube(5, 1)), 5u);
}

}  // namespace
}  // namespace ar3d::testing
