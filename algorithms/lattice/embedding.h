#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "ar3d/model/graph.h"
#include "ar3d/model/lattice.h"

namespace ar3d::lattice {

/// One of the two space-filling graphs of the paper's Figure 1, on the unit cube grid. Both are
/// bipartite, and symmetric: some symmetry takes any vertex and edge at it to any others.
class SpaceNet {
 public:
  /// The diamond lattice: 4-regular, girth 6, edges (+-1, +-1, +-1) at arccos(-1/3).
  static const SpaceNet& diamond();
  /// The Laves graph: 3-regular, girth 10, edges along face diagonals at 120 degrees.
  static const SpaceNet& laves();

  const char* name() const { return name_; }
  /// Names the algorithm that draws its pieces.
  const char* algorithm() const { return is_diamond_ ? "lattice-109" : "lattice-120"; }
  /// From a vertex of the net to its neighbours; the origin is a vertex.
  std::span<const Vector> steps(Point vertex) const;
  bool are_adjacent(Point p, Point q) const;
  /// False only if every path from p to q has more than so many edges.
  bool may_reach(Point p, Point q, std::int64_t edges) const;
  /// Returns whether the net moved by t is the net.
  bool is_translation(Vector t) const;

 private:
  SpaceNet(const char* name, bool is_diamond);
  const char* name_;
  bool is_diamond_;
  std::vector<std::vector<Vector>> steps_;  // by the vertex modulo 4: 16 x + 4 y + z
};

inline constexpr std::uint32_t kNoStep = std::numeric_limits<std::uint32_t>::max();

/// The next vertex of a connected graph to be placed. Steps are numbered from 0.
struct EarStep {
  Vertex vertex = 0;
  std::uint32_t from = kNoStep;    ///< step of a neighbour before it; kNoStep of the first alone
  std::uint32_t target = kNoStep;  ///< step at the end of its ear; kNoStep if it lies on none
  std::uint32_t left = 0;          ///< edges from here to that end
};

/// The vertices of a connected graph (n >= 1) in the order of an ear decomposition that takes the
/// shortest ear it finds next; what lies on no cycle comes last. Cost: O(m log m) in pieces of
/// lattices, whose ears are short; O(n m) at worst.
std::vector<EarStep> ear_order(const Graph& graph);

/// Holds what a search for an embedding came to.
struct Embedding {
  bool is_given_up = false;   ///< too many tries: not decided
  std::vector<Point> points;  ///< a vertex of the net for every vertex, neighbours at neighbours;
                              ///< none if every way was tried: the graph is no part of the net
  std::uint64_t tries = 0;    ///< points that a vertex was tried at
};

/// Searches for a connected graph (n >= 1) as a subgraph of the net, the first vertex at the
/// origin. Cost: O(n) tries, of O(1) expected time each, in pieces whose cycles leave little
/// choice; finding out is NP-hard in general, so the search ends after `most_tries`.
Embedding embed(const Graph& graph, const SpaceNet& net, std::uint64_t most_tries);

}  // namespace ar3d::lattice
