#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "ar3d/model/graph.h"

namespace ar3d {

struct RealPoints;  // model/real_points.h

/// Holds what a drawing in a real type misses, found without tolerance: its points are dyadic
/// rationals, every inner product and every decision is exact, and each miss is rounded once, at
/// the end. Wanted are 120 degrees between the three edges at a vertex of degree 3, at least 120
/// between the two at a vertex of degree 2 and at every bend, no segment of length zero, and no two
/// segments with a common point but that of their bend or vertex. Segments of length zero are
/// counted and then left out of everything else.
struct RealAssessment {
  /// Shares are counted of misses of at most so many degrees.
  static constexpr std::array<double, 4> kLimits{1e-12, 1e-9, 1e-6, 1e-3};

  std::uint64_t angles = 0;     ///< judged
  double largest_miss = 0;      ///< of all angles, in degrees, relative error below 1e-14
  double mean_square_miss = 0;  ///< in degrees^2
  double smallest_vertex_angle = std::numeric_limits<double>::quiet_NaN();  ///< degrees, if any
  double smallest_bend_angle = std::numeric_limits<double>::quiet_NaN();    ///< likewise
  std::array<std::uint64_t, 4> within{};  ///< angles that miss by at most kLimits[i] degrees
  std::uint64_t segments = 0;             ///< of positive length
  std::uint64_t collapsed = 0;            ///< segments of length zero
  std::uint64_t crossings = 0;  ///< pairs of segments with a common point that they should not have
  /// Largest X1/l1 + X2/l2 over all angles, X and l the largest coordinate and the length of each
  /// side: a rounding of 2^-p of coordinates turns the angle by about 2^-p times as many radians.
  double condition = 0;
  std::vector<std::uint64_t> bend_histogram;  ///< entry b: number of edges with b bends

  /// Is the drawing one of the graph at all?
  bool is_broken() const { return collapsed > 0 || crossings > 0; }
};

/// Judges a drawing. @param edges  in order of their numbers; the bends of each run from u to v.
/// @throws InputError if the numbers of vertices or edges do not fit.
/// Cost: O(S log S), a comparison for every pair of segments whose boxes overlap along the axis
/// where the fewest are expected to, and an exact test for those that boxes and a filter in double
/// leave open; a product of big integers takes about a microsecond.
RealAssessment assess(const Graph& graph, const RealPoints& points);

}  // namespace ar3d
