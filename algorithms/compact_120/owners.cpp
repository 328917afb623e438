// Step D.4: owners. A search from any node of a component directs every edge it uses to its parent:
// each node but the root owns the edge to its parent. The root is then moved to a leaf or, if there
// is a cycle, to an end of the edge that the search did not use, which the root owns. Cost: O(n).
// What the searches read at random is a byte per node and the graph's rows, which are prefetched
// when a node is found. Late repairs of an order change few components, so only those with an end
// of an edge whose ends changed sides are searched again, each from its first node, as at first.
#include <algorithm>

#include "ar3d/algorithms/compact_120/order.h"

namespace ar3d::compact_120 {
namespace {

constexpr Vertex kAhead = 16;
constexpr EdgeId kNoEdge = 0xffffffffu;
constexpr unsigned kUnseen = 4;  ///< beside what a node owns: no search has come to it
constexpr unsigned kAgain = 5;   ///< its component is to be searched again

/// The index of an edge in a row that has it.
unsigned index_of(EdgeId edge, const PaddedRow& row) {
  unsigned k = 0;
  while (row.half[k].edge != edge) ++k;
  return k;
}

}  // namespace

UnwrittenVector<PaddedRow> rows_of(const Graph& graph) {
  UnwrittenVector<PaddedRow> rows(graph.num_vertices());
  for (Vertex v = 0; v < rows.size(); ++v) {
    const std::span<const HalfEdge> edges = graph.incident(v);
    rows[v].v = v;
    rows[v].degree = static_cast<std::uint32_t>(edges.size());
    for (unsigned k = 0; k < 3; ++k) rows[v].half[k] = k < edges.size() ? edges[k] : HalfEdge{v, 0};
  }
  return rows;
}

ChangingOwners::ChangingOwners(const UnwrittenVector<PaddedRow>& rows, const Order& order)
    : rows_(rows) {
  owners_.sides.resize(2 * rows.size());
  for (Vertex v = 0; v < rows.size(); ++v) {
    if (v + kAhead < rows.size()) {
      for (const HalfEdge& edge : rows[v + kAhead].half) __builtin_prefetch(&order.rank[edge.to]);
    }
    set_sides(order, v);
  }
  search_all();
}

/// @return whether a side has other edges than before.
bool ChangingOwners::set_sides(const Order& order, Vertex v) {
  const std::span<const HalfEdge> edges = rows_[v].edges();
  unsigned right = 0;
  for (unsigned k = 0; k < edges.size(); ++k) {
    right |= (order.is_right(v, edges[k].to) ? 1u : 0u) << k;
  }
  std::uint8_t* const sides = &owners_.sides[2 * std::size_t{v}];
  const unsigned left = right ^ ((1u << edges.size()) - 1);
  const bool changes = (sides[0] & 7u) != right || (sides[1] & 7u) != left;
  sides[0] = static_cast<std::uint8_t>((sides[0] & ~7u) | right);
  sides[1] = static_cast<std::uint8_t>((sides[1] & ~7u) | left);
  return changes;
}

void ChangingOwners::set_owned(Node node, unsigned k) {
  owners_.sides[node] = static_cast<std::uint8_t>((owners_.sides[node] & 7u) | k << 3);
}

/// Prefetches what a search that comes to a vertex reads.
void ChangingOwners::prefetch(Vertex v) const {
  __builtin_prefetch(&rows_[v]);
  __builtin_prefetch(&owners_.sides[2 * std::size_t{v}], 1);
}

void ChangingOwners::search_all() {
  for (std::uint8_t& side : owners_.sides) {  // a node without edges is a component of its own
    const unsigned edges = side & 7u;
    side = static_cast<std::uint8_t>(edges | (edges == 0 ? Owners::kNothing : kUnseen) << 3);
  }
  for (Vertex v = 0; v < rows_.size(); ++v) {
    if (v + kAhead < rows_.size()) {
      for (const HalfEdge& edge : rows_[v + kAhead].half) prefetch(edge.to);
    }
    for (const Node node : {2 * v, 2 * v + 1}) {
      if (owned(node) == kUnseen) search_component(node);
    }
  }
  list_crowded();
}

void ChangingOwners::search_component(Node start) {
  queue_.assign(1, {start, kNoEdge});
  Node leaf = start;
  Found unused{0, kNoEdge};  // an edge that closes a cycle
  bool crowded = false;
  for (std::size_t i = 0; i < queue_.size(); ++i) {
    const auto [node, from, unset] = queue_[i];
    queue_[i].again = owned(node) != kUnseen;
    if (queue_[i].again) {  // found from both ends
      crowded = crowded || (unused.from != kNoEdge && unused.from != from);
      if (unused.from != from || node < unused.node) unused = queue_[i];
      continue;
    }
    const PaddedRow& row = rows_[node / 2];
    const unsigned edges = owners_.sides[node] & 7u;
    unsigned own = Owners::kNothing;
    for (unsigned k = 0; k < row.degree; ++k) {
      if ((edges >> k & 1) == 0) continue;
      if (row.half[k].edge == from) {
        own = k;
      } else {
        prefetch(row.half[k].to);
        queue_.push_back({2 * row.half[k].to + (1 - node % 2), row.half[k].edge});
      }
    }
    set_owned(node, own);
    if (edges != 0 && (edges & (edges - 1)) == 0) leaf = node;
  }
  if (crowded) {
    std::vector<Vertex>& vertices = crowded_[start];
    for (const Found& found : queue_) {
      if (!found.again) vertices.push_back(found.node / 2);
    }
  }
  if (unused.from == kNoEdge) {
    make_root(leaf, Owners::kNothing);
  } else {
    make_root(unused.node, index_of(unused.from, rows_[unused.node / 2]));
  }
}

/// Every node on the way up from `node` gives its edge to its parent.
/// @param given  what `node` owns instead.
void ChangingOwners::make_root(Node node, unsigned given) {
  while (true) {
    const unsigned up = owned(node);
    set_owned(node, given);
    if (up == Owners::kNothing) return;
    const HalfEdge edge = rows_[node / 2].half[up];
    node = 2 * edge.to + (1 - node % 2);
    given = index_of(edge.edge, rows_[edge.to]);
  }
}

void ChangingOwners::change(const Order& order, const std::vector<Vertex>& vertices) {
  std::vector<Vertex> touched;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (i + kAhead < vertices.size()) prefetch(vertices[i + kAhead]);
    if (set_sides(order, vertices[i])) touched.push_back(vertices[i]);
  }
  if (touched.size() > rows_.size() / 8) {
    crowded_.clear();
    return search_all();
  }
  const std::vector<Node> starts = forget_components(touched);
  for (const Node start : starts) search_component(start);
  list_crowded();
}

/// Forgets what is known of the components, as they are now, with these vertices.
/// @return their first nodes.
std::vector<ChangingOwners::Node> ChangingOwners::forget_components(
    const std::vector<Vertex>& touched) {
  std::vector<Node> starts;
  std::vector<Node> nodes;
  const auto add = [&](Node node) {
    if (owned(node) == kAgain) return;
    set_owned(node, kAgain);
    nodes.push_back(node);
  };
  for (std::size_t i = 0; i < 2 * touched.size(); ++i) {
    const std::size_t begin = nodes.size();
    add(2 * touched[i / 2] + static_cast<Node>(i % 2));
    for (std::size_t j = begin; j < nodes.size(); ++j) {
      const PaddedRow& row = rows_[nodes[j] / 2];
      for (unsigned k = 0; k < row.degree; ++k) {
        if ((owners_.sides[nodes[j]] >> k & 1) != 0) add(2 * row.half[k].to + (1 - nodes[j] % 2));
      }
    }
    if (nodes.size() == begin) continue;
    starts.push_back(
        *std::min_element(nodes.begin() + static_cast<std::ptrdiff_t>(begin), nodes.end()));
  }
  std::erase_if(crowded_, [&](const auto& component) { return owned(component.first) == kAgain; });
  for (const Node node : nodes) set_owned(node, kUnseen);
  return starts;
}

void ChangingOwners::list_crowded() {
  owners_.crowded.clear();
  for (const auto& [start, vertices] : crowded_) {
    owners_.crowded.insert(owners_.crowded.end(), vertices.begin(), vertices.end());
  }
}

Owners choose_owners(const Graph& graph, const Order& order) {
  const UnwrittenVector<PaddedRow> rows = rows_of(graph);
  return ChangingOwners(rows, order).owners();
}

}  // namespace ar3d::compact_120
