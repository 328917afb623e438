// Cubic graphs without bridges and without a 3-edge-colouring, given by a piece and how its copies
// are joined: those of a Blanusa snark by Isaacs' dot product (1975).

#include <fmt/format.h>

#include <array>
#include <iterator>

#include "ar3d/base/error.h"
#include "ar3d/generators/families.h"

namespace ar3d {
namespace {

/// Five copies of a piece of ten vertices (nine on a path or cycle and a centre, number 9), piece
/// by piece. The first edge of `joins` leads to the next piece, the second one to that after it.
Graph five_pieces(std::span<const Edge> piece, const std::array<Edge, 2>& joins) {
  GraphBuilder builder(50, 75);
  for (Count i = 0; i < 5; ++i) {
    builder.edges(piece, 10 * i);
    for (Count k = 0; k < 2; ++k) {
      builder.edge(10 * i + joins[k].u, 10 * ((i + k + 1) % 5) + joins[k].v);
    }
  }
  return builder.finish();
}

}  // namespace

Graph blanusa_snark(Count k, Count type) {
  if (type != 1 && type != 2) throw InputError(fmt::format("Blanusa type {} is not 1 or 2", type));
  const Graph petersen = generalised_petersen(5, 2);  // outer cycle 0..4, inner edges i, i + 2
  const Edge cut = {2, 3};
  const Edge other_cut = type == 1 ? Edge{4, 9} : Edge{6, 9};
  const Edge ends = type == 1 ? Edge{2, 6} : Edge{6, 2};  // of those at vertex 1
  GraphBuilder builder(8 * k + 10, 12 * k + 15);
  for (Count i = 0; i <= k; ++i) {
    // All but the last lose two edges, all but the first their vertices 0 and 1; the ends of the
    // edges are joined to what the vertices were.
    for (const Edge e : petersen.edges()) {
      const bool is_cut = i < k && (e == cut || e == other_cut);
      if (!is_cut && (i == 0 || e.u > 1)) builder.edge(8 * i + e.u, 8 * i + e.v);
    }
    if (i == k) break;
    builder.edge(8 * i + cut.u, 8 * i + 8 + 4);
    builder.edge(8 * i + cut.v, 8 * i + 8 + 5);
    builder.edge(8 * i + other_cut.u, 8 * i + 8 + ends.u);
    builder.edge(8 * i + other_cut.v, 8 * i + 8 + ends.v);
  }
  return builder.finish();
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
  return five_pieces(kPiece, {{{0, 8}, {6, 2}}});
}

Graph watkins_snark() {
  constexpr Edge kPiece[] = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 7},
                             {7, 8}, {8, 0}, {1, 9}, {4, 9}, {7, 9}, {6, 2}};
  return five_pieces(kPiece, {{{5, 0}, {8, 3}}});
}

}  // namespace ar3d
