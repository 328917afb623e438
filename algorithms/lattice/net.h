#pragma once

#include <span>
#include <vector>

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

}  // namespace ar3d::lattice
