// The input read component by component, renamed in preorder of a depth-first search: the tree that
// Step 2.1 needs for its lowpoints is then known to all later stages, and neighbours lie close
// together. Cost: O(n + m), the largest single part of the drawing time, since every step waits for
// memory.
#include "ar3d/algorithms/two_bend/local_graph.h"

#include <algorithm>

namespace ar3d::two_bend {

bool LocalGraph::adjacent(Vertex u, Vertex v) const {
  const NeighbourList& near = neighbours[u];
  return std::find(near.to.begin(), near.to.end(), v) != near.to.end();
}

ComponentReader::ComponentReader(const Graph& graph)
    : graph_(graph),
      near_(graph.num_vertices()),
      local_(graph.num_vertices()),
      is_read_(graph.num_vertices(), false) {
  const bool is_cubic = std::uint64_t{2} * graph.num_edges() == std::uint64_t{3} * local_.size();
  if (is_cubic && !local_.empty()) cubic_half_edges_ = graph.incident(0).data();
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    std::size_t k = 0;
    for (const HalfEdge& half : graph.incident(v)) near_[v].to[k++] = half.to;
  }
}

bool ComponentReader::next(LocalGraph& out) {
  while (first_ < graph_.num_vertices() && is_read_[first_]) ++first_;
  if (first_ == graph_.num_vertices()) return false;
  search_from(first_, out);
  if (count_ == graph_.num_vertices()) {
    release(near_);
    turns_.shrink_to_fit();  // it is empty
  }
  copy_rows(out);
  if (count_ == graph_.num_vertices()) release(local_);
  return true;
}

/// Room is reserved for all vertices at once: memory that is not written costs nothing, growing
/// arrays are copied.
void ComponentReader::search_from(Vertex root, LocalGraph& out) {
  out.name.clear();
  out.parent.clear();
  out.name.reserve(local_.size());
  out.parent.reserve(local_.size());
  turns_.reserve(local_.size());
  turns_.assign(1, {root, Vertex{0}});
  while (!turns_.empty()) {
    const auto [v, parent] = turns_.back();
    turns_.pop_back();
    if (!is_read_[v]) read(v, parent, out);
  }
  count_ += static_cast<Vertex>(out.name.size());
}

/// Unread neighbours are asked for at once: the search comes to one of them in the next turn.
void ComponentReader::read(Vertex v, Vertex parent, LocalGraph& out) {
  const auto name = static_cast<Vertex>(out.name.size());
  local_[v] = name;
  is_read_[v] = true;
  out.name.push_back(v);
  out.parent.push_back(parent);
  const NeighbourList& near = near_[v];
  for (std::size_t k = near.to.size(); k-- > 0;) {
    const Vertex u = near.to[k];
    if (u == kNoVertex || is_read_[u]) continue;
    prefetch(near_, u);
    turns_.push_back({u, name});
  }
}

/// Prefetches, in two steps, what the i-th vertex's row needs.
[[gnu::always_inline]] inline void ComponentReader::prefetch_row(const LongVector<Vertex>& name,
                                                                 std::size_t i) const {
  constexpr std::size_t kFar = std::size_t{2} * kAhead;
  if (i + kFar >= name.size()) return;
  __builtin_prefetch(incident(name[i + kFar]).data());
  for (const HalfEdge& half : incident(name[i + kAhead])) prefetch(local_, half.to);
}

/// Without a look at where lists begin if all are equally long: one wait for memory less.
std::span<const HalfEdge> ComponentReader::incident(Vertex v) const {
  if (cubic_half_edges_ == nullptr) return graph_.incident(v);
  return {cubic_half_edges_ + std::size_t{3} * v, 3};
}

void ComponentReader::copy_rows(LocalGraph& out) const {
  out.neighbours.clear();
  out.edges.clear();
  out.neighbours.reserve(out.name.size());
  out.edges.reserve(out.name.size());
  for (std::size_t i = 0; i < out.name.size(); ++i) {
    prefetch_row(out.name, i);
    NeighbourList& near = out.neighbours.emplace_back();
    std::array<EdgeId, 3>& edges = out.edges.emplace_back();
    std::size_t k = 0;
    for (const HalfEdge& half : incident(out.name[i])) {
      near.to[k] = local_[half.to];
      edges[k++] = half.edge;
    }
  }
}

}  // namespace ar3d::two_bend
