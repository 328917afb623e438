#include "ar3d/generators/switching.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "ar3d/generators/random_graphs.h"
#include "support/graph_facts.h"

namespace ar3d::testing {
namespace {

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
    ++seen[cycle_type(Graph(kN, random_regular_by_switching(kN, 2, random, {1, 1})))];
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
double difference(Count n, std::uint32_t d, SwitchingLimits limits, int samples) {
  RandomStream random(3);
  std::map<std::uint64_t, std::array<double, 2>> seen;
  const auto class_of = [](const Graph& g) {
    return std::min<std::uint64_t>(triangles(g), 6) * 2 + (connected_components_of(g).count > 1);
  };
  for (int i = 0; i < samples; ++i) {
    ++seen[class_of(Graph(n, random_regular_by_switching(n, d, random, limits)))][0];
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
  EXPECT_LT(difference(20, 3, {3, 3}, 20000), 4.0);
  EXPECT_LT(difference(24, 4, {3, 3}, 10000), 4.0);
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

}  // namespace
}  // namespace ar3d::testing
