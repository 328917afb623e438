// Step D.4: owners. A search from any node of a component directs every edge it uses to its parent:
// each node but the root owns the edge to its parent. The root is then moved to a leaf or, if there
// is a cycle, to an end of the edge that the search did not use, which the root owns. Cost: O(n).
// Repairs of an order change few components, so only those with an end of an edge whose ends
// changed sides are searched again, each from its first node, which so ends with the same owners.
#include <algorithm>
#include <utility>

#include "ar3d/algorithms/compact_120/order.h"

namespace ar3d::compact_120 {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;
constexpr std::uint32_t kRoot = kNone - 1;
constexpr std::uint32_t kAgain = kNone - 2;  ///< the node's component is to be searched again

constexpr Vertex kAhead = 16;

Vertex vertex_of(std::uint32_t node) { return node / 2; }

}  // namespace

ChangingOwners::ChangingOwners(const Graph& graph, Order order)
    : graph_(graph),
      order_(std::move(order)),
      parent_(2 * std::size_t{graph.num_vertices()}, kNone) {
  owners_.tail.assign(graph.num_edges(), 0);
  for (Vertex v = 0; v < graph_.num_vertices(); ++v) {
    ask_ahead(v);
    for (const Node node : {2 * v, 2 * v + 1}) {
      if (parent_[node] == kNone) search_component(node);
    }
  }
  list_crowded();
}

/// Calls visit(edge, other node) for the edges at a node; returns their number.
template <class Visit>
int ChangingOwners::for_edges(Node node, Visit visit) const {
  const Vertex v = vertex_of(node);
  const bool right = node % 2 == 0;
  int degree = 0;
  for (const HalfEdge& edge : graph_.incident(v)) {
    if (order_.is_right(v, edge.to) != right) continue;
    visit(edge.edge, 2 * edge.to + (right ? 1u : 0u));
    ++degree;
  }
  return degree;
}

/// Asks the memory for a node, without waiting.
void ChangingOwners::ask_for(Node node) const {
  __builtin_prefetch(&order_.rank[vertex_of(node)]);
  __builtin_prefetch(&parent_[node], 1);
  __builtin_prefetch(graph_.incident(vertex_of(node)).data());
}

/// Asks for what a search from vertices after v comes to first.
void ChangingOwners::ask_ahead(Vertex v) const {
  const Vertex n = graph_.num_vertices();
  if (v + 2 * kAhead < n) {
    for (const HalfEdge& edge : graph_.incident(v + 2 * kAhead)) ask_for(2 * edge.to);
  }
  if (v + kAhead < n) {
    for (const HalfEdge& edge : graph_.incident(v + kAhead)) {
      for (const HalfEdge& next : graph_.incident(edge.to))
        __builtin_prefetch(&order_.rank[next.to]);
    }
  }
}

void ChangingOwners::search_component(Node start) {
  queue_.assign(1, start);
  parent_[start] = kRoot;
  Node leaf = start;
  EdgeId unused = kNone;  // an edge that closes a cycle
  bool crowded = false;
  for (std::size_t i = 0; i < queue_.size(); ++i) {
    const Node node = queue_[i];
    const int degree = for_edges(node, [&](EdgeId edge, Node other) {
      if (edge == parent_[node] || edge == unused) return;
      if (parent_[other] == kNone) {
        parent_[other] = edge;
        owners_.tail[edge] = vertex_of(other);
        queue_.push_back(other);
      } else if (parent_[other] != edge) {
        crowded = crowded || unused != kNone;
        unused = edge;
      }
    });
    if (degree == 1) leaf = node;
  }
  if (crowded) {
    const std::size_t begin = crowded_nodes_.size();
    crowded_nodes_.insert(crowded_nodes_.end(), queue_.begin(), queue_.end());
    crowded_.push_back({start, begin, crowded_nodes_.size()});
  }
  if (unused == kNone) {
    make_root(leaf);
  } else {
    const Vertex u = graph_.edge(unused).u;
    make_root(2 * u + (order_.is_right(u, graph_.edge(unused).v) ? 0u : 1u));
    owners_.tail[unused] = u;
  }
}

/// Every node on the way up from `node` gives its edge to its parent.
void ChangingOwners::make_root(Node node) {
  while (parent_[node] != kRoot) {
    const EdgeId edge = parent_[node];
    const Vertex above = graph_.other_end(edge, vertex_of(node));
    owners_.tail[edge] = above;
    node = 2 * above + (node % 2 == 0 ? 1u : 0u);
  }
}

void ChangingOwners::change(const std::vector<RankChange>& changes) {
  std::vector<Node> touched;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    if (i + kAhead < changes.size()) ask_for(2 * changes[i + kAhead].vertex);
    set_rank(changes[i], touched);
  }
  const std::vector<Component> components = components_of(touched);
  std::erase_if(crowded_,
                [&](const Component& component) { return parent_[component.start] == kAgain; });
  for (const Component& component : components) {
    for (std::size_t i = component.begin; i < component.end; ++i) parent_[nodes_[i]] = kNone;
    search_component(component.start);
  }
  list_crowded();
}

/// Adds the nodes of edges whose ends change sides, or have one rank until the other end changes.
void ChangingOwners::set_rank(RankChange change, std::vector<Node>& touched) {
  const Vertex v = change.vertex;
  if (order_.rank[v] == change.rank) return;
  for (const HalfEdge& edge : graph_.incident(v)) {
    const std::uint32_t other = order_.rank[edge.to];
    const std::uint32_t own = order_.rank[v];
    if ((own < other) == (change.rank < other) && (own > other) == (change.rank > other)) continue;
    for (const Node node : {2 * v, 2 * v + 1, 2 * edge.to, 2 * edge.to + 1})
      touched.push_back(node);
  }
  order_.rank[v] = change.rank;
}

/// The components, as they are now, of these nodes: marked kAgain, their nodes in `nodes_`.
std::vector<ChangingOwners::Component> ChangingOwners::components_of(
    const std::vector<Node>& touched) {
  std::vector<Component> components;
  nodes_.clear();
  const auto add = [&](Node node) {
    if (parent_[node] == kAgain) return;
    parent_[node] = kAgain;
    nodes_.push_back(node);
  };
  for (std::size_t i = 0; i < touched.size(); ++i) {
    if (i + kAhead < touched.size()) ask_for(touched[i + kAhead]);
    const Node first = touched[i];
    const std::size_t begin = nodes_.size();
    add(first);
    for (std::size_t j = begin; j < nodes_.size(); ++j) {
      for_edges(nodes_[j], [&](EdgeId, Node other) { add(other); });
    }
    if (nodes_.size() == begin) continue;
    const auto start =
        std::min_element(nodes_.begin() + static_cast<std::ptrdiff_t>(begin), nodes_.end());
    components.push_back({*start, begin, nodes_.size()});
  }
  return components;
}

/// Lists the crowded components in the order of their first nodes, and forgets all others' nodes.
void ChangingOwners::list_crowded() {
  std::sort(crowded_.begin(), crowded_.end(),
            [](const Component& a, const Component& b) { return a.start < b.start; });
  std::vector<Node> nodes;
  owners_.crowded.clear();
  for (Component& component : crowded_) {
    const std::size_t begin = nodes.size();
    for (std::size_t i = component.begin; i < component.end; ++i) {
      nodes.push_back(crowded_nodes_[i]);
      owners_.crowded.push_back(vertex_of(crowded_nodes_[i]));
    }
    component.begin = begin;
    component.end = nodes.size();
  }
  crowded_nodes_ = std::move(nodes);
}

Owners choose_owners(const Graph& graph, const Order& order) {
  return ChangingOwners(graph, order).owners();
}

}  // namespace ar3d::compact_120
