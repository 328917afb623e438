#pragma once

#include <array>
#include <vector>

#include "ar3d/algorithms/compact_120/letters.h"
#include "ar3d/algorithms/compact_120/owners.h"
#include "ar3d/model/graph.h"

namespace ar3d::compact_120 {

inline constexpr Vertex kNobody = 0xffffffffu;

/// The edge at an arm of a vertex.
struct Link {
  Vertex to = kNobody;
  std::uint32_t edge : 28 = 0;     ///< its number: below 3 kMaxVertices / 2
  std::uint32_t is_out : 1 = 0;    ///< the vertex is its tail
  std::uint32_t is_right : 1 = 0;  ///< the other end is to the right
  std::uint32_t at : 2 = 0;        ///< its Arrival
  bool is_set() const { return to != kNobody; }
  /// The edge runs to the right, from its tail to its head.
  bool runs_right() const { return is_out == is_right; }
  Arrival arrival() const { return static_cast<Arrival>(at); }
  /// It arrives at T on 01 or at S on 20. (At N edges to the right arrive on 20, to the left on
  /// 01.)
  bool is_steep() const { return arrival() == (runs_right() ? Arrival::on_01 : Arrival::on_20); }
};

/// The class of every vertex and the edge at each of its arms. An own edge to the right leaves at
/// 01, one to the left at 20; edges arrive
///   at N from the left on 12 or 20, from the right on 12 or 01;
///   at S from the right on 12 or 20; at T from the left on 12 or 01.
struct Links {
  LongVector<std::array<Link, 3>> at;  ///< by vertex and Arm
  LongVector<Class> of;                ///< by vertex
};

/// Step D.5. @param owners  none of them crowded. O(n).
Links assign_arms(const Graph& graph, const Order& order, const Owners& owners);

}  // namespace ar3d::compact_120
