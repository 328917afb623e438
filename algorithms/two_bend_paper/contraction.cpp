// Step P.1, Lemma P.1: triangles, and what hangs together of them, become single vertices. The
// plain lemma of the paper leaves open what docs/theorem2-paper.md names: two triangles with a
// common outer neighbour, and K4 as one of several components or with contracted vertices in it. A
// queue, since a contraction can make a triangle only at the new vertex and its neighbours. Cost:
// O(n + m).
#include "ar3d/algorithms/two_bend_paper/contraction.h"

#include <algorithm>
#include <deque>
#include <optional>

namespace ar3d::two_bend_paper {
namespace {

bool adjacent(const ContractedGraph& graph, Node a, Node b) {
  const Star& star = graph.stars[a];
  return std::any_of(star.begin(), star.end(), [&](HalfEdge i) { return i.to == b; });
}

class Contractor {
 public:
  explicit Contractor(const Graph& graph) {
    const Vertex n = graph.num_vertices();
    result_.stars.resize(n);
    result_.alive.assign(n, true);
    result_.ends.reserve(graph.num_edges());
    for (const Edge& edge : graph.edges()) result_.ends.push_back({edge.u, edge.v});
    for (Vertex v = 0; v < n; ++v) {
      for (const HalfEdge half : graph.incident(v)) result_.stars[v].push_back(half);
      queue_.push_back(v);
    }
  }

  ContractedGraph run() {
    while (!queue_.empty()) {
      const Node node = queue_.front();
      queue_.pop_front();
      if (result_.alive[node]) look_at(node);
    }
    return std::move(result_);
  }

 private:
  using Triangle = std::array<Node, 3>;

  std::optional<Triangle> triangle_at(Node v) const {
    const Star& star = result_.stars[v];
    for (std::uint32_t i = 0; i < star.size(); ++i) {
      for (std::uint32_t j = 0; j < i; ++j) {
        if (adjacent(result_, star[i].to, star[j].to)) {
          return Triangle{v, star[j].to, star[i].to};
        }
      }
    }
    return std::nullopt;
  }

  void look_at(Node v) {
    const std::optional<Triangle> found = triangle_at(v);
    if (!found) return;
    for (const Node corner : *found) {
      if (is_in_k4(result_, corner)) return;
    }
    for (std::size_t tip = 0; tip < 3; ++tip) {
      const Node mid = (*found)[(tip + 1) % 3], other_mid = (*found)[(tip + 2) % 3];
      if (const auto second = second_tip(mid, other_mid, (*found)[tip])) {
        contract_diamond((*found)[tip], *second, mid, other_mid);
        return;
      }
    }
    Triangle corners = *found;
    std::stable_partition(corners.begin(), corners.end(),
                          [&](Node c) { return result_.stars[c].size() == 3; });
    contract(FigureKind::triangle, {corners.begin(), corners.end()});
  }

  /// The common neighbour of both mids that is not the first tip.
  std::optional<Node> second_tip(Node mid, Node other_mid, Node tip) const {
    for (const HalfEdge i : result_.stars[mid]) {
      if (i.to != tip && i.to != other_mid && adjacent(result_, i.to, other_mid)) return i.to;
    }
    return std::nullopt;
  }

  std::optional<Node> outer_neighbour(Node tip, Node mid, Node other_mid) const {
    for (const HalfEdge i : result_.stars[tip]) {
      if (i.to != mid && i.to != other_mid) return i.to;
    }
    return std::nullopt;
  }

  void contract_diamond(Node tip, Node second, Node mid, Node other_mid) {
    const auto outer = outer_neighbour(tip, mid, other_mid);
    const auto other_outer = outer_neighbour(second, mid, other_mid);
    if (outer && outer == other_outer) {
      contract(FigureKind::fat_leaf, {*outer, tip, second, mid, other_mid});
    } else {
      if (!outer) std::swap(tip, second);
      contract(FigureKind::diamond, {tip, second, mid, other_mid});
    }
  }

  void contract(FigureKind figure, const std::vector<Node>& members) {
    Contraction step;
    step.figure = figure;
    step.result = result_.num_nodes();
    step.members.assign(members.begin(), members.end());
    Star star;
    const auto found = [&](Node node) { return std::find(members.begin(), members.end(), node); };
    for (std::size_t m = 0; m < members.size(); ++m) {
      for (const HalfEdge i : result_.stars[members[m]]) {
        const auto other = found(i.to);
        const std::uint8_t slot = result_.ends[i.edge][0] == members[m] ? 0 : 1;
        if (other == members.end()) {
          step.outer.push_back({i.edge, slot});
          star.push_back(i);
        } else if (slot == 0) {
          step.inner.push_back({i.edge, m, static_cast<std::size_t>(other - members.begin())});
        }
      }
      result_.alive[members[m]] = false;
    }
    attach(step, star);
    result_.contractions.push_back(std::move(step));
  }

  /// Makes the outer edges end at the new node; what a new triangle can contain is queued.
  void attach(const Contraction& step, const Star& star) {
    result_.stars.push_back(star);
    result_.alive.push_back(true);
    queue_.push_back(step.result);
    for (const auto& [edge, slot] : step.outer) result_.ends[edge][slot] = step.result;
    for (const HalfEdge i : star) {
      for (HalfEdge& back : result_.stars[i.to]) {
        if (back.edge == i.edge) back.to = step.result;
      }
      queue_.push_back(i.to);
    }
  }

  ContractedGraph result_;
  std::deque<Node> queue_;
};

}  // namespace

bool is_in_k4(const ContractedGraph& graph, Node node) {
  const Star& star = graph.stars[node];
  return star.size() == 3 && adjacent(graph, star[0].to, star[1].to) &&
         adjacent(graph, star[1].to, star[2].to) && adjacent(graph, star[2].to, star[0].to);
}

ContractedGraph contract(const Graph& graph) { return Contractor(graph).run(); }

}  // namespace ar3d::two_bend_paper
