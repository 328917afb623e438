#pragma once

#include <cstdint>
#include <vector>

#include "ar3d/algorithms/grid_paper/grid_paper.h"

namespace ar3d::grid_paper {

/// A point of a layer. h = 2y + x is twice the distance to the right in the true picture: e_Y is
/// (2, 0), e_X is (1, 1), e_X - e_Y is (-1, 1).
struct LayerPoint {
  std::int64_t h = 0;
  std::int64_t x = 0;
  std::int64_t y() const { return (h - x) / 2; }
};

/// A cycle drawn in one layer.
struct FlatCycle {
  std::vector<LayerPoint> at;                  ///< the first at h = 0
  std::vector<std::vector<LayerPoint>> bends;  ///< of edge i from vertex i to vertex i + 1; of the
                                               ///< last one, which closes the cycle, from vertex 0
  std::int64_t spread = 0;                     ///< vertices that are not at the nearest place
};

/// Steps G.4 and G.5 (the paper's lemma "flat single cycle"): every vertex i at x[i], with its leg
/// from (h, x) to (h + 2, x) free.
/// @param x  at least three even numbers, which may repeat; if their number is odd, x[0] < x[1].
/// @param least_run  half the least length of a run: 2 for K4, else 1.
/// @param all_spread  Repair G.8; without it only the lengths of runs keep vertices apart.
/// Cost: k vertices are compared with the few before them whose pieces they can reach; O(k^2 log k)
/// at worst, O(k) with Spread::columns.
FlatCycle draw_flat_cycle(const std::vector<std::int64_t>& x, Spread spread, std::int64_t least_run,
                          bool all_spread);

}  // namespace ar3d::grid_paper
