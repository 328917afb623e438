#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <numeric>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "ar3d/generators/random_graphs.h"
#include "ar3d/generators/switching.h"

namespace ar3d::testing {
namespace {

/// The adjacency matrix's upper triangle as bits: names a labelled graph on at most 11 vertices.
std::uint64_t code_of(const Graph& graph) {
  std::uint64_t code = 0;
  for (const Edge e : graph.edges()) {
    const auto [low, high] = std::minmax(e.u, e.v);
    code |= std::uint64_t{1} << (high * (high - 1) / 2 + low);
  }
  return code;
}

/// Upper tail of the chi-square distribution by Wilson and Hilferty's normal approximation (error
/// below 10^-4 for hundreds of degrees of freedom).
double p_value(double chi_square, double freedom) {
  const double spread = 2.0 / (9.0 * freedom);
  const double z = (std::cbrt(chi_square / freedom) - (1 - spread)) / std::sqrt(spread);
  return 0.5 * std::erfc(z / std::sqrt(2.0));
}

/// Draws `samples` graphs, expects all `classes` labelled graphs, and returns the p-value of
/// uniformity.
double uniformity(Count n, std::uint32_t d, std::size_t classes, std::uint64_t samples) {
  std::unordered_map<std::uint64_t, double> seen;
  RandomStream random(20250101, n * 8 + d);
  for (std::uint64_t i = 0; i < samples; ++i) {
    ++seen[code_of(Graph(n, random_regular_edges(n, d, random)))];
  }
  EXPECT_EQ(seen.size(), classes);
  const double expected = static_cast<double>(samples) / static_cast<double>(classes);
  double chi_square = 0;
  for (const auto& [code, count] : seen) {
    chi_square += (count - expected) * (count - expected) / expected;
  }
  const double p = p_value(chi_square, static_cast<double>(classes) - 1);
  ::testing::Test::RecordProperty("p_value", std::to_string(p));
  std::printf("n = %d, d = %u: %zu labelled graphs, %.0f samples, chi-square %.1f, p = %.4f\n",
              static_cast<int>(n), d, classes, static_cast<double>(samples), chi_square, p);
  return p;
}

/// Equal for isomorphic graphs: the closed walks of up to `longest` steps at each vertex.
/// @param whole  as a sorted list, which tells most graphs apart; else only their sums.
std::uint64_t signature(const Graph& graph, int longest, bool whole) {
  std::vector<std::uint64_t> of_vertex;
  std::vector<std::uint64_t> walks;
  std::vector<std::uint64_t> longer;
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    walks.assign(graph.num_vertices(), 0);
    walks[v] = 1;
    std::uint64_t weighted = 0;
    for (int steps = 1; steps <= longest; ++steps) {
      longer.assign(graph.num_vertices(), 0);
      for (const Edge e : graph.edges()) {
        longer[e.u] += walks[e.v];
        longer[e.v] += walks[e.u];
      }
      walks.swap(longer);
      weighted = weighted * 0x9e3779b97f4a7c15u + walks[v];
    }
    of_vertex.push_back(weighted);
  }
  if (!whole) return std::accumulate(of_vertex.begin(), of_vertex.end(), std::uint64_t{0});
  std::sort(of_vertex.begin(), of_vertex.end());
  std::uint64_t all = 0;
  for (const std::uint64_t weighted : of_vertex) all = (all ^ weighted) * 0x9e3779b97f4a7c15u;
  return all;
}

/// Two-sample chi-square of the signatures: graphs by switchings against as many by full restart,
/// which is uniform by construction. Signatures seen less than 20 times are one class.
double agreement(Count n, std::uint32_t d, std::uint64_t samples) {
  const auto signature_of = [d](std::vector<Edge> edges, Count size) {
    return signature(Graph(size, std::move(edges)), d == 3 ? 8 : 5, d == 3);
  };
  std::map<std::uint64_t, std::array<double, 2>> seen;
  RandomStream random(20250102, n * 8 + d);
  for (std::uint64_t i = 0; i < samples; ++i) {
    ++seen[signature_of(random_regular_by_switching(n, d, random, 4, 1), n)][0];
    ++seen[signature_of(random_simple_pairs(n, d, n * d / 2, random), n)][1];
  }
  std::array<double, 2> rare{};
  std::vector<std::array<double, 2>> classes;
  for (const auto& [hash, counts] : seen) {
    if (counts[0] + counts[1] >= 20) {
      classes.push_back(counts);
    } else {
      rare = {rare[0] + counts[0], rare[1] + counts[1]};
    }
  }
  if (rare[0] + rare[1] > 0) classes.push_back(rare);
  double chi_square = 0;
  for (const auto& [one, other] : classes) {
    chi_square += (one - other) * (one - other) / (one + other);
  }
  const double p = p_value(chi_square, static_cast<double>(classes.size()) - 1);
  ::testing::Test::RecordProperty("p_value", std::to_string(p));
  std::printf(
      "switchings, n = %d, d = %u: %zu classes, 2 x %.0f samples, chi-square %.1f, p = %.4f\n",
      static_cast<int>(n), d, classes.size(), static_cast<double>(samples), chi_square, p);
  return p;
}

// The seeds are fixed: a failure is a change of the generator, not bad luck.
TEST(Uniformity, AllLabelledCubicGraphsOnEightVertices) {
  EXPECT_GT(uniformity(8, 3, 19355, 2000000), 0.001);
}

TEST(Uniformity, AllLabelledFourRegularGraphsOnSevenVertices) {
  EXPECT_GT(uniformity(7, 4, 465, 1000000), 0.001);
}

// The smallest sizes for which the switchings' bounds hold with one double edge; random_regular
// itself takes full restart there.
TEST(Uniformity, SwitchingsGiveCubicGraphsAsFullRestartDoes) {
  EXPECT_GT(agreement(14, 3, 1000000), 0.001);
}

TEST(Uniformity, SwitchingsGiveFourRegularGraphsAsFullRestartDoes) {
  EXPECT_GT(agreement(17, 4, 200000), 0.001);
}

}  // namespace
}  // namespace ar3d::testing
