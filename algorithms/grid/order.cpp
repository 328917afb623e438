// Step 3.1. Reverse breadth-first orders. In a cubic component the vertex f that comes first must
// not be a cut vertex: the neighbour tried first seldom is one, and the last vertex of a search
// never is. At most three searches, O(n + m).
#include "ar3d/algorithms/grid/order.h"

#include <algorithm>

#include "ar3d/base/error.h"

namespace ar3d::grid {

namespace {

class BreadthFirst {
 public:
  explicit BreadthFirst(const Graph& graph) : graph_(graph), seen_(graph.num_vertices(), 0) {
    order_.sequence.reserve(graph.num_vertices());
  }

  ProcessingOrder run() {
    const Vertex n = graph_.num_vertices();
    for (Vertex v = 0; v < n; ++v) {
      if (!seen_[v] && graph_.degree(v) < 3) add_open_component(v);
    }
    for (Vertex v = 0; v < n; ++v) {
      if (!seen_[v]) add_cubic_component(v);
    }
    return std::move(order_);
  }

 private:
  /// Appends what a breadth-first search from `root` finds among the unseen vertices.
  void append_search(Vertex root) {
    std::vector<Vertex>& queue = order_.sequence;
    std::size_t head = queue.size();
    seen_[root] = 1;
    queue.push_back(root);
    while (head < queue.size()) {
      prefetch_ahead(head);
      for (const HalfEdge& half : graph_.incident(queue[head++])) {
        if (seen_[half.to]) continue;
        seen_[half.to] = 1;
        queue.push_back(half.to);
      }
    }
  }

  /// Asks ahead for what the search is going to read, which is known as far as the queue goes.
  void prefetch_ahead(std::size_t head) const {
    constexpr std::size_t kAhead = 16;
    const std::vector<Vertex>& queue = order_.sequence;
    if (head + 2 * kAhead < queue.size()) {
      __builtin_prefetch(graph_.incident(queue[head + 2 * kAhead]).data());
    }
    if (head + kAhead >= queue.size()) return;
    for (const HalfEdge& half : graph_.incident(queue[head + kAhead])) {
      __builtin_prefetch(&seen_[half.to], 1);
    }
  }

  void add_open_component(Vertex root) {
    const std::size_t begin = order_.sequence.size();
    append_search(root);
    finish_part(begin, begin, false);
  }

  /// f is put first and its neighbour r becomes the root of the rest, which must stay connected.
  void add_cubic_component(Vertex start) {
    const std::size_t begin = order_.sequence.size();
    if (!append_without(start, graph_.incident(start)[0].to)) {
      forget(begin);
      append_search(start);
      const Vertex f = order_.sequence.back();  // the last vertex of a search is no cut vertex
      forget(begin);
      expect(append_without(f, graph_.incident(f)[0].to), "a last vertex is no cut vertex");
    }
    finish_part(begin, begin + 1, true);
  }

  /// f, then the search from r in the component without f. False if f is a cut vertex.
  bool append_without(Vertex f, Vertex r) {
    seen_[f] = 1;
    order_.sequence.push_back(f);
    append_search(r);
    return std::ranges::all_of(graph_.incident(f),
                               [&](const HalfEdge& half) { return seen_[half.to] != 0; });
  }

  void forget(std::size_t begin) {
    for (std::size_t i = begin; i < order_.sequence.size(); ++i) seen_[order_.sequence[i]] = 0;
    order_.sequence.resize(begin);
  }

  void finish_part(std::size_t begin, std::size_t reversed_from, bool cubic) {
    std::reverse(order_.sequence.begin() + static_cast<std::ptrdiff_t>(reversed_from),
                 order_.sequence.end());
    order_.parts.push_back(
        {static_cast<Index>(begin), static_cast<Index>(order_.sequence.size()), cubic});
  }

  const Graph& graph_;
  std::vector<std::uint8_t> seen_;
  ProcessingOrder order_;
};

}  // namespace

ProcessingOrder processing_order(const Graph& graph) { return BreadthFirst(graph).run(); }

// The graph renumbered in processing order, before Step 3.9: all later stages read it forwards.
// Entries are prefetched 8 and 16 indices ahead of use, since the far ends of edges are cache
// misses. O(n + m).

UnwrittenVector<PlacedRow> neighbours_in_order(const Graph& graph, const ProcessingOrder& order) {
  UnwrittenVector<Index> index_of(graph.num_vertices());
  for (Index i = 0; i < order.sequence.size(); ++i) index_of[order.sequence[i]] = i;
  UnwrittenVector<PlacedRow> neighbours(order.sequence.size(), PlacedRow{});
  for (Index i = 0; i < neighbours.size(); ++i) {
    if (i + kAhead < neighbours.size()) {
      for (const HalfEdge& half : graph.incident(order.sequence[i + kAhead])) {
        __builtin_prefetch(&index_of[half.to]);
      }
    }
    if (i + 2 * kAhead < neighbours.size()) {
      __builtin_prefetch(graph.incident(order.sequence[i + 2 * kAhead]).data());
    }
    PlacedRow& own = neighbours[i];
    for (const HalfEdge& half : graph.incident(order.sequence[i])) {
      own.half[own.degree++] = {index_of[half.to], half.edge};
    }
  }
  return neighbours;
}

// The graph renamed by indices, before Steps 3.2 to 3.5. In a breadth-first order the two ends of a
// tree edge are read in two streams, so only the edges that close cycles miss the cache. O(n + m).

PlacedGraph::PlacedGraph(UnwrittenVector<PlacedRow> neighbours) : rows_(std::move(neighbours)) {
  edge_of_.reserve(rows_.size() * 3 / 2);
  for (Index v = 0; v < rows_.size(); ++v) {
    if (v + kAhead < rows_.size()) {
      for (const HalfEdge& half : rows_[v + kAhead].halves()) __builtin_prefetch(&rows_[half.to]);
    }
    PlacedRow& row = rows_[v];
    for (unsigned i = 0; i < row.degree; ++i) {
      if (row.half[i].to > v) {
        edge_of_.push_back(std::exchange(row.half[i].edge, num_edges()));
        continue;
      }
      const HalfEdge* back = rows_[row.half[i].to].half.data();
      while (back->to != v) ++back;
      row.half[i].edge = back->edge;
    }
  }
}

}  // namespace ar3d::grid
