#pragma once

#include <cstdint>
#include <optional>

#include "ar3d/algorithms/algorithm.h"
#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"

namespace ar3d::grid_paper {

/// Says how far apart the vertices of a flat cycle are drawn (Step G.5).
enum class Spread : std::uint8_t {
  columns,      ///< always so far that pieces of different vertices have no line in common
  conditional,  ///< as near as can be, and as columns where that touches what is drawn (the text)
  least,        ///< the nearest place that touches nothing
};

struct Options {
  Spread spread = Spread::conditional;
  /// How high above what is drawn the next cycle lies (Step G.6): with room for the connections
  /// that there are, else for whatever connection there could be (the text).
  bool needed_gap = false;
  /// Which chordless cycle is drawn next (Step G.2): the first that a walk closes, in linear time
  /// each, else a shortest one.
  bool any_cycle = false;
};

/// Largest number of vertices: Lemma G.5 keeps every coordinate, and sum of two, below 2^61.
inline constexpr std::uint32_t kMostVertices = 1u << 20;

/// The repairs of the text that can be left out, each by itself. Only tests do, to see the verifier
/// object, and only they ask for random cycles.
struct RepairSwitches {
  bool apart = true;                                ///< G.2
  bool k4 = true;                                   ///< G.6
  bool turned = true;                               ///< G.7
  bool spread = true;                               ///< G.8
  bool left = true;                                 ///< G.9
  bool own_heights = true;                          ///< G.10
  bool past_layer = true;                           ///< G.11
  bool cleared = true;                              ///< G.13
  bool switch_late = true;                          ///< G.14
  std::optional<std::uint64_t> random_cycles = {};  ///< seed of random walks that choose the cycles
};
/// Draws a simple graph of maximum degree 3 as the paper's proof of Theorem 3 builds it: flat
/// cycles one above the other, trees in vertical planes; repaired where the text fails. At most 3
/// bends an edge, segments on face diagonals of the unit cubes, exactly 120 degrees at every bend
/// and between any two segments at a vertex.
/// @param graph  n vertices, m edges; may be disconnected.
/// @return extents within the guarantee of row(), lengths in unit cubes; instance_bound is Lemma
/// G.5 with the numbers of cycles and of vertices on them that occur. Counters: the extents in the
/// paper's skewed coordinates, and how often each case occurs.
/// @throws InputError if graph.max_degree() > 3 or n > kMostVertices.
/// Cost: a breadth-first search for every change of a vertex's shortest cycle, each O(n) at worst;
/// a few comparisons for a vertex of a flat cycle, at worst with all others of it; O(log n) for any
/// other vertex; O(n) memory. Source: Theorem 3 of the paper; docs/theorem3-paper.md has the
/// construction, its repairs and its proof.
Drawing draw(const Graph& graph, const Options& options = {}, const RepairSwitches& repairs = {});

/// The catalogue row `grid-paper`.
Algorithm row();

}  // namespace ar3d::grid_paper
