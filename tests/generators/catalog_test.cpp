// The table of families: complete, its sizes kept, bad parameters refused, named on its page.

#include "ar3d/generators/catalog.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <set>
#include <utility>

#include "ar3d/base/error.h"
#include "support/parts.h"
#include "support/problem.h"

namespace ar3d::testing {
namespace {

std::string refusal(const std::string& family, std::uint64_t n, const Settings& parameters) {
  return problem([&] { generate(find_family(family), n, 1, parameters); }, "accepted");
}

/// The degrees at the ends of all edges, sorted: what every permutation of the labels keeps.
std::vector<std::pair<Vertex, Vertex>> degree_pairs(const Graph& graph) {
  std::vector<std::pair<Vertex, Vertex>> pairs;
  for (const Edge& edge : graph.edges()) {
    pairs.push_back(std::minmax({graph.degree(edge.u), graph.degree(edge.v)}));
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

TEST(Catalogue, NamesAreDistinctAndRowsComplete) {
  std::set<std::string> names;
  for (const Family& family : families()) {
    EXPECT_TRUE(names.insert(family.name).second) << family.name;
    EXPECT_FALSE(family.summary.empty()) << family.name;
    EXPECT_LE(family.max_degree, 4u) << family.name;
    EXPECT_NE(family.nearest_n, nullptr) << family.name;
    EXPECT_NE(family.generate, nullptr) << family.name;
    for (const SettingSpec& spec : family.parameters) {
      EXPECT_LE(spec.low, spec.default_value) << family.name;
      EXPECT_LE(spec.default_value, spec.high) << family.name;
      EXPECT_FALSE(spec.description.empty()) << family.name;
    }
  }
}

TEST(Catalogue, SizesAreTheNearestNotAboveAndKept) {
  for (const Family& family : families()) {
    const Settings defaults = complete_parameters(family, {});
    const std::uint64_t smallest = family.nearest_n(0, defaults);
    std::uint64_t previous = smallest;
    for (std::uint64_t wanted = 0; wanted < 400; ++wanted) {
      const std::uint64_t n = family.nearest_n(wanted, defaults);
      EXPECT_LE(n, std::max(wanted, smallest)) << family.name;
      EXPECT_GE(n, previous) << family.name;
      EXPECT_EQ(family.nearest_n(n, defaults), n) << family.name << " " << wanted;
      previous = n;
    }
    EXPECT_LE(family.nearest_n(std::uint64_t{1} << 62, defaults), std::uint64_t{1} << 62);
  }
}

TEST(Catalogue, EverySmallSizeGeneratesWithinTheDegree) {
  for (const Family& family : families()) {
    for (const std::uint64_t n : {0u, 5u, 17u, 64u, 333u}) {
      EXPECT_LE(generate(family, n, 3).max_degree(), family.max_degree) << family.name << " " << n;
    }
  }
}

TEST(Catalogue, OnlyRandomFamiliesDependOnTheSeed) {
  for (const Family& family : families()) {
    const std::string hash = graph_hash(generate(family, 200, 1));
    EXPECT_EQ(graph_hash(generate(family, 200, 1)), hash) << family.name;
    const bool differs = graph_hash(generate(family, 200, 2)) != hash ||
                         graph_hash(generate(family, 200, 3)) != hash;
    EXPECT_EQ(differs, family.is_random) << family.name;
  }
}

TEST(Catalogue, ShufflePermutesTheLabelsOfEveryFamily) {
  for (const Family& family : families()) {
    const auto n = family.nearest_n(60, complete_parameters(family, {}));
    const Graph plain = generate(family, n, 1);
    const Graph shuffled = generate(family, n, 1, {{"shuffle", 1}});
    ASSERT_EQ(shuffled.num_vertices(), plain.num_vertices()) << family.name;
    EXPECT_EQ(degree_pairs(shuffled), degree_pairs(plain)) << family.name;
    const std::string hash = graph_hash(shuffled);
    EXPECT_EQ(graph_hash(generate(family, n, 1, {{"shuffle", 1}})), hash) << family.name;
    if (plain.num_edges() > 2) {
      EXPECT_NE(graph_hash(plain), hash) << family.name;
      EXPECT_NE(graph_hash(generate(family, n, 2, {{"shuffle", 1}})), hash) << family.name;
    }
    EXPECT_TRUE(depends_on_seed(family, complete_parameters(family, {{"shuffle", 1}})));
    EXPECT_EQ(complete_parameters(family, {{"shuffle", 0}}), complete_parameters(family, {}));
    EXPECT_THROW(complete_parameters(family, {{"shuffle", 2}}), InputError);
  }
}

TEST(Catalogue, BadParametersAreRefusedWithTheirValue) {
  expect_parts(
      {{refusal("prism", 10, {{"k", 3}}), "prism has no parameter 'k'"},
       {refusal("torus", 10, {{"rows", 2}}), "rows = 2 is outside 3..1000000"},
       {refusal("torus", 10, {{"rows", 3}, {"rows", 4}}), "torus: parameter 'rows' is given twice"},
       {refusal("cubic-tree", 10, {{"leaf", 6}}), "leaf = 6"},
       {refusal("random-max-degree", 10, {{"degree", 3}, {"edges-per-vertex", 1500001}}),
        "edges-per-vertex = 1500001 is above 1500000"},
       {refusal("path", std::uint64_t{1} << 40, {}), "1099511627776 vertices are too many"},
       {refusal("prism", ~std::uint64_t{0}, {}), "too many"}});
  EXPECT_THROW(find_family("nonsense"), InputError);
}

TEST(Docs, FamiliesPageNamesEveryFamilyInTheOrderOfTheCatalogue) {
  std::ifstream file(AR3D_SOURCE_DIR "/docs/families.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  std::size_t at = page.find("## What is known of each family");
  for (const Family& family : families()) {
    at = page.find(fmt::format("`{}`", family.name), at);
    ASSERT_NE(at, std::string::npos) << family.name;
  }
}

}  // namespace
}  // namespace ar3d::testing
