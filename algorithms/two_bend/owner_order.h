#pragma once

#include "ar3d/algorithms/two_bend/flow.h"

namespace ar3d::two_bend {

/// Per listed MERGE the in-neighbour (its row's owner) next to which it stands (kNone for all other
/// nodes), fixed in time order before anything is laid out (Rule 2.1).
using Attachment = LongVector<NodeId>;
Attachment attach_merges(const View& view);

/// The owners that a SOURCE of the view keeps side by side (Rule 2.2).
struct Unit {
  NodeId first = kNone;
  NodeId second = kNone;
  NodeId third = kNone;      ///< kNone: the SOURCE's own row is placed elsewhere
  bool third_first = false;  ///< broken unit: the SOURCE's own row opens the whole list
};
Unit unit_of(const View& view, const Pole& pole);

/// The owners of the view in the order of their rows, before anything moves (Rule 2.2).
/// Along every edge from SPLIT to SPLIT the distance is at most the weights of both ends and of the
/// lighter subtrees.
/// @param weights  per node, what it counts in a tree; empty: 1 each.
LongVector<NodeId> order_owners(const View& view, const Attachment& attachment,
                                const LongVector<std::uint32_t>& weights = {});

}  // namespace ar3d::two_bend
