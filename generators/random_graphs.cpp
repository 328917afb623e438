// Random graphs by the pairing model with full restart (Bollobas 1980), which is exactly uniform
// for small n; from n = 200 on switchings take over (switching.h), since restarts cost
// e^((d^2-1)/4). Every family draws from a stream of its own, so none changes when another one
// does.
#include "ar3d/generators/random_graphs.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/graph/biconnected_components.hpp>
#include <numeric>

#include "ar3d/base/error.h"
#include "ar3d/generators/switching.h"
#include "ar3d/model/boost_graph.h"

namespace ar3d {
namespace {

constexpr std::uint64_t kRegularStream = 10, kMaxDegreeStream = 11;
constexpr std::uint64_t kConnectedStream = 30, kBipartiteStream = 31, kThinnedStream = 32;
constexpr std::uint64_t kTreeStream = 33, kBridgesStream = 34;

void refuse_bad_degree(std::uint32_t d) {
  if (d < 1 || d > 4) throw InputError(fmt::format("degree {} is outside 1..4", d));
}

/// Draws the right ends of the points of 0, 1, ..., three each, one after the other; empty at the
/// first parallel edge.
std::vector<Edge> try_bipartite(std::vector<std::uint32_t>& points, RandomStream& random) {
  const auto side = static_cast<Vertex>(points.size() / 3);
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::swap(points[i], points[i + random.below(static_cast<std::uint32_t>(points.size() - i))]);
    const Edge e = {static_cast<Vertex>(i / 3), side + points[i] / 3};
    for (std::size_t j = i - i % 3; j < i; ++j) {
      if (edges[j] == e) return {};
    }
    edges.push_back(e);
  }
  return edges;
}

/// Connected and without bridges: no biconnected component is a single edge.
bool two_edge_connected(const Graph& graph) {
  std::vector<std::size_t> component(graph.num_edges());
  const auto of_edge =
      boost::make_iterator_property_map(component.begin(), get(boost::edge_index, graph));
  std::vector<std::uint32_t> sizes(boost::biconnected_components(graph, of_edge));
  for (const std::size_t c : component) ++sizes[c];
  return connected_components_of(graph).count == 1 && std::ranges::count(sizes, 1u) == 0;
}

std::vector<Edge> random_bridgeless_cubic(Count n, RandomStream& random) {
  for (;;) {
    std::vector<Edge> edges = random_regular_edges(n, 3, random);
    if (two_edge_connected(Graph(n, edges))) return edges;
  }
}

/// Puts a new vertex on a random edge of the piece and returns it.
Vertex subdivide(std::vector<Edge>& piece, Vertex new_vertex, RandomStream& random) {
  Edge& edge = piece[random.below(static_cast<std::uint32_t>(piece.size()))];
  const Vertex far = edge.v;
  edge.v = new_vertex;
  piece.push_back({new_vertex, far});
  return new_vertex;
}

}  // namespace

/// The pairs drawn so far are kept as adjacency, `d` places per vertex. At the first loop or
/// parallel edge all of them are forgotten, but the points are never put back in order: a
/// Fisher-Yates shuffle gives a uniform sequence from any start.
std::vector<Edge> random_simple_pairs(Count num_vertices, std::uint32_t d, Count pairs,
                                      RandomStream& random) {
  std::vector<std::uint32_t> point(num_vertices * d);  // point p belongs to vertex p / d
  std::iota(point.begin(), point.end(), 0u);
  std::vector<Vertex> neighbour(point.size());
  std::vector<std::uint8_t> degree(num_vertices);
  const auto row = [&](Vertex v) {
    return std::span<Vertex>(neighbour.data() + std::size_t{v} * d, degree[v]);
  };
  const auto draw = [&](std::size_t i) {
    const auto left = static_cast<std::uint32_t>(point.size() - i);
    std::swap(point[i], point[i + random.below(left)]);
    return static_cast<Vertex>(point[i] / d);
  };
  const auto enter = [&](Vertex u, Vertex v) { neighbour[std::size_t{u} * d + degree[u]++] = v; };
  for (std::size_t i = 0; i < 2 * pairs;) {
    const Vertex u = draw(i);
    const Vertex v = draw(i + 1);
    if (u == v || std::ranges::find(row(u), v) != row(u).end()) {
      while (i > 0) degree[point[--i] / d] = 0;
      continue;
    }
    enter(u, v);
    enter(v, u);
    i += 2;
  }
  point = {};
  std::vector<Edge> edges;
  edges.reserve(pairs);
  for (Vertex u = 0; u < num_vertices; ++u) {
    for (const Vertex v : row(u)) {
      if (u < v) edges.push_back({u, v});
    }
  }
  return edges;
}

std::vector<Edge> random_regular_edges(Count n, std::uint32_t d, RandomStream& random) {
  return n >= kLeastSwitchingSize && d >= 2 ? random_regular_by_switching(n, d, random)
                                            : random_simple_pairs(n, d, n * d / 2, random);
}

Graph random_regular(Count n, std::uint32_t d, std::uint64_t seed) {
  refuse_bad_degree(d);
  if (n <= d || n * d % 2 != 0) {
    throw InputError(fmt::format("there is no {}-regular graph on {} vertices", d, n));
  }
  RandomStream random(seed, kRegularStream);
  return Graph(n, random_regular_edges(n, d, random));
}

Count most_edges(Count n, std::uint32_t D) {
  return n > D ? n * D / 2 : (n == 0 ? 0 : n * (n - 1) / 2);
}

Graph random_max_degree(Count n, std::uint32_t D, Count m, std::uint64_t seed) {
  refuse_bad_degree(D);
  if (m > most_edges(n, D)) {
    throw InputError(
        fmt::format("{} edges on {} vertices of degree at most {}: at most {} are possible", m, n,
                    D, most_edges(n, D)));
  }
  RandomStream random(seed, kMaxDegreeStream);
  return Graph(n, random_simple_pairs(n, D, m, random));
}

Graph random_connected_regular(Count n, std::uint32_t d, std::uint64_t seed) {
  if (d < 3 || d > 4 || n <= d || n * d % 2 != 0) {
    throw InputError(
        fmt::format("there is no connected {}-regular graph on {} vertices here", d, n));
  }
  RandomStream random(seed, kConnectedStream);
  for (;;) {
    Graph graph(n, random_regular_edges(n, d, random));
    if (connected_components_of(graph).count == 1) return graph;
  }
}

Graph random_bipartite_cubic(Count n, std::uint64_t seed) {
  if (n < 6 || n % 2 != 0) {
    throw InputError(fmt::format("there is no simple bipartite cubic graph on {} vertices", n));
  }
  RandomStream random(seed, kBipartiteStream);
  std::vector<std::uint32_t> points(3 * n / 2);
  std::iota(points.begin(), points.end(), 0u);
  std::vector<Edge> edges;
  while (edges.empty()) edges = try_bipartite(points, random);
  return Graph(n, std::move(edges));
}

Graph thinned(const Graph& graph, std::uint32_t per_million, std::uint64_t seed) {
  RandomStream random(seed, kThinnedStream);
  std::vector<Edge> kept;
  for (const Edge e : graph.edges()) {
    if (random.chance(per_million, 1000000)) kept.push_back(e);
  }
  return Graph(graph.num_vertices(), std::move(kept));
}

Graph random_tree(Count n, Count D, std::uint64_t seed) {
  RandomStream random(seed, kTreeStream);
  GraphBuilder builder(n, n);
  std::vector<Count> open = {0};  // earlier vertices of degree below D
  std::vector<std::uint8_t> degree(n, 0);
  for (Count v = 1; v < n; ++v) {
    Count& drawn = open[random.below(static_cast<std::uint32_t>(open.size()))];
    const Count parent = drawn;
    builder.edge(parent, v);
    degree[v] = 1;
    if (++degree[parent] == D) {
      drawn = open.back();
      open.pop_back();
    }
    open.push_back(v);
  }
  return builder.finish();
}

Graph random_cubic_with_bridges(Count n, Count bridges, std::uint64_t seed) {
  if (n % 2 != 0 || n < 6 * bridges + 4) {
    throw InputError(fmt::format(
        "no cubic graph of {} vertices with {} bridges of this kind: need an even n >= {}", n,
        bridges, 6 * bridges + 4));
  }
  RandomStream random(seed, kBridgesStream);
  const Count pieces = bridges + 1;
  std::vector<Count> size(pieces, 4);
  for (Count spare = (n - 6 * bridges - 4) / 2; spare > 0; --spare)
    size[random.below64(pieces)] += 2;
  std::vector<std::vector<Edge>> piece;
  Count first = 0;
  for (const Count s : size) {
    piece.push_back(random_bridgeless_cubic(s, random));
    for (Edge& e : piece.back())
      e = {e.u + static_cast<Vertex>(first), e.v + static_cast<Vertex>(first)};
    first += s;
  }
  std::vector<Edge> edges;
  auto next_vertex = static_cast<Vertex>(first);
  for (Count i = 1; i < pieces; ++i) {
    const Vertex here = subdivide(piece[i], next_vertex++, random);
    const Vertex there = subdivide(piece[random.below64(i)], next_vertex++, random);
    edges.push_back({there, here});
  }
  for (const auto& part : piece) edges.insert(edges.end(), part.begin(), part.end());
  return Graph(n, std::move(edges));
}

Graph shuffled_labels(const Graph& graph, RandomStream& random) {
  std::vector<Vertex> names(graph.num_vertices());
  std::iota(names.begin(), names.end(), Vertex{0});
  random.shuffle(std::span<Vertex>(names));
  return relabelled(graph, names);
}

}  // namespace ar3d
