// Step P.4, the induction of the paper's proof of Theorem 2: a vertex with at most one neighbour
// not drawn is added, and a shortest cycle only where there is none. So a drawn vertex has at most
// one neighbour that is not drawn, which is the invariant that all later steps rest on. A shortest
// cycle has no chord, as the proof demands, because a chord would make a shorter one. Cost: O(n log
// n + m) and, for each cycle, breadth-first searches of O(nodes * edges) at worst.
#include "ar3d/algorithms/two_bend_paper/growth.h"

#include <deque>

#include "ar3d/base/error.h"

namespace ar3d::two_bend_paper {
namespace {

constexpr std::size_t kShortest = 4;  // there are no triangles

class Grower {
 public:
  explicit Grower(const ContractedGraph& graph)
      : graph_(graph),
        drawn_(graph.num_nodes()),
        outside_(graph.num_nodes()),
        search_(graph.num_nodes()) {
    for (Node node = 0; node < graph.num_nodes(); ++node) {
      outside_[node] = static_cast<std::uint32_t>(graph.stars[node].size());
    }
  }

  std::vector<Component> run() {
    std::vector<Component> components;
    std::vector<bool> seen(graph_.num_nodes());
    for (Node node = 0; node < graph_.num_nodes(); ++node) {
      if (!graph_.alive[node] || seen[node]) continue;
      nodes_ = component_of(node, seen);
      components.push_back(is_in_k4(graph_, node) ? k4() : grown());
    }
    return components;
  }

 private:
  std::vector<Node> component_of(Node root, std::vector<bool>& seen) const {
    std::vector<Node> nodes{root};
    seen[root] = true;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (const HalfEdge incidence : graph_.stars[nodes[i]]) {
        if (seen[incidence.to]) continue;
        seen[incidence.to] = true;
        nodes.push_back(incidence.to);
      }
    }
    std::sort(nodes.begin(), nodes.end());
    return nodes;
  }

  Component k4() const {
    expect(nodes_.size() == 4, "K4 is a component of its own");
    return {std::array<Node, 4>{nodes_[0], nodes_[1], nodes_[2], nodes_[3]}, 0, {}};
  }

  Component grown() {
    Component component;
    queue_.clear();
    for (const Node node : nodes_) {
      if (outside_[node] <= 1) queue_.push_back(node);
    }
    std::size_t left = nodes_.size();
    while (left > 0) {
      component.steps.push_back(next_step());
      const Step& step = component.steps.back();
      left -= step.kind == StepKind::cycle ? step.cycle.size() : 1;
    }
    return component;
  }

  Step next_step() {
    while (!queue_.empty()) {
      const Node node = queue_.front();
      queue_.pop_front();
      if (!drawn_[node]) return single(node);
    }
    const std::vector<Node> cycle = shortest_cycle(graph_, nodes_, drawn_, search_);
    expect(cycle.size() >= kShortest, "nodes with two neighbours outside have a long cycle");
    return ring(cycle);
  }

  Step single(Node node) {
    Step step;
    step.node = node;
    for (const HalfEdge incidence : graph_.stars[node]) {
      if (drawn_[incidence.to]) step.below.push_back(incidence);
    }
    step.kind = static_cast<StepKind>(step.below.size());
    step.has_ray = step.below.size() < graph_.stars[node].size();
    add(node);
    return step;
  }

  Step ring(const std::vector<Node>& cycle) {
    Step step;
    step.kind = StepKind::cycle;
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      const Node next = cycle[(i + 1) % cycle.size()];
      const Node previous = cycle[(i + cycle.size() - 1) % cycle.size()];
      CycleVertex vertex;
      vertex.node = cycle[i];
      for (const HalfEdge incidence : graph_.stars[cycle[i]]) {
        if (incidence.to == next) {
          vertex.to_next = incidence.edge;
        } else if (incidence.to != previous) {
          vertex.third = incidence;
          vertex.is_below = drawn_[incidence.to];
        }
      }
      step.cycle.push_back(vertex);
    }
    for (const Node node : cycle) add(node);
    return step;
  }

  void add(Node node) {
    drawn_[node] = true;
    for (const HalfEdge incidence : graph_.stars[node]) {
      const std::uint32_t left = --outside_[incidence.to];
      if (left <= 1 && !drawn_[incidence.to]) queue_.push_back(incidence.to);
    }
  }

  const ContractedGraph& graph_;
  std::vector<bool> drawn_;
  std::vector<std::uint32_t> outside_;  // neighbours that are not drawn
  ShortestCycleSearch search_;
  std::vector<Node> nodes_;  // of the component at hand, ascending
  std::deque<Node> queue_;
};

}  // namespace

std::vector<Node> shortest_cycle(const ContractedGraph& graph, const std::vector<Node>& nodes,
                                 const std::vector<bool>& inside, ShortestCycleSearch& search) {
  const auto star = [&graph](Node node) -> const auto& { return graph.stars[node]; };
  std::vector<Node> best;
  for (const Node root : nodes) {
    if (inside[root]) continue;
    const std::size_t longest = best.empty() ? nodes.size() : best.size() - 1;
    std::vector<Node> cycle = search.through(root, longest, star, inside);
    if (!cycle.empty()) best = std::move(cycle);
    if (!best.empty() && best.size() <= kShortest) break;
  }
  return best;
}

std::vector<Component> grow(const ContractedGraph& graph) { return Grower(graph).run(); }

}  // namespace ar3d::two_bend_paper
