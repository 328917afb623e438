#pragma once

#include <vector>

#include "ar3d/algorithms/two_bend/entry_list.h"
#include "ar3d/algorithms/two_bend/flow.h"

namespace ar3d::two_bend {

/// Builds the list of a view (Rules 2.1 to 2.4): owners, listed MERGEs and the rows that SINKs ask
/// for. Invariants: every listed MERGE stands strictly between its two in-neighbours; the row of a
/// SINK's special edge (hold) stands strictly between its two ordinary in-neighbours c and w.
/// Chooses the special neighbour of every V-type SINK of the view that has none: the median of the
/// three. Cost: O(n).
/// @param straighten  see order_owners.
/// @param weights  see order_owners.
LongVector<NodeId> build_view_list(Flow& flow, bool columns, bool straighten,
                                   const LongVector<std::uint32_t>& weights = {});

/// For the view built second: makes the special neighbour of every V-type SINK an outer one of its
/// three in the list of the other view, the one farther from the middle one.
void choose_outer_specials(Flow& flow, bool columns_are_second,
                           const LongVector<NodeId>& first_list);

}  // namespace ar3d::two_bend
