#pragma once

#include "ar3d/algorithms/two_bend/layout.h"

// Conditions of the lemmas of docs/theorem2.md, for expect_heavy (builds with AR3D_CHECKS) and
// tests.

namespace ar3d::two_bend {

/// The list is an order of all its vertices in which exactly the first has no earlier neighbour,
/// and every vertex of degree 3 without a later (an earlier) neighbour has two neighbours that have
/// no other later (earlier) one.
bool is_time_order(const LocalGraph& graph, const TimeOrder& order);

/// No two long edges join the same SPLIT to the same MERGE.
bool arms_are_not_parallel(const Flow& flow);

/// Every listed MERGE stands strictly between its in-neighbours' rows in the list of the view.
bool merges_are_between(const View& view, const LongVector<NodeId>& list);

/// Owners even, all MERGEs of the view but straight ones odd and between their in-neighbours, at
/// the distances that Values promises.
bool merges_keep_distances(const View& view, const Values& values);

/// Rays at one (x, y) belong to edges whose spans of time do not overlap.
bool rays_differ(const Flow& flow, const Layout& layout);

/// Every VV lean is straight up or primitive.
bool vv_leans_are_primitive(const Flow& flow, const Layout& layout);

}  // namespace ar3d::two_bend
