#pragma once

#include <array>
#include <optional>

#include "ar3d/algorithms/two_bend/coordinates.h"
#include "ar3d/algorithms/two_bend/leans.h"
#include "ar3d/algorithms/two_bend/lists.h"

namespace ar3d::two_bend {

/// Everything horizontal about a component's drawing. Invariants: rays that are active at one time
/// stand at different (x, y); every VV lean is primitive; every pole's leans are primitive and turn
/// by at most 60 degrees.
struct Layout {
  Values rows;     ///< y of a node's row
  Values columns;  ///< x of a node's column
  LongVector<PoleShape>
      poles;            ///< one entry per flow.poles, in the view in which the pole is a SINK
  unsigned rounds = 1;  ///< numberings tried, the successful one included
  bool safe = false;    ///< it is a safe layout (find_safe_layout)
  std::array<std::int64_t, 2> width_bound{};  ///< of rows, of columns: see number_list
  std::int64_t largest_gap = 0;               ///< of the gaps around special rows and columns
};

/// Step 2.9: numbers, chooses free values and fits the poles, at most kOrdinaryRounds times, and
/// widens in between what failed. Nothing if every round failed.
/// @param relaxes  see choose_middle_values.
std::optional<Layout> find_layout(const Flow& flow, const Lists& lists, bool relaxes);

inline constexpr unsigned kOrdinaryRounds = 10;

/// The lists of a safe layout: plain ones, whose trees are weighed by the room that they get
/// (Step 2.10). Sets the special neighbours in flow.poles.
/// @param flow  as build_flow left it: nothing shares a row.
Lists build_safe_lists(Flow& flow);

/// A layout that exists for every component and keeps the proved box (Lemma 2.18). Not the smallest
/// one: it serves where the ordinary rounds find nothing, or nothing small enough.
/// Cost: O(n log n).
Layout find_safe_layout(const Flow& flow, const Lists& lists);

/// Returns how many odd numbers the interval of a free MERGE gets in a safe layout (Lemma 2.9).
/// @return of rows, of columns.
std::array<std::int64_t, 2> vv_room(std::size_t num_nodes);

/// b of the far lean (Lemma 2.14) for ordinary neighbours k >= 2 apart, k even.
std::int64_t far_b(std::int64_t k, bool alone);
/// The gap on the far side of the special row that lets the far lean fit.
std::int64_t far_gap(std::int64_t k, bool alone);

}  // namespace ar3d::two_bend
