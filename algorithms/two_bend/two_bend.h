#pragma once

#include <array>

#include "ar3d/algorithms/algorithm.h"
#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"
#include "ar3d/model/guarantee.h"

namespace ar3d::two_bend {

struct Options {
  /// 0: plain. 1: vertices share rows and columns (share_rows), arms are balanced
  /// (choose_middle_values).
  int effort = kDefaultEffort;
  bool force_safe_layout = false;  ///< lay every component out by find_safe_layout (tests)
};

/// The promised box, in the number n of vertices (Lemma 2.18).
inline constexpr std::array<AxisBound, 3> kBox{linear(40) + 80, linear(40) + 80,
                                               quadratic(1000) + 1000};
/// The box that the ordinary rounds are held to.
inline constexpr std::array<AxisBound, 3> kOrdinaryBox{linear(40) + 80, linear(40) + 80,
                                                       quadratic(64) + 64};

/// Draws a simple graph of maximum degree 3 with at most two bends per edge and all angles at least
/// 120 degrees, exactly 120 at vertices of degree 3 (Theorem 2).
/// @param graph  n vertices, m edges; may be disconnected.
/// @return points of the lattice with squared length x^2 + y^2 + z^2/3; smallest x, y and z are 0.
/// @throws InputError if graph.max_degree() > 3 or there is no such effort.
/// Cost: O(n) plus greatest common divisors, O(n) memory. Differs from the paper: no cycles are
/// sought and no triangles contracted; the graph is swept along an st-order (docs/theorem2.md says
/// why).
Drawing draw(const Graph& graph, const Options& options = {});

/// The catalogue row `two-bend`.
Algorithm row();

}  // namespace ar3d::two_bend
