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
      local_(graph.num_vertices(), kNoVertex),
      is_read_(graph.num_vertices(), false) {
  const bool is_cubic = std::uint64_t{2} * graph.num_edges() == std::uint64_t{3} * local_.size();
  if (is_cubic && !local_.empty()) cubic_half_edges_ = graph.incident(0).data();
}

bool ComponentReader::next(LocalGraph& out) {
  while (first_ < graph_.num_vertices() && is_read_[first_]) ++first_;
  if (first_ == graph_.num_vertices()) return false;
  search_from(first_, out);
  for (NeighbourList& near : out.neighbours) {
    for (std::size_t k = 0, degree = near.degree(); k < degree; ++k)
      near.to[k] = local_[near.to[k]];
  }
  return true;
}

/// Every vertex's half-edges are read once from the input; lists hold input names until the search
/// has ended.
void ComponentReader::search_from(Vertex root, LocalGraph& out) {
  out.name.clear();
  out.parent.clear();
  out.neighbours.clear();
  out.edges.clear();
  reserve(out);
  turns_.assign(1, {root, 0});
  while (!turns_.empty()) {
    const Turn turn = turns_.back();
    turns_.pop_back();
    if (!is_read_[turn.to]) read(turn, out);
  }
}

/// For all vertices at once: memory that is not written costs nothing, growing arrays are copied.
void ComponentReader::reserve(LocalGraph& out) const {
  out.name.reserve(local_.size());
  out.parent.reserve(local_.size());
  out.neighbours.reserve(local_.size());
  out.edges.reserve(local_.size());
}

/// Without a look at where lists begin if all are equally long: one wait for memory less.
std::span<const HalfEdge> ComponentReader::incident(Vertex v) const {
  if (cubic_half_edges_ == nullptr) return graph_.incident(v);
  return {cubic_half_edges_ + std::size_t{3} * v, 3};
}

/// Unread neighbours are asked for at once: the search comes to one of them in the next turn.
void ComponentReader::read(Turn turn, LocalGraph& out) {
  const auto name = static_cast<Vertex>(out.name.size());
  local_[turn.to] = name;
  is_read_[turn.to] = true;
  out.name.push_back(turn.to);
  out.parent.push_back(turn.parent);
  NeighbourList& near = out.neighbours.emplace_back();
  std::array<EdgeId, 3>& edges = out.edges.emplace_back();
  const std::span<const HalfEdge> halves = incident(turn.to);
  for (std::size_t k = halves.size(); k-- > 0;) {
    near.to[k] = halves[k].to;
    edges[k] = halves[k].edge;
    if (is_read_[near.to[k]]) continue;
    __builtin_prefetch(incident(near.to[k]).data());
    turns_.push_back({near.to[k], name});
  }
}

}  // namespace ar3d::two_bend
