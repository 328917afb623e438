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
  out.rows.resize(out.name.size());
  for (Vertex v = 0; v < out.size(); ++v) {
    Row& row = out.rows[v];
    row.degree = 0;
    for (const HalfEdge& half : graph_.incident(out.name[v])) {
      row.to[row.degree] = local_[half.to];
      row.edge[row.degree++] = half.edge;
    }
  }
  return true;
}

void ComponentReader::search_from(Vertex root, LocalGraph& out) {
  out.name.assign(1, root);
  out.parent.assign(1, 0);
  local_[root] = 0;
  Vertex at = root;
  while (true) {  // the tree is its own stack: go down while possible, else up to the parent
    Vertex down = kUnread;
    for (const HalfEdge& half : graph_.incident(at)) {
      if (local_[half.to] == kUnread) {
        down = half.to;
        break;
      }
    }
    if (down != kUnread) {
      local_[down] = static_cast<Vertex>(out.name.size());
      out.parent.push_back(local_[at]);
      out.name.push_back(down);
      at = down;
    } else if (at == root) {
      return;
    } else {
      at = out.name[out.parent[local_[at]]];
    }
  }
}

}  // namespace ar3d::two_bend
