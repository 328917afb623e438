#pragma once

#include <array>

#include "ar3d/algorithms/two_bend/coordinates.h"

namespace ar3d::two_bend {

/// The lists of rows and of columns of a component.
struct Lists {
  LongVector<NodeId> rows;
  LongVector<NodeId> columns;
};

/// Per node, what it weighs in the trees of rows and of columns; empty: 1 each.
using TreeWeights = std::array<LongVector<std::uint32_t>, 2>;

/// Builds both lists, columns first if the component is joint and its SOURCE is A-type, else rows
/// first; chooses the special neighbours of V-type poles in flow.poles.
/// @param share  lets vertices share rows and columns (share_rows).
Lists build_lists(Flow& flow, bool share, const TreeWeights& weights = {});

/// True if the condition of share_rows holds in every row of the view (for expect_heavy and tests).
bool shared_rows_are_plane(const View& view, const Values& cross);

}  // namespace ar3d::two_bend
