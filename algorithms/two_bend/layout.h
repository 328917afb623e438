#pragma once

#include <array>
#include <optional>
#include <vector>

#include "ar3d/algorithms/two_bend/coordinates.h"
#include "ar3d/algorithms/two_bend/pole_shape.h"

namespace ar3d::two_bend {

/// The lists of rows and of columns of a component.
struct Lists {
  LongVector<NodeId> rows;
  LongVector<NodeId> columns;
};

struct ListOptions {
  bool share = true;        ///< lets vertices share rows and columns (share_rows)
  bool straighten = false;  ///< orders rows for straight VV edges (order_owners)
  /// Per node, what it weighs in the trees of rows and of columns; empty: 1 each.
  std::array<LongVector<std::uint32_t>, 2> weights;
};

/// Builds both lists, columns first if the component is joint and its SOURCE is A-type, else rows
/// first; chooses the special neighbours of V-type poles in flow.poles.
Lists build_lists(Flow& flow, const ListOptions& options);

/// Everything horizontal about a component's drawing. Invariants: rays that are active at one time
/// stand at different (x, y); every VV lean is primitive; every pole's leans are primitive and turn
/// by at most 60 degrees.
struct Layout {
  Values rows;     ///< y of a node's row
  Values columns;  ///< x of a node's column
  LongVector<PoleShape>
      poles;            ///< one entry per flow.poles, in the view in which the pole is a SINK
  unsigned rounds = 1;  ///< numberings tried, the successful one included
  bool safe = false;    ///< it is a safe layout (safe_layout.h)
  std::array<std::int64_t, 2> width_bound{};  ///< of rows, of columns: see bound_of_list
  std::int64_t largest_gap = 0;               ///< of the gaps around special rows and columns
};

/// Step 2.9: numbers, chooses free values and fits the poles, at most kOrdinaryRounds times, and
/// widens in between what failed. Nothing if every round failed.
/// @param relax_passes  see relax_merges.
std::optional<Layout> find_layout(const Flow& flow, const Lists& lists, unsigned relax_passes);

inline constexpr unsigned kOrdinaryRounds = 10;

}  // namespace ar3d::two_bend
