// Step F.2: contraction of triangles, one at a time, from a list of vertices that may be in one: all
// at first, then the contracted ones, since a new triangle has one as a corner. In a 3-connected
// cubic graph other than K4 the three edges of a triangle end in three other vertices, and
// contraction leaves the graph simple, cubic and 3-connected; else K4 - e may stay. Cost: O(n).
#include <algorithm>
#include <utility>

#include "ar3d/algorithms/two_bend_120/cubic.h"

namespace ar3d::two_bend_120 {
namespace {

class TriangleContractor {
 public:
  explicit TriangleContractor(const Graph& graph) {
    const Vertex n = graph.num_vertices();
    result_.nodes.resize(n);
    result_.ends.assign(graph.edges().begin(), graph.edges().end());
    for (Vertex v = 0; v < n; ++v) {
      for (std::size_t i = 0; i < 3; ++i) result_.nodes[v].edges[i] = graph.incident(v)[i].edge;
    }
    held_.resize(n);
  }

  Nests run() {
    for (Vertex v = 0; v < result_.nodes.size(); ++v) {  // the list grows
      if (!held_[v]) contract_at(v);
    }
    for (Vertex v = 0; v < result_.nodes.size(); ++v) {
      if (!held_[v]) result_.left.push_back(v);
    }
    return std::move(result_);
  }

 private:
  Vertex other_end(EdgeId e, Vertex v) const {
    const Edge ends = result_.ends[e];
    return ends.u == v ? ends.v : ends.u;
  }

  /// Contracts the first triangle at v, if there is one that may be contracted.
  void contract_at(Vertex v) {
    const auto edges = result_.nodes[v].edges;
    for (std::size_t skipped = 0; skipped < 3; ++skipped) {
      const Vertex x = other_end(edges[(skipped + 1) % 3], v);
      const Vertex y = other_end(edges[(skipped + 2) % 3], v);
      for (const EdgeId side : result_.nodes[x].edges) {
        if (other_end(side, x) != y) continue;
        if (contract({v, x, y}, {side, edges[(skipped + 2) % 3], edges[(skipped + 1) % 3]})) return;
      }
    }
  }

  /// @param sides  side i is the one between the other two corners.
  /// @return false if two of the outer edges end in one vertex.
  bool contract(std::array<Vertex, 3> corners, std::array<EdgeId, 3> sides) {
    Nests::Nest whole;
    whole.corners = corners;
    whole.sides = sides;
    for (std::size_t i = 0; i < 3; ++i) {
      for (const EdgeId e : result_.nodes[corners[i]].edges) {
        if (e != sides[(i + 1) % 3] && e != sides[(i + 2) % 3]) whole.edges[i] = e;
      }
    }
    const auto outer = [&](std::size_t i) { return other_end(whole.edges[i], corners[i]); };
    if (outer(0) == outer(1) || outer(1) == outer(2) || outer(2) == outer(0)) return false;
    // Lemma F.8: edge i leaves along direction i, which side k, of corners i and j, has at corner j.
    const auto reach_of = [&](std::size_t corner, EdgeId e) {
      const Nests::Nest& nest = result_.nodes[corners[corner]];
      return nest.reach[slot_of(nest.edges, e)];
    };
    const auto name = static_cast<Vertex>(result_.nodes.size());
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      whole.steps[i] = std::max(reach_of(j, sides[k]), reach_of(k, sides[j]));
      whole.reach[i] = reach_of(i, whole.edges[i]) + whole.steps[i];
      held_[corners[i]] = true;
      Edge& ends = result_.ends[whole.edges[i]];
      (ends.u == corners[i] ? ends.u : ends.v) = name;
    }
    result_.nodes.push_back(whole);
    held_.push_back(false);
    return true;
  }

  Nests result_;
  std::vector<bool> held_;
};

}  // namespace

Nests contract_triangles(const Graph& graph) { return TriangleContractor(graph).run(); }

}  // namespace ar3d::two_bend_120
