#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "ar3d/algorithms/two_bend/flow.h"

namespace ar3d::two_bend {

/// Largest horizontal coordinate of a component: differences d, q then give d^2 + q^2 <= 2^61.
inline constexpr std::int64_t kMaxHorizontal = std::int64_t{1} << 30;

/// Holds what widens a list beyond its base gaps at one entry.
struct Widening {
  std::int64_t extra_before = 0;  ///< added to the gap directly before the entry
  std::int64_t extra_after = 0;   ///< added to the gap directly after the entry
  std::int64_t hold_gap = 0;      ///< least gap on both sides of the entry
};
/// By entry, of which few have any; the only state that persists from round to round (Step 2.9).
using Spacing = std::unordered_map<NodeId, Widening>;

/// The numbers of one view: rows (y) or columns (x), per node; meaningful for owners and MERGEs of
/// the view. Owners are even, MERGEs odd; a MERGE is strictly between its in-neighbours, at
/// distance at least 1 from an owner, 2 from a MERGE and 3 from a STATION.
using Values = LongVector<std::int32_t>;

/// The index of every node's row in the list, 0 for nodes that have none.
Values list_indices(const View& view, const LongVector<NodeId>& list);

/// Rule 2.5: numbers along the list; free MERGEs keep the number of their entry, if any.
/// @param bound  becomes an upper bound of the largest number, added up over the entries: each
/// counts 2 and a STATION 2 more, then come what widens the list and both gaps of special rows.
/// @throws InternalError if a number passes kMaxHorizontal.
Values number_list(const View& view, const LongVector<NodeId>& list, const Spacing& spacing,
                   std::int64_t& bound);

/// The odd numbers from low to high that a free MERGE may take (Rule 2.6); never empty.
struct OddInterval {
  std::int64_t low = 0;
  std::int64_t high = 0;
  std::int64_t count() const { return (high - low) / 2 + 1; }
  std::int64_t middle() const { return low + 2 * (count() / 2); }
  bool contains(std::int64_t value) const { return low <= value && value <= high; }
};
OddInterval interval_of(const View& view, const Values& values, NodeId merge);

/// Gives every free MERGE of the view that is no end of a VV edge the middle of its interval.
/// @param relaxes  Before, moves listed MERGEs towards the middle between their in-neighbours,
/// which shortens the longer of their two arms: once against and once with the view's time. Every
/// single move keeps all distances of Values: the MERGE stays between its in-neighbours and on its
/// side of the MERGE above it, and never comes nearer to a free one, so the intervals of free
/// MERGEs only grow. MERGEs below a SINK stay where they are, and so do those that a shared row of
/// the cross view reaches (see share_rows).
void choose_middle_values(const View& view, bool relaxes, Values& values);

/// For one VV edge: puts the MERGE into the row of the SPLIT and the SPLIT into the column of the
/// MERGE, so that the edge is straight, if both are inside the intervals; else an odd row of the
/// MERGE and an odd column of the SPLIT, as near to the middles of both
/// intervals as possible, such that the lean between the two stems is primitive (Rule 2.6). Certain
/// to succeed if the intervals hold the numbers that Lemma 2.9 asks for.
/// @return false if there is none; nothing is changed then.
bool choose_vv_values(const Flow& flow, const LongEdge& edge, Values& rows, Values& columns);

}  // namespace ar3d::two_bend
