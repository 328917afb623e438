#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "ar3d/algorithms/grid/labels.h"
#include "ar3d/algorithms/grid/order.h"
#include "ar3d/base/error.h"
#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"

namespace ar3d::grid {

/// The three plane numbers X_0, X_1, X_2 of a vertex: its position is x_i = 3 X_i, x_3 = -3 S, S
/// their sum.
using PlaneNumbers = std::array<std::int32_t, kColours>;
inline constexpr std::int32_t kUnsetNumber = std::numeric_limits<std::int32_t>::min();
inline constexpr PlaneNumbers kUnsetNumbers = {kUnsetNumber, kUnsetNumber, kUnsetNumber};

/// @throws InternalError if x does not fit.
inline std::int32_t narrow(std::int64_t x) {
  expect(x > kUnsetNumber && x <= std::numeric_limits<std::int32_t>::max(),
         "plane numbers fit 32 bits");
  return static_cast<std::int32_t>(x);
}

inline bool all_within(std::int64_t bound, const PlaneNumbers& numbers) {
  return std::ranges::all_of(numbers, [&](std::int64_t x) { return -bound <= x && x <= bound; });
}

inline std::int64_t sum_of(const PlaneNumbers& x) { return std::int64_t{x[0]} + x[1] + x[2]; }

/// The slot of a defect with E > 0: numbers k-1 and k of its third colour belong to it alone.
struct Slot {
  EdgeId edge = 0;
  std::int64_t k = 0;
};

/// Holds how often each case of the construction was used.
struct PlaneCounts {
  std::int64_t nt = 0;            ///< clashes solved with E < 0
  std::int64_t pq = 0;            ///< clashes solved with E > 0 and a slot
  std::int64_t last_edge_u = 0;   ///< psi = phi
  std::int64_t last_edge_m = 0;   ///< psi = phi - 1
  std::int64_t last_edge_p = 0;   ///< psi = phi + 1
  std::int64_t restarts = 0;      ///< the zone was too small
  std::int64_t flat_defects = 0;  ///< defects of components with flat numbers
  std::int64_t core_parts = 0;    ///< components that the core numbered
};

/// Steps whose number decides the time: each takes O(log n) expected time, everything else is
/// linear. They grow like n on every input (docs/theorem3.md, "Linear time").
struct StepCounts {
  std::int64_t chain_steps = 0;    ///< edges of Kempe chains followed, and defects met there
  std::int64_t heights_tried = 0;  ///< free heights looked at, slots included
  std::int64_t end_visits = 0;     ///< attempts to finish a path that ends at a defect
  std::int64_t blocks = 0;         ///< blocks of 64 numbers looked at
  std::int64_t attempts = 0;       ///< numberings begun, flat or by the core

  StepCounts& operator+=(const StepCounts& other) {
    chain_steps += other.chain_steps;
    heights_tried += other.heights_tried;
    end_visits += other.end_visits;
    blocks += other.blocks;
    attempts += other.attempts;
    return *this;
  }
};

/// Plane numbers, all labels, slots.
/// Invariant: (I1)-(I5) of docs/theorem3.md within every component.
struct Planes {
  std::vector<PlaneNumbers> of;
  EdgeLabels labels;
  std::vector<Slot> slots;  // in order of edge numbers
  PlaneCounts counts;
  StepCounts steps;
};

struct PlaneOptions {
  bool flat = true;                    ///< try the flat numbers first, component by component
  std::uint64_t longest_chain = 8192;  ///< edges of a Kempe chain; 0: none; only for flat numbers
  std::int64_t flat_allowance = 300;   ///< flat numbers beyond 2 n + this are left to the core
};

/// Plane numbers of every component on its own: flat ones where asked for and possible, else the
/// core's (Step 3.6). Never fails.
/// Cost: O(n log n) expected over the stream of random numbers, on every input.
Planes assign_planes(const Graph& graph, const ProcessingOrder& order, const PlaneOptions& options);

/// The bound on plane numbers that the size proof gives for a component with n vertices:
/// |X_i| <= 150 n + 300.
inline constexpr std::int64_t proved_plane_bound(std::int64_t n) { return 150 * n + 300; }

/// Step 3.7: moves the components' drawings apart, side by side in layers of about square shape,
/// the thickest first. A move by multiples of 6 along the axes adds integers to the plane numbers
/// of a component and keeps its routes. Cost: O(n + m + k log k) for k > 1 components, O(1) for
/// one.
void pack_components(const Graph& graph, const ProcessingOrder& order, Planes& planes);

/// A vertex's Cartesian position: (x_0 + x_1, x_0 + x_2, x_1 + x_2) with x_i = 3 X_i, an isometry
/// of the four coordinates of sum 0 that takes the twelve e_i - e_j to the face diagonals of the
/// unit cube.
Point position(const PlaneNumbers& x);

/// Step 3.8: the three bends of every edge, computed from the two labels,
/// the two ends and, for a defect with E > 0, its slot. Holds one byte per edge and the slots.
class Routes final : public BendSource {
 public:
  Routes(EdgeLabels labels, std::vector<Slot> slots)
      : labels_(std::move(labels)), slots_(std::move(slots)) {}
  void append_bends(EdgeId e, Edge ends, Point at_u, Point at_v,
                    std::vector<Point>& out) const override;

 private:
  std::int64_t slot_of(EdgeId e) const;

  EdgeLabels labels_;
  std::vector<Slot> slots_;
};

}  // namespace ar3d::grid
