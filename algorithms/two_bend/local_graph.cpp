#include "ar3d/algorithms/two_bend/local_graph.h"

#include <limits>

namespace ar3d::two_bend {
namespace {

constexpr Vertex kUnread = std::numeric_limits<Vertex>::max();

}  // namespace

bool LocalGraph::adjacent(Vertex u, Vertex v) const {
  const Row& row = rows[u];
  for (std::size_t k = 0; k < row.degree; ++k) {
    if (row.to[k] == v) return true;
  }
  return false;
}

ComponentReader::ComponentReader(const Graph& graph)
    : graph_(graph), local_(graph.num_vertices(), kUnread) {}

bool ComponentReader::next(LocalGraph& out) {
  while (first_ < graph_.num_vertices() && local_[first_] != kUnread) ++first_;
  if (first_ == graph_.num_vertices()) return false;
  search_from(first_, out);
  for (Row& row : out.rows) {
    for (std::size_t k = 0; k < row.degree; ++k) row.to[k] = local_[row.to[k]];
  }
  return true;
}

/// Every vertex's half-edges are read once from the input; rows hold input names until the search
/// has ended.
void ComponentReader::search_from(Vertex root, LocalGraph& out) {
  out.name.clear();
  out.parent.clear();
  out.rows.clear();
  slots_.clear();
  visit(root, 0, out);
  Vertex at = 0;
  while (true) {  // the tree is its own stack: go down while possible, else up to the parent
    const Row& row = out.rows[at];
    std::uint8_t& slot = slots_[at];
    while (slot < row.degree && local_[row.to[slot]] != kUnread) ++slot;
    if (slot < row.degree) {
      const Vertex down = row.to[slot++];
      visit(down, at, out);
      at = out.size() - 1;
    } else if (at == 0) {
      return;
    } else {
      at = out.parent[at];
    }
  }
}

void ComponentReader::visit(Vertex v, Vertex parent, LocalGraph& out) {
  local_[v] = static_cast<Vertex>(out.name.size());
  out.name.push_back(v);
  out.parent.push_back(parent);
  slots_.push_back(0);
  Row& row = out.rows.emplace_back();
  for (const HalfEdge& half : graph_.incident(v)) {
    row.to[row.degree] = half.to;
    row.edge[row.degree++] = half.edge;
  }
}

}  // namespace ar3d::two_bend
