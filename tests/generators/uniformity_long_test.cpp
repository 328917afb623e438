#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <unordered_map>

#include "ar3d/generators/random_regular.h"

namespace ar3d {
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

// The seeds are fixed: a failure is a change of the generator, not bad luck.
TEST(Uniformity, AllLabelledCubicGraphsOnEightVertices) {
  EXPECT_GT(uniformity(8, 3, 19355, 2000000), 0.001);
}

TEST(Uniformity, AllLabelledFourRegularGraphsOnSevenVertices) {
  EXPECT_GT(uniformity(7, 4, 465, 1000000), 0.001);
}

}  // namespace
}  // namespace ar3d
