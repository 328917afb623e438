#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "ar3d/algorithms/two_bend/time_order.h"

namespace ar3d::two_bend {

using NodeId = std::uint32_t;  // number of a node in time order
using LongId = std::uint32_t;
inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Says what a vertex is, by its numbers of earlier and later neighbours. PASS (1, 1) is no
/// node.
enum class NodeType : std::uint8_t {
  start,    ///< (0, 1)
  end,      ///< (1, 0)
  split,    ///< (1, 2) and (0, 2): stem below, two arms in its row
  merge,    ///< (2, 1) and (2, 0): two arms in its column, stem above
  station,  ///< a PASS with a row and a column of its own, so that no two AA edges are parallel
  source,   ///< (0, 3)
  sink,     ///< (3, 0)
};

/// The type after reversing time.
NodeType dual(NodeType type);

struct Node {
  NodeType type{};
  std::uint8_t ins = 0;
  std::uint8_t outs = 0;
  std::array<NodeId, 3> neighbour{};  ///< lower ends of the ins, then upper ends of the outs
};

/// A chain of PASS vertices between two nodes. Long edges are numbered in time order of their lower
/// ends.
struct LongEdge {
  NodeId lower = 0;
  NodeId upper = 0;
  EdgeId first_edge = 0;  ///< input edge at the lower end
};

/// A SOURCE or SINK and the kind of its special edge (the one drawn in the plane of symmetry of its
/// three segments).
struct Pole {
  NodeId node = 0;
  bool a_type = false;  ///< one neighbour is a SPLIT/SOURCE (of a SINK), MERGE/SINK (of a SOURCE);
                        ///< else V-type
  NodeId special = kNone;  ///< the special neighbour; V-type: chosen while the lists are built
};

/// Most SPLITs in one row (see share_rows). A constant, so that the bound of the height keeps its
/// proof.
inline constexpr std::uint32_t kMostSharers = 32;

/// Says what a node is in the lists of a view; see View.
enum : std::uint8_t {
  kOwner = 1,
  kListedMerge = 2,
  kFreeMerge = 4,
  kSpecialSplit = 8,
  kSharesRow = 16
};

/// The oriented component with PASS vertices suppressed; nodes are numbered in time order.
struct Flow {
  LongVector<Node> nodes;
  LongVector<LongEdge> edges;
  LongVector<Pole> poles;
  std::array<LongVector<NodeType>, 2> types;  ///< per node, in the row and in the column view
  std::array<LongVector<std::uint8_t>, 2>
      roles;  ///< per node: bits of these roles in the row and in the column view
  std::array<LongVector<NodeId>, 2>
      row_owner;  ///< per node, in the row and in the column view: whose row it stands in
  LongVector<std::uint32_t> index;  ///< per vertex, in the time order; empty if joint and long
  LongVector<std::uint32_t>
      element;  ///< per index: node, or long edge if is_pass; empty if no index is
  LongVector<std::uint32_t> node_index;  ///< per node; empty if element is
  std::vector<bool> is_pass;             ///< per index in the time order
  LongVector<BlockId> block;             ///< per node; empty if joint
  LongVector<NodeId>
      block_entry;  ///< per block of a pole: its only node at a bridge, kNone if none
  /// Edges from a MERGE up to a SPLIT, whose leans must be primitive; in time order of their lower
  /// ends.
  LongVector<LongId> vv_edges;
  bool joint = false;

  std::uint32_t index_of(NodeId v) const { return node_index.empty() ? v : node_index[v]; }
  NodeId node_at(std::uint32_t i) const { return element.empty() ? i : element[i]; }
  /// The number of a pole: they are in time order.
  std::size_t pole_of(NodeId v) const;
  /// Frees what only the lists and their numbers need: roles, owners and blocks.
  void forget_lists();
  /// The node's block has a pole and bridges.
  bool in_pole_block(NodeId v) const { return !joint && block_entry[block[v]] != kNone; }
  /// From a MERGE up to a SPLIT.
  bool is_vv_edge(LongId e) const {
    return types[0][edges[e].lower] == NodeType::merge &&
           types[0][edges[e].upper] == NodeType::split;
  }
  bool adjacent_poles(const Pole& pole) const {
    return pole.special != kNone &&
           (types[0][pole.special] == NodeType::source || types[0][pole.special] == NodeType::sink);
  }
};

/// Types, long edges and stations of an ordered component; O(n).
Flow build_flow(const LocalGraph& graph, const BlockTree& blocks, const TimeOrder& order);

/// One of the two lists of the construction as seen by the code: the rows of the component, or the
/// columns, which are the rows of the time-reversed component. Everything below says "row" and
/// means either.
class View {
 public:
  View(const Flow& flow, bool columns) : flow_(&flow), columns_(columns) {}

  const Flow& flow() const { return *flow_; }
  bool columns() const { return columns_; }
  NodeId size() const { return static_cast<NodeId>(flow_->nodes.size()); }
  /// The i-th node in the view's time.
  NodeId at(NodeId i) const { return columns_ ? size() - 1 - i : i; }
  /// Prefetches an array's entries of the neighbours of the i-th node, if there is one; i may
  /// have wrapped below 0.
  template <class T>
  [[gnu::always_inline]] void prefetch_neighbours(NodeId i, const LongVector<T>& array) const {
    if (i >= size()) return;
    for (const NodeId u : flow_->nodes[at(i)].neighbour) prefetch(array, u);
  }
  NodeType type(NodeId v) const { return flow_->types[columns_ ? 1 : 0][v]; }
  std::span<const NodeId> ins(NodeId v) const {
    return half(flow_->nodes[v].neighbour, v, columns_);
  }
  std::span<const NodeId> outs(NodeId v) const {
    return half(flow_->nodes[v].neighbour, v, !columns_);
  }

  const Pole& pole(NodeId v) const { return flow_->poles[flow_->pole_of(v)]; }
  /// The node whose row v stands in: v itself, or for a SPLIT one below it (see share_rows).
  NodeId row_of(NodeId v) const { return flow_->row_owner[columns_ ? 1 : 0][v]; }
  [[gnu::always_inline]] void prefetch_rows(NodeId i) const {
    prefetch_neighbours(i, flow_->row_owner[columns_ ? 1 : 0]);
  }
  [[gnu::always_inline]] void prefetch_types(NodeId i) const {
    prefetch_neighbours(i, flow_->types[columns_ ? 1 : 0]);
  }
  [[gnu::always_inline]] void prefetch_type_of(NodeId v) const {
    prefetch(flow_->types[columns_ ? 1 : 0], v);
  }
  /// Has an even row of its own.
  bool is_owner(NodeId v) const { return has_role(v, kOwner); }
  /// A MERGE with an odd entry in the list.
  bool is_listed_merge(NodeId v) const { return has_role(v, kListedMerge); }
  /// A MERGE whose row is chosen after all others (Rule 2.6).
  bool is_free_merge(NodeId v) const { return has_role(v, kFreeMerge); }
  /// A SPLIT with others in its row.
  bool shares_row(NodeId v) const { return has_role(v, kSharesRow); }
  /// The SPLIT whose arm is the special edge of a SINK.
  bool is_special_split(NodeId v) const { return has_role(v, kSpecialSplit); }
  /// The node whose row carries the special edge of the SINK `pole`.
  NodeId hold_of(const Pole& pole) const { return pole.a_type ? pole.special : pole.node; }
  /// The two other neighbours of a pole whose special one is known.
  std::array<NodeId, 2> ordinary_of(const Pole& pole) const;

 private:
  bool has_role(NodeId v, std::uint8_t role) const {
    return (flow_->roles[columns_ ? 1 : 0][v] & role) != 0;
  }
  std::span<const std::uint32_t> half(const std::array<std::uint32_t, 3>& all, NodeId v,
                                      bool upper) const {
    const Node& node = flow_->nodes[v];
    return upper ? std::span(all.data() + node.ins, node.outs) : std::span(all.data(), node.ins);
  }

  const Flow* flow_;
  bool columns_;
};

}  // namespace ar3d::two_bend
