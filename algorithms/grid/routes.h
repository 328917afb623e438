#pragma once

#include "ar3d/algorithms/grid/planes.h"
#include "ar3d/model/drawing.h"

namespace ar3d::grid {

/// A vertex's Cartesian position: (x_0 + x_1, x_0 + x_2, x_1 + x_2) with x_i = 3 X_i, an isometry
/// of the four coordinates of sum 0 that takes the twelve e_i - e_j to the face diagonals of the
/// unit cube.
Point position(const PlaneNumbers& x);

/// The two lengths whose residues mod 3 keep routes apart. Only tests change them, to see the
/// verifier object.
struct RouteRule {
  std::int64_t u_edge_last = 1;  ///< least length of a U-edge's last segment
  std::int64_t nt_first = 1;     ///< length of the first segment of a defect with E < 0
};

/// Step 3.8: the three bends of every edge, computed from the two labels,
/// the two ends and, for a defect with E > 0, its slot. Holds one byte per edge and the slots.
class Routes final : public BendSource {
 public:
  Routes(EdgeLabels labels, std::vector<Slot> slots, RouteRule rule = {});
  void append_bends(EdgeId e, Edge ends, Point at_u, Point at_v,
                    std::vector<Point>& out) const override;

 private:
  std::int64_t slot_of(EdgeId e) const;

  EdgeLabels labels_;
  std::vector<Slot> slots_;
  RouteRule rule_;
};

}  // namespace ar3d::grid
