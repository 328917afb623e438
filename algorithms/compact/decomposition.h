#pragma once

#include <array>
#include <vector>

#include "ar3d/model/graph.h"

namespace ar3d::compact {

/// The edge of each role at a vertex; `to` is kNobody where there is none.
inline constexpr Vertex kNobody = 0xffffffffu;
enum Role : std::size_t { kGreenOut = 0, kGreenIn = 1, kRedOut = 2, kRedIn = 3 };
inline bool is_red(Role role) { return role >= kRedOut; }
inline bool is_out(Role role) { return role == kGreenOut || role == kRedOut; }
inline Role opposite(Role role) { return static_cast<Role>(role ^ 1u); }
using Roles = std::array<HalfEdge, 4>;

/// Every edge is directed and green or red, such that every vertex has at most one edge of each
/// role.
struct Decomposition {
  UnwrittenVector<Roles> at;  ///< by vertex
  std::size_t num_green = 0;
};

/// Balanced orientation and two-colouring of docs/theorem1.md. O(n + m).
Decomposition decompose(const Graph& graph);

}  // namespace ar3d::compact
