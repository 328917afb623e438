// Steps G.1 and G.2: components, stages, closures in the paper's iterative definition (Repair G.4),
// of the empty set, too (Repair G.3). What is outside only shrinks, so shortest cycles through a
// vertex only get longer: lengths found stay lower bounds, and only the vertex with the least one
// is searched from, no further than twice that. Searching from every vertex takes n^2 in all. Cost:
// a search, O(n) at worst, for every change of a bound; else O(n log n).
#include <deque>
#include <queue>

#include "ar3d/algorithms/grid_paper/builder.h"
#include "ar3d/algorithms/shortest_cycle.h"
#include "ar3d/base/error.h"
#include "ar3d/base/random.h"

namespace ar3d::grid_paper {
namespace {

constexpr std::uint32_t kNowhere = std::numeric_limits<std::uint32_t>::max();

class ClosureGrower {
 public:
  ClosureGrower(const Graph& graph, bool any_cycle, const RepairSwitches& repairs)
      : graph_(graph),
        any_cycle_(any_cycle),
        gone_(graph.num_vertices()),
        degree_(graph.num_vertices()),
        index_(graph.num_vertices(), kNowhere),
        search_(graph.num_vertices()) {
    for (Vertex v = 0; v < graph.num_vertices(); ++v) degree_[v] = graph.degree(v);
    if (repairs.random_cycles) random_.emplace(*repairs.random_cycles);
  }

  std::vector<GrowthStage> grow(const std::vector<Vertex>& component) {
    std::vector<GrowthStage> stages;
    std::size_t left = component.size();
    const auto keep = [&](GrowthStage stage) {
      left -= stage.cycle.size() + stage.between.size() + stage.closure.size();
      stages.push_back(std::move(stage));
    };
    for (const Vertex v : component) {
      if (degree_[v] <= 1) queue_.push_back(v);
    }
    GrowthStage trees;
    close(trees);
    keep(std::move(trees));
    first_ = 0;
    candidates_ = {};
    for (const Vertex v : component) {
      if (!gone_[v] && degree_[v] == 3) candidates_.push({3, v});
    }
    while (left > 0) {
      keep(
          next_stage(any_cycle_ || random_ ? cycle_by_walk(component) : shortest_cycle(component)));
    }
    return stages;
  }

 private:
  using Candidate = std::pair<std::uint32_t, Vertex>;  // a lower bound of its shortest cycle

  GrowthStage next_stage(std::vector<Vertex> cycle) {
    GrowthStage stage{std::move(cycle), {}, {}};
    for (const Vertex v : stage.cycle) gone_[v] = true;
    std::vector<Vertex> joined;  // to the cycle and to the old S
    for (const Vertex v : stage.cycle) {
      for (const auto [u, edge] : graph_.incident(v)) {
        if (!gone_[u] && degree_[u] < graph_.degree(u)) joined.push_back(u);
      }
    }
    std::sort(joined.begin(), joined.end());
    joined.erase(std::unique(joined.begin(), joined.end()), joined.end());
    for (const Vertex v : stage.cycle) remove(v);
    for (const Vertex u : joined) {
      const bool waits = std::ranges::any_of(graph_.incident(u), [&](HalfEdge half) {
        return std::ranges::binary_search(stage.between, half.to);
      });
      (waits ? stage.closure : stage.between).push_back(u);
    }
    for (const Vertex u : joined) remove(u);
    close(stage);
    return stage;
  }

  void close(GrowthStage& stage) {
    std::sort(queue_.begin(), queue_.end());
    for (; !queue_.empty(); queue_.pop_front()) {
      const Vertex u = queue_.front();
      if (gone_[u]) continue;
      stage.closure.push_back(u);
      remove(u);
    }
  }

  void remove(Vertex v) {
    gone_[v] = true;
    for (const auto [u, edge] : graph_.incident(v)) {
      if (--degree_[u] <= 1 && !gone_[u]) queue_.push_back(u);
    }
  }

  /// A shortest one with a vertex of three neighbours outside. If there is
  /// none, every component of what is outside is a cycle: a leaf block of
  /// another one would be a cycle with such a vertex.
  std::vector<Vertex> shortest_cycle(const std::vector<Vertex>& component) {
    while (!candidates_.empty()) {
      const auto [bound, root] = candidates_.top();
      candidates_.pop();
      if (gone_[root] || degree_[root] < 3) continue;
      const std::uint32_t longest = 2 * bound;
      std::vector<Vertex> cycle = search_.through(
          root, longest, [this](Vertex v) { return graph_.incident(v); }, gone_);
      const bool is_found = !cycle.empty();
      if (!is_found && search_.is_all_reached()) continue;  // it never will be on a cycle
      const Candidate next{is_found ? static_cast<std::uint32_t>(cycle.size()) : longest + 1, root};
      if (is_found && (candidates_.empty() || next < candidates_.top())) {
        std::rotate(cycle.begin(), cycle.begin() + 1, cycle.end());  // the root last
        return cycle;
      }
      candidates_.push(next);
    }
    return cycle_by_walk(component);
  }

  /// The first that a walk from the least vertex closes, to the first neighbour
  /// each time. Its vertices but the last have no other neighbours on it than
  /// those before and after them, so the cycle that the last one closes with
  /// its latest neighbour has no chord.
  std::vector<Vertex> cycle_by_walk(const std::vector<Vertex>& component) {
    while (gone_[component.at(first_)]) ++first_;
    Vertex v = component[first_];
    while (random_ && gone_[v = component[random_below(component.size())]]) continue;
    std::vector<Vertex> walk, cycle;
    while (cycle.empty()) {
      std::vector<Vertex> ahead;
      std::int64_t latest = -1;
      for (const auto [w, edge] : graph_.incident(v)) {
        if (gone_[w] || (!walk.empty() && w == walk.back())) continue;
        ahead.push_back(w);
        if (index_[w] != kNowhere) latest = std::max<std::int64_t>(latest, index_[w]);
      }
      expect(!ahead.empty(), "every vertex outside has two neighbours there");
      index_[v] = static_cast<std::uint32_t>(walk.size());
      walk.push_back(v);
      if (latest >= 0) cycle.assign(walk.begin() + latest, walk.end());
      v = ahead[random_ ? random_below(ahead.size()) : 0];
    }
    for (const Vertex w : walk) index_[w] = kNowhere;
    return cycle;
  }
  std::size_t random_below(std::size_t count) {
    return random_->below(static_cast<std::uint32_t>(count));
  }

  const Graph& graph_;
  bool any_cycle_;
  std::optional<RandomStream> random_;
  std::vector<bool> gone_;             // not outside any more
  std::vector<std::uint32_t> degree_;  // neighbours outside
  std::deque<Vertex> queue_;           // of the closure
  std::size_t first_ = 0;              // all before it in the component are gone
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> candidates_;
  std::vector<std::uint32_t> index_;  // on a walk; kNowhere between walks
  ShortestCycleSearch search_;
};

}  // namespace

std::vector<std::pair<std::vector<Vertex>, std::vector<GrowthStage>>> grow(
    const Graph& graph, bool any_cycle, const RepairSwitches& repairs) {
  const Components found = connected_components_of(graph);
  std::vector<std::pair<std::vector<Vertex>, std::vector<GrowthStage>>> components(found.count);
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    components[found.of[v]].first.push_back(v);
  }
  ClosureGrower grower(graph, any_cycle, repairs);
  for (auto& [vertices, stages] : components) stages = grower.grow(vertices);
  return components;
}

}  // namespace ar3d::grid_paper
