#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ar3d/model/graph.h"
#include "ar3d/model/real_points.h"

namespace ar3d::verify {

/// A difference of points, in units.
using BigVector = BigPoint;

/// A point rounded to doubles, each to within 2^-53 of its value.
using RoundedPoint = std::array<double, 3>;
/// The point scaled by 2^shift, coordinate by coordinate.
RoundedPoint rounded(const BigPoint& p, int shift);
/// value * 2^shift, rounded.
double rounded(const BigInteger& value, int shift);

/// A segment of positive length, or a vertex without edges.
struct RealSegment {
  BigPoint from;
  BigPoint to;
  EdgeId edge = 0;
  bool is_first = false;   ///< of its edge: `from` is the end u
  bool is_last = false;    ///< of its edge: `to` is the end v
  bool is_vertex = false;  ///< from == to, no edge
};

/// All segments of positive length, edge after edge, then the vertices without edges.
std::vector<RealSegment> segments_of(const Graph& graph, const RealPoints& points);

/// Pairs of segments with a common point that they should not have; every pair decided exactly.
/// By boxes and a filter in double, in order of height.
std::uint64_t count_crossings(const Graph& graph, const std::vector<RealSegment>& segments,
                              int unit_exponent);
/// Have segments i and j a common point that they should not have?
bool crosses(const Graph& graph, const std::vector<RealSegment>& segments, std::size_t i,
             std::size_t j);

/// By how many degrees the angle of the vectors u and v is smaller than 120 degrees (negative:
/// larger): exact inner products, rounded once. The sign is exact, the relative error below 1e-14.
double short_of_120(const BigVector& u, const BigVector& v);

}  // namespace ar3d::verify
