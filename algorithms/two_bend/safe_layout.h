#pragma once

#include "ar3d/algorithms/two_bend/layout.h"

namespace ar3d::two_bend {

/// The lists of a safe layout: plain ones, whose trees are weighed by the room that they get
/// (Step 2.10). Sets the special neighbours in flow.poles.
/// @param flow  as build_flow left it: nothing shares a row.
Lists build_safe_lists(Flow& flow);

/// A layout that exists for every component and keeps the proved box (Lemma 2.18). Not the smallest
/// one: it serves where the ordinary rounds find nothing, or nothing small enough.
/// Cost: O(n log n).
Layout find_safe_layout(const Flow& flow, const Lists& lists);

/// How many odd numbers the interval of a free MERGE gets in a safe layout (Lemma 2.9).
struct VvRoom {
  std::int64_t rows = 0;
  std::int64_t columns = 0;
};
VvRoom vv_room(std::size_t num_nodes);

/// b of the far lean (Lemma 2.14) for ordinary neighbours k >= 2 apart, k even.
std::int64_t far_b(std::int64_t k, bool alone);
/// The gap on the far side of the special row that lets the far lean fit.
std::int64_t far_gap(std::int64_t k, bool alone);

}  // namespace ar3d::two_bend
