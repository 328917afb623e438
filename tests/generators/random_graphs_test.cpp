// Permutations, matchings, pairings and switchings: each uniform, by chi-square.

#include "ar3d/generators/random_graphs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "ar3d/base/error.h"
#include "ar3d/generators/families.h"
#include "ar3d/generators/switching.h"
#include "support/graph_facts.h"

namespace ar3d::testing {
namespace {

constexpr std::uint32_t kInBuckets = 70000;  // more than one bucket holds

TEST(RandomPermutation, HoldsEveryNumberOnce) {
  for (const std::uint32_t count : {0u, 1u, 2u, 1000u, 65536u, 65537u, 600001u}) {
    RandomStream random(count);
    std::vector<int> seen(count, 0);
    for (const std::uint32_t number : random_permutation(count, random)) ++seen.at(number);
    EXPECT_EQ(seen, std::vector<int>(count, 1));
  }
}

/// Where a number comes to stand is uniform, and so is the order of two numbers: by eighths of the
/// permutation, chi-square of the 64 places of the numbers 0 and 1 over 640 permutations.
TEST(RandomPermutation, PlacesInBucketsAreUniform) {
  std::array<double, 64> seen{};
  constexpr int kSamples = 640;
  RandomStream random(5);
  int ascending = 0;
  for (int i = 0; i < kSamples; ++i) {
    const auto numbers = random_permutation(kInBuckets, random);
    std::array<std::uint32_t, 2> place{};
    for (std::uint32_t p = 0; p < kInBuckets; ++p) {
      if (numbers[p] < 2) place[numbers[p]] = p;
    }
    ++seen[8 * (8ull * place[0] / kInBuckets) + 8ull * place[1] / kInBuckets];
    ascending += place[0] < place[1] ? 1 : 0;
  }
  double chi_square = 0;
  for (const double count : seen) chi_square += (count - 10) * (count - 10) / 10;
  EXPECT_LT((chi_square - 63) / std::sqrt(2 * 63.0), 4.0);
  EXPECT_NEAR(ascending, kSamples / 2.0, 4 * std::sqrt(kSamples / 4.0));
}

TEST(RandomMatching, IsAnInvolutionWithoutFixedPoints) {
  for (const std::uint32_t count : {2u, 600u, kInBuckets, 600000u}) {
    RandomStream random(count);
    const auto partner = random_matching(count, random);
    for (std::uint32_t p = 0; p < count; ++p) {
      ASSERT_NE(partner[p], p);
      ASSERT_EQ(partner[partner[p]], p);
    }
  }
}

/// Lengths of the cycles of a 2-regular graph, sorted.
std::vector<Count> cycle_type(const Graph& graph) {
  std::map<std::uint32_t, Count> size;
  for (const std::uint32_t c : connected_components_of(graph).of) ++size[c];
  std::vector<Count> type;
  for (const auto& [component, count] : size) type.push_back(count);
  std::sort(type.begin(), type.end());
  return type;
}

/// A quantity proportional to the number of labelled 2-regular graphs of that type: 1 / prod (m_i!
/// (2 i)^m_i).
double weight(const std::vector<Count>& type) {
  double w = 1;
  std::map<Count, int> times;
  for (const Count length : type) w /= 2.0 * static_cast<double>(length) * ++times[length];
  return w;
}

void add_types(Count rest, Count least, std::vector<Count>& prefix,
               std::map<std::vector<Count>, double>& weights) {
  if (rest == 0) weights[prefix] = weight(prefix);
  for (Count part = least; part <= rest; ++part) {
    prefix.push_back(part);
    add_types(rest - part, part, prefix, weights);
    prefix.pop_back();
  }
}

TEST(Switching, TwoRegularGraphsHaveTheExactCycleTypes) {
  constexpr Count kN = 14;
  constexpr int kSamples = 60000;
  std::map<std::vector<Count>, double> weights;
  std::vector<Count> prefix;
  add_types(kN, 3, prefix, weights);
  double total = 0;
  for (const auto& [type, w] : weights) total += w;
  std::map<std::vector<Count>, double> seen;
  RandomStream random(7);
  for (int i = 0; i < kSamples; ++i) {
    ++seen[cycle_type(Graph(kN, random_regular_by_switching(kN, 2, random, 1, 1)))];
  }
  double chi_square = 0;
  for (const auto& [type, w] : weights) {
    const double expected = kSamples * w / total;
    chi_square += (seen[type] - expected) * (seen[type] - expected) / expected;
    seen.erase(type);
  }
  EXPECT_TRUE(seen.empty());
  const double freedom = static_cast<double>(weights.size()) - 1;
  EXPECT_LT((chi_square - freedom) / std::sqrt(2 * freedom), 4.0);
}

std::uint64_t triangles(const Graph& graph) {
  std::uint64_t count = 0;
  for (const Edge e : graph.edges()) {
    for (const HalfEdge& a : graph.incident(e.u)) {
      for (const HalfEdge& b : graph.incident(e.v)) count += a.to == b.to ? 1 : 0;
    }
  }
  return count / 3;
}

/// Two-sample chi-square of the number of triangles and components: switchings against full
/// restart.
double difference(Count n, std::uint32_t d, int samples) {
  RandomStream random(3);
  std::map<std::uint64_t, std::array<double, 2>> seen;
  const auto class_of = [](const Graph& g) {
    return std::min<std::uint64_t>(triangles(g), 6) * 2 + (connected_components_of(g).count > 1);
  };
  for (int i = 0; i < samples; ++i) {
    ++seen[class_of(Graph(n, random_regular_by_switching(n, d, random, 3, 3)))][0];
    ++seen[class_of(Graph(n, random_simple_pairs(n, d, n * d / 2, random)))][1];
  }
  double chi_square = 0;
  double freedom = -1;
  for (const auto& [kind, counts] : seen) {
    if (counts[0] + counts[1] < 20) continue;
    chi_square += (counts[0] - counts[1]) * (counts[0] - counts[1]) / (counts[0] + counts[1]);
    ++freedom;
  }
  return (chi_square - freedom) / std::sqrt(2 * freedom);
}

TEST(Switching, AgreesWithFullRestart) {
  EXPECT_LT(difference(20, 3, 20000), 4.0);
  EXPECT_LT(difference(24, 4, 10000), 4.0);
}

TEST(Switching, GivesSimpleRegularGraphs) {
  RandomStream random(11);
  for (const std::uint32_t d : {2u, 3u, 4u}) {
    const Graph graph(3000,
                      random_regular_by_switching(3000, d, random));  // refuses loops, parallels
    EXPECT_EQ(degree_counts(graph).size(), 1u);
    EXPECT_EQ(graph.max_degree(), d);
  }
}

/// Chi-square of `samples` draws over `classes` equally likely labelled graphs, in standard
/// deviations.
template <class Draw>
double deviation(std::uint64_t samples, std::size_t classes, Draw draw) {
  std::map<std::string, double> count;
  for (std::uint64_t seed = 0; seed < samples; ++seed) ++count[graph_hash(draw(seed))];
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
