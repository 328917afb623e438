#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "ar3d/base/error.h"
#include "ar3d/generators/random_graphs.h"
#include "ar3d/generators/rings.h"

namespace ar3d::testing {
namespace {

std::vector<std::pair<Vertex, Vertex>> labelled(const Graph& graph) {
  std::vector<std::pair<Vertex, Vertex>> edges;
  for (const Edge e : graph.edges()) edges.emplace_back(std::minmax(e.u, e.v));
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Chi-square of `samples` draws over `classes` equally likely labelled graphs, in standard
/// deviations.
template <class Draw>
double deviation(std::uint64_t samples, std::size_t classes, Draw draw) {
  std::map<std::vector<std::pair<Vertex, Vertex>>, double> count;
  for (std::uint64_t seed = 0; seed < samples; ++seed) ++count[labelled(draw(seed))];
  EXPECT_EQ(count.size(), classes);
  const double expected = static_cast<double>(samples) / static_cast<double>(classes);
  double chi_square = 0;
  for (const auto& [graph, seen] : count)
    chi_square += (seen - expected) * (seen - expected) / expected;
  const double freedom = static_cast<double>(classes) - 1;
  return (chi_square - freedom) / std::sqrt(2 * freedom);
}

TEST(RandomRegular, UniformOverSmallLabelledGraphs) {
  // 70 labelled cubic graphs on 6 vertices (60 prisms, 10 K3,3); 15 labelled 4-regular ones
  // (octahedra).
  EXPECT_LT(deviation(20000, 70, [](auto seed) { return random_regular(6, 3, seed); }), 4.0);
  EXPECT_LT(deviation(10000, 15, [](auto seed) { return random_regular(6, 4, seed); }), 4.0);
  // 2-regular on 6 vertices: 60 hexagons and 10 pairs of triangles; perfect matchings on 6: 15.
  EXPECT_LT(deviation(20000, 70, [](auto seed) { return random_regular(6, 2, seed); }), 4.0);
  EXPECT_LT(deviation(10000, 15, [](auto seed) { return random_regular(6, 1, seed); }), 4.0);
}

TEST(RandomMaxDegree, HasTheStatedDistribution) {
  // Maximum degree 2, two edges on 4 vertices: 12 paths P3 and 3 matchings. The weights 1/(D -
  // deg)! are 1/2 for a path (degrees 2, 1, 1, 0: 1 1 1 1/2) and 1 for a matching: P(matching) = 3
  // / (3 + 6) = 1/3.
  int matchings = 0;
  constexpr int kSamples = 20000;
  for (int seed = 0; seed < kSamples; ++seed) {
    matchings += random_max_degree(4, 2, 2, static_cast<std::uint64_t>(seed)).max_degree() == 1;
  }
  EXPECT_NEAR(matchings, kSamples / 3.0, 4 * std::sqrt(kSamples * 2.0 / 9));
}

TEST(RandomRegular, RefusesImpossibleSizes) {
  EXPECT_THROW(random_regular(7, 3, 1), InputError);
  EXPECT_THROW(random_regular(3, 3, 1), InputError);
  EXPECT_THROW(random_regular(8, 5, 1), InputError);
  EXPECT_THROW(random_max_degree(5, 4, 11, 1), InputError);
  EXPECT_THROW(random_max_degree(5, 0, 0, 1), InputError);
  EXPECT_THROW(circulant(10, 3, 3), InputError);
}

}  // namespace
}  // namespace ar3d::testing
