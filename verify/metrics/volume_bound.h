#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "ar3d/model/graph.h"
#include "ar3d/model/guarantee.h"

namespace ar3d {

/// What a routing shows: a lower bound of the bisection width, and what more sources could make of it.
using RoutedBisection = std::pair<std::uint64_t, std::uint64_t>;

/// Holds what docs/lower-bounds.md takes from a graph; equal for all algorithms.
struct GraphNeeds {
  std::uint64_t vertices = 0;
  std::uint64_t edges = 0;
  std::uint64_t part_vertices = 0;  ///< of the largest component
  /// Between any two halves of that component (their sizes differ by at most one) run at least so
  /// many edges; 0 until that is looked for.
  std::uint64_t bisection = 0;
  std::vector<RoutedBisection> bisections;  ///< that seek_bisection() has found, ever better ones
};

/// Without a bisection. O(n + m).
GraphNeeds needs_of(const Graph& graph);

/// Looks for the bisection of a component of 512 to 16,384 vertices, as long as what can be found
/// would enlarge volume_at_least() for this guarantee by more than 2 %; which other guarantees were
/// asked for before makes no difference. At most some 0.1 s.
void seek_bisection(const Graph& graph, const Guarantee& guarantee, GraphNeeds& needs);

/// No drawing of such a graph that keeps the guarantee has a box of fewer lattice points (Lemma
/// L.5). -1 for a guarantee of drawings in real types, which stand on no lattice.
/// Cost: O(V^(2/3) log V) for a result V, which is less than the cost of a drawing.
std::int64_t volume_at_least(const GraphNeeds& needs, const Guarantee& guarantee);
/// Without a bisection.
std::int64_t volume_at_least(const Graph& graph, const Guarantee& guarantee);

/// Lemma L.4 for a connected graph of degree at most 4 and fewer than 2^16 vertices. Every source
/// sends one unit to every vertex along shortest paths, up to 64 sources at a time, those with
/// edges of least load. They are added, twice as many each time, while four times as many raise the
/// bound by a tenth, and what they could raise it to is worth it.
/// @param vertices  of a component of at least two vertices. @param most_visits  of vertices and
/// half-edges by sources, if more than the first. @param is_worth  asked for the result so far.
/// @return the results, without a source and with ever more of them.
std::vector<RoutedBisection> route_bisection(
    const Graph& graph, std::span<const Vertex> vertices, std::uint32_t most_visits,
    const std::function<bool(const RoutedBisection&)>& is_worth);

/// The lattice points of the smallest box of a drawing of this graph with the guarantee's angles
/// and directions and at most as many bends, vertices anywhere, if results/reference/optima.csv has
/// it; else -1. Cost: exponential up to seven vertices, else O(1).
std::int64_t known_optimum(const Graph& graph, const Guarantee& guarantee);

/// Says which points a connected drawing can use.
enum class DrawnSteps : std::uint8_t {
  any,             ///< of directions that are not those below, or at angles that are not exact
  body_diagonals,  ///< unit steps (+-1, +-1, +-1) at exactly arccos(-1/3)
  face_diagonals   ///< unit steps along face diagonals of unit cubes at exactly 120 degrees
};

DrawnSteps steps_of(const Guarantee& guarantee);

/// Holds what a box has to hold (Lemmas L.2 and L.3).
struct BoxNeeds {
  DrawnSteps steps = DrawnSteps::any;
  std::uint64_t points = 1;    ///< used by the drawing
  std::uint64_t in_plane = 0;  ///< of them in one plane
  std::uint64_t in_layer = 0;  ///< in one layer across every axis
  std::uint64_t side = 1;      ///< lattice points along every axis
};

/// The lattice points of the smallest box that holds so much. O(V^(2/3) log V) for a result V.
std::uint64_t smallest_box(const BoxNeeds& needs);

}  // namespace ar3d
