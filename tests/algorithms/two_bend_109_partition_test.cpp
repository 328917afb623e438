// Lemmas E.1 and E.2: the list of bodies by enumeration, every property of every part.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "ar3d/algorithms/two_bend_109/partition.h"
#include "ar3d/generators/catalog.h"
#include "support/graphs.h"

namespace ar3d::two_bend_109 {
namespace {

/// Calls visit for every cycle through its smallest vertex, as a set, until it returns true.
bool any_cycle(const Graph& graph, const std::set<Vertex>& without,
               const std::function<bool(const std::set<Vertex>&)>& visit) {
  std::vector<Vertex> path;
  const std::function<bool()> extend = [&] {
    for (const HalfEdge& half : graph.incident(path.back())) {
      if (half.to == path.front() && path.size() > 2 && visit({path.begin(), path.end()})) {
        return true;
      }
      if (half.to <= path.front() || without.contains(half.to) ||
          std::find(path.begin(), path.end(), half.to) != path.end()) {
        continue;
      }
      path.push_back(half.to);
      if (extend()) return true;
      path.pop_back();
    }
    return false;
  };
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    path = {v};
    if (!without.contains(v) && extend()) return true;
  }
  return false;
}

bool has_two_disjoint_cycles(const Graph& graph) {
  return any_cycle(graph, {}, [&](const std::set<Vertex>& cycle) {
    return any_cycle(graph, cycle, [](const std::set<Vertex>&) { return true; });
  });
}

TEST(TwoBend109Partition, ListOfBodiesIsComplete) {
  std::set<std::string> found;
  for (int n = 4; n <= 8; ++n) {
    for (const Graph& graph : testing::geng(fmt::format("-c -d3 -D4 {}", n))) {
      const SmallBody* body = find_body(graph).first;
      ASSERT_EQ(body != nullptr, !has_two_disjoint_cycles(graph)) << n << " vertices";
      EXPECT_TRUE(!body || found.insert(body->name).second) << "each is found once";
    }
  }
  EXPECT_EQ(found.size(), small_bodies().size());
}

bool is_induced_cycle(const Graph& graph, const PartVertices& cycle) {
  const std::size_t k = cycle.size();
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const auto incident = graph.incident(cycle[i]);
      const bool joined = std::any_of(incident.begin(), incident.end(),
                                      [&](const HalfEdge& half) { return half.to == cycle[j]; });
      if (joined != (i == j + 1 || (j == 0 && i + 1 == k))) return false;
    }
  }
  return k >= 3;
}

/// Empty if the parts are as Lemma E.2 says.
std::string fault(const Graph& graph, const std::vector<VertexPart>& parts) {
  std::vector<int> part_of(graph.num_vertices(), -1);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (const Vertex v : parts[i].vertices) {
      if (part_of[v] >= 0) return "a vertex is in two parts";
      part_of[v] = static_cast<int>(i);
    }
  }
  if (std::count(part_of.begin(), part_of.end(), -1) > 0) return "a vertex is in no part";
  bool seen_body = false;
  for (const VertexPart& part : parts) {
    if (seen_body && part.kind != PartKind::body) return "a body is not at the end";
    seen_body = part.kind == PartKind::body;
    for (const Vertex v : part.vertices) {
      int earlier = 0, later = 0;
      for (const HalfEdge& half : graph.incident(v)) {
        if (part_of[half.to] < part_of[v]) ++earlier;
        if (part_of[half.to] > part_of[v]) ++later;
      }
      if (part.kind == PartKind::single && (earlier > 3 || later > 2)) return "a single's edges";
      if (part.kind == PartKind::body && (earlier > 1 || later > 0)) return "a body's edges";
    }
    if (part.kind == PartKind::cycle && !is_induced_cycle(graph, part.vertices)) return "a cycle";
    if (part.kind == PartKind::body) {
      std::size_t inside = 0;
      for (const SmallBody::BodyLink& link : part.body->links) {
        for (const HalfEdge& half : graph.incident(part.vertices[link.u])) {
          if (half.to == part.vertices[link.v]) ++inside;
        }
      }
      if (inside != part.body->links.size()) return "a body is another graph";
    }
  }
  return "";
}

TEST(TwoBend109Partition, PartsAreAsTheLemmaSaysForAllSmallGraphs) {
  std::map<std::string, int> bodies;
  std::uint64_t seed = 0;
  for (int n = 1; n <= 8; ++n) {
    for (const Graph& graph : testing::geng(fmt::format("-c -D4 {}", n))) {
      for (const Graph& labelled : {graph, testing::shuffled(graph, ++seed)}) {
        const std::vector<VertexPart> parts = find_partition(labelled);
        ASSERT_EQ(fault(labelled, parts), "") << "seed " << seed;
        for (const VertexPart& part : parts) {
          if (part.kind == PartKind::body) ++bodies[part.body->name];
        }
      }
    }
  }
  EXPECT_GE(bodies.size(), 2u) << "K5 and others are needed";
}

// What Step E.1 says of its cost; nothing better than O(n) per vertex is proved. Random 4-regular
// graphs have few short cycles, so that a search goes through about sqrt(n) vertices.
TEST(TwoBend109Partition, SearchesLookAtFewHalfEdgesPerVertex) {
  double largest_random = 0;
  for (const Family& family : families()) {
    const bool is_random = family.name.ends_with("4-regular");
    for (const std::uint64_t n : {1000u, 10000u}) {
      const Graph graph = generate(family, n, 3, {{"shuffle", 1}});
      if (connected_components_of(graph).count != 1) continue;
      std::uint64_t looked_at = 0;
      find_partition(graph, &looked_at);
      const double seen = static_cast<double>(looked_at) / graph.num_vertices();  // per vertex
      EXPECT_LE(seen, is_random ? 0.6 * std::sqrt(n) : 12) << family.name << " n " << n;
      if (is_random) largest_random = std::max(largest_random, seen);
    }
  }
  EXPECT_GT(largest_random, 12) << "else the page's exception is none";
}

/// The ring of k copies of a graph from which one edge uv was taken away: u of each joined to v of
/// the next.
Graph ring_of(const Graph& piece, Edge missing, Vertex k) {
  const Vertex n = piece.num_vertices();
  std::vector<Edge> edges;
  for (Vertex i = 0; i < k; ++i) {
    for (const Edge& e : piece.edges()) {
      if (e == missing) continue;
      edges.push_back({i * n + e.u, i * n + e.v});
    }
    edges.push_back({i * n + missing.u, (i + 1) % k * n + missing.v});
  }
  return Graph(std::uint64_t{n} * k, std::move(edges));
}

TEST(TwoBend109Partition, PartsAreAsTheLemmaSaysForLargerGraphs) {
  const auto expect_no_fault = [](const Graph& graph, const std::string& name) {
    if (connected_components_of(graph).count != 1) return;
    EXPECT_EQ(fault(graph, find_partition(graph)), "") << name;
  };
  for (const Family& family : families()) {
    expect_no_fault(generate(family, 300, 3, {{"shuffle", 1}}), family.name);
  }
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const std::string name = fmt::format("seed {}", seed);
    for (const Graph& piece : {testing::complete(5), testing::octahedron(), testing::complete(4)}) {
      expect_no_fault(testing::shuffled(ring_of(piece, piece.edge(0), 7), seed), name);
    }
    for (const std::uint64_t n : {10u, 14u, 20u, 60u, 1000u}) {
      expect_no_fault(generate(find_family("random-4-regular"), n, seed), name);
    }
  }
}

}  // namespace
}  // namespace ar3d::two_bend_109
