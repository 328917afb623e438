// Step 2.6: types, long edges and stations of the oriented component, in one pass along the time
// order so that memory is read in that order. A STATION is made where two AA edges would be
// parallel. Cost: O(n).
#include "ar3d/algorithms/two_bend/flow.h"

#include <algorithm>
#include <numeric>

#include "ar3d/base/error.h"

namespace ar3d::two_bend {

NodeType dual(NodeType type) {
  using enum NodeType;
  constexpr std::array<NodeType, 7> kDuals{end, start, merge, split, station, sink, source};
  return kDuals[static_cast<std::size_t>(type)];
}

namespace {

NodeType type_of(unsigned ins, unsigned outs) {
  if (ins + outs == 1) return ins == 0 ? NodeType::start : NodeType::end;
  if (ins == 3) return NodeType::sink;
  if (outs == 3) return NodeType::source;
  return outs == 2 ? NodeType::split : NodeType::merge;
}

/// Works on indices in the time order, so that memory is read in this order where the graph allows.
class FlowBuilder {
 public:
  FlowBuilder(const LocalGraph& graph, const TimeOrder& order)
      : graph_(graph),
        order_(order.list),
        pass_(order_.size(), false),
        count_(static_cast<NodeId>(order_.size())) {
    flow_.index.assign(graph.size(), 0);
    for (std::uint32_t i = 0; i < order_.size(); ++i) flow_.index[order_[i]] = i;
    flow_.joint = order.joint;
  }

  Flow build(const BlockTree& blocks) {
    const auto may_pass = [](const NeighbourList& near) { return near.degree() == 2; };
    if (!flow_.joint && std::any_of(graph_.neighbours.begin(), graph_.neighbours.end(), may_pass)) {
      find_passes();
    }
    number_nodes();
    flow_.edges.reserve(std::size_t{3} * count_ / 2);
    for (LongVector<NodeType>& types : flow_.types) types.reserve(count_);
    if (!flow_.joint) flow_.block.reserve(count_);
    for (std::uint32_t i = 0; i < order_.size(); ++i) {
      prefetch_node(i);
      if (pass_[i]) continue;
      if (!flow_.joint) flow_.block.push_back(blocks.id_of(order_[i]));
      finish_node(i);
    }
    find_poles(blocks);
    flow_.is_pass = std::move(pass_);
    if (flow_.joint) release(flow_.index);
    return std::move(flow_);
  }

 private:
  /// The steps upwards from the vertex at an index, at most three: a later neighbour's index and the
  /// edge to it.
  unsigned steps_up(std::uint32_t i, std::array<HalfEdge, 3>& steps) const {
    const Vertex v = order_[i];
    const NeighbourList& near = graph_.neighbours[v];
    unsigned count = 0;
    for (std::size_t k = 0; k < near.degree(); ++k) {
      const std::uint32_t to = flow_.index[near.to[k]];
      if (to > i) steps[count++] = {to, graph_.edges[v][k]};
    }
    return count;
  }

  /// Prefetches, in four steps, what the indices soon after i need.
  [[gnu::always_inline]] void prefetch_node(std::uint32_t i) const {
    if (i + 4 * kAhead >= order_.size()) return;
    const Vertex far = order_[i + 4 * kAhead];
    prefetch(graph_.neighbours, far);
    prefetch(graph_.edges, far);
    for (const Vertex u : graph_.neighbours[order_[i + 3 * kAhead]].to) prefetch(flow_.index, u);
    if (!flow_.element.empty()) {
      for (const Vertex u : graph_.neighbours[order_[i + 2 * kAhead]].to) {
        if (u != kNoVertex) prefetch(flow_.element, flow_.index[u]);
      }
    }
    for (const Vertex u : graph_.neighbours[order_[i + kAhead]].to) {
      if (u != kNoVertex) prefetch(flow_.nodes, flow_.node_at(flow_.index[u]));
    }
  }

  std::size_t degree_at(std::uint32_t i) const { return graph_.neighbours[order_[i]].degree(); }

  void find_passes() {
    std::array<HalfEdge, 3> steps;
    for (std::uint32_t i = 0; i < order_.size(); ++i) {
      pass_[i] = degree_at(i) == 2 && steps_up(i, steps) == 1;
    }
    for (std::uint32_t i = 0; i < order_.size(); ++i) {
      if (!pass_[i]) make_station(i);
    }
    count_ -= static_cast<NodeId>(std::count(pass_.begin(), pass_.end(), true));
  }

  /// Calls `visit` for every PASS of the chain that begins at i and returns the index of the node
  /// above it.
  template <class Visit>
  std::uint32_t climb(std::uint32_t i, Visit visit) const {
    std::array<HalfEdge, 3> steps;
    while (pass_[i]) {
      visit(i);
      steps_up(i, steps);
      i = steps[0].to;
    }
    return i;
  }

  /// If two chains join a node to the same node, a PASS on one of them becomes a STATION
  /// (Step 2.6).
  void make_station(std::uint32_t i) {
    std::array<HalfEdge, 3> steps;
    if (steps_up(i, steps) != 2) return;
    const auto ignore = [](std::uint32_t) {};
    if (climb(steps[0].to, ignore) != climb(steps[1].to, ignore)) return;
    const std::uint32_t station = pass_[steps[0].to] ? steps[0].to : steps[1].to;
    expect(pass_[station], "a simple graph has a PASS on one of two parallel chains");
    pass_[station] = false;
  }

  void number_nodes() {
    flow_.nodes.resize(count_);
    if (count_ == order_.size()) return;  // every index has the number of its node
    flow_.element.assign(order_.size(), kNone);
    flow_.node_index.reserve(count_);
    for (std::uint32_t i = 0; i < order_.size(); ++i) {
      if (pass_[i]) continue;
      flow_.element[i] = static_cast<NodeId>(flow_.node_index.size());
      flow_.node_index.push_back(i);
    }
  }

  /// The outs of the node at index i; its ins are complete, because all earlier nodes are.
  void finish_node(std::uint32_t i) {
    std::array<HalfEdge, 3> steps;
    const unsigned outs = steps_up(i, steps);
    const NodeId u = flow_.node_at(i);
    Node& node = flow_.nodes[u];
    const bool is_station = node.ins == 1 && outs == 1;
    node.type = is_station ? NodeType::station : type_of(node.ins, outs);
    node.outs = static_cast<std::uint8_t>(outs);
    flow_.types[0].push_back(node.type);
    flow_.types[1].push_back(dual(node.type));
    for (unsigned k = 0; k < outs; ++k) {
      const auto id = static_cast<LongId>(flow_.edges.size());
      const std::uint32_t top =
          climb(steps[k].to, [&](std::uint32_t pass) { flow_.element[pass] = id; });
      const NodeId w = flow_.node_at(top);
      flow_.edges.push_back({u, w, steps[k].edge});
      node.neighbour[node.ins + k] = w;
      Node& upper = flow_.nodes[w];
      upper.neighbour[upper.ins++] = u;
    }
  }

  void find_poles(const BlockTree& blocks) {
    for (NodeId v = 0; v < flow_.nodes.size(); ++v) {
      const NodeType type = flow_.types[0][v];
      if (type != NodeType::source && type != NodeType::sink) continue;
      Pole pole{v, false, kNone};
      // Two neighbours lie opposite (MERGE below a SINK, SPLIT above a SOURCE); the third decides.
      const NodeType usual = type == NodeType::sink ? NodeType::merge : NodeType::split;
      unsigned usual_count = 0;
      for (const NodeId u : flow_.nodes[v].neighbour) {
        if (flow_.types[0][u] == usual) {
          ++usual_count;
        } else {
          pole.special = u;
        }
      }
      expect(usual_count >= 2, "a SINK has two MERGEs below it, a SOURCE two SPLITs above it");
      pole.a_type = usual_count == 2;
      flow_.poles.push_back(pole);
    }
    if (flow_.joint) return;
    flow_.block_entry.assign(blocks.blocks.size(), kNone);
    for (const Pole& pole : flow_.poles) {
      const Block& block = blocks.blocks[flow_.block[pole.node]];
      if (block.bridges > 0) {  // it has degree 3: no PASS
        flow_.block_entry[flow_.block[pole.node]] = flow_.node_at(flow_.index[block.bridge_vertex]);
      }
    }
  }

  const LocalGraph& graph_;
  const LongVector<Vertex>& order_;
  std::vector<bool> pass_;  // per index
  NodeId count_;            // of nodes
  Flow flow_;
};

bool owns_row(const View& view, NodeId v) {
  switch (view.type(v)) {
    case NodeType::split:
    case NodeType::station:
      return true;
    case NodeType::start:
      return view.type(view.outs(v)[0]) != NodeType::split;
    case NodeType::source:
      return view.pole(v).a_type;
    case NodeType::sink:
      return !view.pole(v).a_type;
    case NodeType::merge:
    case NodeType::end:
      break;
  }
  return false;
}

/// Free: nothing refers to its row. Listed: something does, or its room must be reserved.
std::uint8_t role_of_merge(const View& view, NodeId m) {
  const auto above = view.outs(m);
  const bool is_referred_to = std::any_of(above.begin(), above.end(), [&](NodeId w) {
    return view.type(w) == NodeType::merge || view.type(w) == NodeType::sink;
  });
  if (is_referred_to) return kListedMerge;
  const auto below = view.ins(m);
  const bool needs_room = std::any_of(below.begin(), below.end(), [&](NodeId u) {
    return view.type(u) == NodeType::merge || view.type(u) == NodeType::station;
  });
  return kFreeMerge | (needs_room ? kListedMerge : 0);
}

void find_roles(const View& view, NodeId v, LongVector<std::uint8_t>& roles) {
  if (view.type(v) == NodeType::merge) roles[v] |= role_of_merge(view, v);
  if (owns_row(view, v)) roles[v] |= kOwner;
  if (view.type(v) != NodeType::sink) return;
  for (const NodeId u : view.ins(v)) {
    if (view.type(u) == NodeType::split) roles[u] |= kSpecialSplit;
  }
}

}  // namespace

Flow build_flow(const LocalGraph& graph, const BlockTree& blocks, const TimeOrder& order) {
  Flow flow = FlowBuilder(graph, order).build(blocks);
  for (LongVector<std::uint8_t>& roles : flow.roles) roles.resize(flow.nodes.size());
  for (NodeId v = 0; v < flow.nodes.size(); ++v) {
    find_roles(View(flow, false), v, flow.roles[0]);
    find_roles(View(flow, true), v, flow.roles[1]);
  }
  for (LongVector<NodeId>& owner : flow.row_owner) {
    owner.resize(flow.nodes.size());
    std::iota(owner.begin(), owner.end(), 0u);
  }
  for (LongId e = 0; e < flow.edges.size(); ++e) {
    if (flow.is_vv_edge(e)) flow.vv_edges.push_back(e);
  }
  return flow;
}

std::size_t Flow::pole_of(NodeId v) const {
  const auto is_before = [](const Pole& pole, NodeId node) { return pole.node < node; };
  const auto at = std::lower_bound(poles.begin(), poles.end(), v, is_before);
  return static_cast<std::size_t>(at - poles.begin());
}

void Flow::forget_lists() {
  for (LongVector<std::uint8_t>& all : roles) release(all);
  for (LongVector<NodeId>& all : row_owner) release(all);
  release(block);
}

std::array<NodeId, 2> View::ordinary_of(const Pole& pole) const {
  std::array<NodeId, 2> result{};
  std::size_t count = 0;
  for (const NodeId u : flow_->nodes[pole.node].neighbour) {
    if (u != pole.special) result[count++ % 2] = u;
  }
  expect(count == 2, "a pole has two ordinary neighbours");
  return result;
}

}  // namespace ar3d::two_bend
