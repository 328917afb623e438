#pragma once

#include <array>
#include <cstdint>

#include "ar3d/algorithms/two_bend/coordinates.h"
#include "ar3d/algorithms/two_bend/flow.h"

namespace ar3d::two_bend {

/// The lists of rows and of columns of a component.
using Lists = std::array<LongVector<NodeId>, 2>;

/// Per node, what it weighs in the trees of rows and of columns; empty: 1 each.
using TreeWeights = std::array<LongVector<std::uint32_t>, 2>;

/// Builds both lists, columns first if the component is joint and its SOURCE is A-type, else rows
/// first; chooses the special neighbours of V-type poles in flow.poles.
/// @param share  lets vertices share rows and columns (share_rows).
Lists build_lists(Flow& flow, bool share, const TreeWeights& weights = {});

/// A linked list of entries with order tests. Each entry belongs to the cluster of the owner it was
/// put next to; clusters are contiguous, so two entries of different clusters compare by rank,
/// others by a walk inside the cluster (needed O(1) times a cluster: Rule 2.3).
class EntryList {
 public:
  /// The owners in their order, each a cluster of its own; room for entries below num_nodes.
  EntryList(std::size_t num_nodes, const LongVector<NodeId>& owners);

  NodeId first() const { return first_; }
  /// All entries. Walks from several indices at once, so that reads of memory overlap.
  LongVector<NodeId> in_order() const;
  bool contains(NodeId v) const { return links_[v].cluster != kNone; }
  /// Prefetches an entry.
  [[gnu::always_inline]] void prefetch_entry(NodeId v) const { prefetch(links_, v); }

  bool before(NodeId u, NodeId v) const;
  void insert_after(NodeId index, NodeId v);
  void insert_before(NodeId index, NodeId v);  ///< never before the first entry
  void remove(NodeId v);                       ///< v is the only entry of its cluster

 private:
  struct ListedEntry {
    NodeId previous = kNone;
    NodeId next = kNone;
    NodeId cluster = kNone;  // its owner; kNone: not in the list
    std::uint32_t rank = 0;  // of the cluster, kept at its owner
  };
  void link(NodeId left, NodeId v, NodeId right, NodeId cluster);
  bool walk_before(NodeId u, NodeId v) const;

  LongVector<ListedEntry> links_;
  LongVector<NodeId> starts_;  // a few entries in the order of the list, none that was moved
  NodeId first_ = kNone;
};

/// Builds the list of a view (Rules 2.1 to 2.4): owners, listed MERGEs and the rows that SINKs ask
/// for. Invariants: every listed MERGE stands strictly between its two in-neighbours; the row of a
/// SINK's special edge (hold) stands strictly between its two ordinary in-neighbours c and w.
/// Chooses the special neighbour of every V-type SINK of the view that has none: the median of the
/// three. Cost: O(n).
/// @param weights  see order_owners.
LongVector<NodeId> build_view_list(Flow& flow, bool columns,
                                   const LongVector<std::uint32_t>& weights = {});

/// For the view built second: makes the special neighbour of every V-type SINK an outer one of its
/// three in the list of the other view, the one farther from the middle one.
void choose_outer_specials(Flow& flow, bool columns_are_second,
                           const LongVector<NodeId>& first_list);

/// True if the condition of share_rows holds in every row of the view (tests).
bool shared_rows_are_plane(const View& view, const Values& cross);

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
