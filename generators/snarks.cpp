// Cubic graphs without bridges and without a 3-edge-colouring: Isaacs' dot product (1975) makes
// chains of them, the others are given by a piece and how its copies are joined.
#include "ar3d/generators/snarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "ar3d/base/error.h"
#include "ar3d/generators/rings.h"

namespace ar3d {
namespace {

bool same_edge(Edge e, Edge f) { return (e.u == f.u && e.v == f.v) || (e.u == f.v && e.v == f.u); }

/// The two neighbours of x in a cubic graph other than y. @throws InputError unless there are two.
std::array<Vertex, 2> other_neighbours(const Graph& graph, Vertex x, Vertex y) {
  std::vector<Vertex> others;
  for (const HalfEdge& half : graph.incident(x)) {
    if (half.to != y) others.push_back(half.to);
  }
  if (others.size() != 2 || graph.degree(x) != 3) {
    throw InputError(
        fmt::format("dot product: {} {} is not an edge between vertices of degree 3", x, y));
  }
  return {others[0], others[1]};
}

/// Removes an edge; quick if it is among the last. @throws InputError if it is not there.
void remove_edge(std::vector<Edge>& edges, Edge edge) {
  const auto at = std::find_if(edges.rbegin(), edges.rend(),
                               [&](Edge other) { return same_edge(edge, other); });
  if (at == edges.rend()) {
    throw InputError(fmt::format("dot product: {} {} is not an edge", edge.u, edge.v));
  }
  edges.erase(std::next(at).base());
}

/// Isaacs' dot product (1975) of cubic graphs: the first, which has n vertices and is given by its
/// edges, without the edges ab = cuts[0] and cd = cuts[1], and `second` without its adjacent
/// vertices x and y; a, b are joined to the other neighbours of x, and c, d to those of y. The
/// vertices of `second` follow in their order. The dot product of two snarks is a snark.
void multiply(std::vector<Edge>& edges, Count n, const std::array<Edge, 2>& cuts,
              const Graph& second, Vertex x, Vertex y) {
  const auto [cut, other_cut] = cuts;
  if (cut.u == other_cut.u || cut.u == other_cut.v || cut.v == other_cut.u ||
      cut.v == other_cut.v) {
    throw InputError("dot product: the two edges to be cut share a vertex");
  }
  const auto from_x = other_neighbours(second, x, y);
  const auto from_y = other_neighbours(second, y, x);
  remove_edge(edges, cut);
  remove_edge(edges, other_cut);
  const auto renamed = [&](Vertex v) {
    return static_cast<Vertex>(n + v - (v > x ? 1u : 0u) - (v > y ? 1u : 0u));
  };
  for (const Edge e : second.edges()) {
    const bool stays = e.u != x && e.u != y && e.v != x && e.v != y;
    if (stays) edges.push_back({renamed(e.u), renamed(e.v)});
  }
  edges.push_back({cut.u, renamed(from_x[0])});
  edges.push_back({cut.v, renamed(from_x[1])});
  edges.push_back({other_cut.u, renamed(from_y[0])});
  edges.push_back({other_cut.v, renamed(from_y[1])});
}

/// Five copies of a piece of ten vertices (nine on a path or cycle and a centre, number 9), piece
/// by piece.
GraphBuilder five_pieces(std::span<const Edge> piece) {
  GraphBuilder builder(50, 75);
  for (Count i = 0; i < 5; ++i) builder.edges(piece, 10 * i);
  return builder;
}

}  // namespace

Graph blanusa_snark(Count k, Count type) {
  if (type != 1 && type != 2) throw InputError(fmt::format("Blanusa type {} is not 1 or 2", type));
  const Graph petersen = generalised_petersen(5, 2);  // outer cycle 0..4, inner edges i, i + 2
  const Edge cut = {2, 3};
  const Edge other_cut = type == 1 ? Edge{4, 9} : Edge{9, 6};
  std::vector<Edge> edges(petersen.edges().begin(), petersen.edges().end());
  Count n = petersen.num_vertices();
  for (Count i = 0; i < k; ++i) {
    // The last Petersen graph has lost its vertices 0 and 1, unless it is the only one.
    const auto shift = static_cast<Vertex>(i == 0 ? 0 : n - 10);
    const auto shifted = [&](Edge e) { return Edge{e.u + shift, e.v + shift}; };
    multiply(edges, n, {shifted(cut), shifted(other_cut)}, petersen, 0, 1);
    n += 8;
  }
  return Graph(static_cast<Vertex>(n), std::move(edges));
}

Graph goldberg_snark(Count k) {
  if (k < 5 || k % 2 == 0) {
    throw InputError(fmt::format("Goldberg snark G_{}: the index must be odd and at least 5", k));
  }
  // Vertices 0..7 of a block: 6 and 7 are joined to 5, and each closes a path of the others.
  constexpr Edge kBlock[] = {{0, 1}, {0, 6}, {1, 7}, {2, 3}, {2, 7},
                             {3, 6}, {4, 5}, {5, 6}, {5, 7}};
  constexpr Edge kToNext[] = {{1, 0}, {3, 2}, {4, 4}};
  GraphBuilder builder(8 * k, 12 * k);
  for (Count i = 0; i < k; ++i) {
    builder.edges(kBlock, 8 * i);
    for (const Edge e : kToNext) builder.edge(8 * i + e.u, 8 * ((i + 1) % k) + e.v);
  }
  return builder.finish();
}

Graph double_star_snark() {
  constexpr Edge kEdges[] = {
      {0, 1},   {0, 14},  {0, 15},  {1, 2},   {1, 11},  {2, 3},   {2, 7},   {3, 4},   {3, 18},
      {4, 5},   {4, 14},  {5, 6},   {5, 10},  {6, 7},   {6, 21},  {7, 8},   {8, 9},   {8, 13},
      {9, 10},  {9, 24},  {10, 11}, {11, 12}, {12, 13}, {12, 27}, {13, 14}, {15, 16}, {15, 29},
      {16, 20}, {16, 23}, {17, 18}, {17, 25}, {17, 28}, {18, 19}, {19, 23}, {19, 26}, {20, 21},
      {20, 28}, {21, 22}, {22, 26}, {22, 29}, {23, 24}, {24, 25}, {25, 29}, {26, 27}, {27, 28}};
  return Graph(30, {std::begin(kEdges), std::end(kEdges)});
}

Graph szekeres_snark() {
  constexpr Edge kPiece[] = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 7},
                             {7, 8}, {1, 9}, {4, 9}, {7, 9}, {0, 5}, {8, 3}};
  GraphBuilder builder = five_pieces(kPiece);
  for (Count i = 0; i < 5; ++i) {
    builder.edge(10 * i, 10 * ((i + 1) % 5) + 8);
    builder.edge(10 * i + 6, 10 * ((i + 2) % 5) + 2);
  }
  return builder.finish();
}

Graph watkins_snark() {
  constexpr Edge kPiece[] = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 7},
                             {7, 8}, {8, 0}, {1, 9}, {4, 9}, {7, 9}, {6, 2}};
  GraphBuilder builder = five_pieces(kPiece);
  for (Count i = 0; i < 5; ++i) {
    builder.edge(10 * i + 5, 10 * ((i + 1) % 5));
    builder.edge(10 * i + 8, 10 * ((i + 2) % 5) + 3);
  }
  return builder.finish();
}

}  // namespace ar3d
