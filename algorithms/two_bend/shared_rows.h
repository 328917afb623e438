#pragma once

#include <vector>

#include "ar3d/algorithms/two_bend/coordinates.h"
#include "ar3d/algorithms/two_bend/flow.h"

namespace ar3d::two_bend {

/// Puts SPLITs into the row of the SPLIT below them where that costs nothing: the edge between them
/// then has one bend instead of two, and the view one row fewer. A row's SPLITs form a subtree of
/// the forest of SPLITs; it is drawn without crossings in the plane of the row if at each of its
/// SPLITs the columns reached through one arm lie beyond all those reached through the other.
/// Left alone: neighbours of a pole, and edges into or out of a pole's block.
/// @param cross  columns of the view, or any guess of their order (then see separate_rows).
/// @post  flow.row_owner and the roles of the view; no MERGE has both in-neighbours in one row.
/// Cost: O(n).
void share_rows(Flow& flow, bool columns, const Values& cross);

/// Gives SPLITs a row of their own again, next to the one they shared, until the condition of
/// share_rows holds for the columns `cross`. The order of all other entries stays as it is.
void separate_rows(Flow& flow, bool columns, const Values& cross, LongVector<NodeId>& list);

/// A guess of the order of the view's rows before its list is built: the owners' places, and next
/// to them the MERGEs.
Values guess_rows(const Flow& flow, bool columns, bool straighten);

/// True if the condition of share_rows holds in every row of the view (for expect_heavy and tests).
bool shared_rows_are_plane(const View& view, const Values& cross);

}  // namespace ar3d::two_bend
