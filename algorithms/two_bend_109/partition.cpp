// Step E.1, which is the proof of Lemma E.2 case by case: singles from queues of vertices of low
// degree, else an induced cycle, else a body. A component of what is left is alive if it has a
// cycle or a vertex of degree below 4 in the graph; all stay alive. Cost: O(n) and what the
// searches for cycles go through.
#include "ar3d/algorithms/two_bend_109/partition.h"

#include <algorithm>
#include <array>
#include <deque>
#include <utility>

#include "ar3d/algorithms/two_bend_109/induced_cycles.h"
#include "ar3d/base/error.h"

namespace ar3d::two_bend_109 {
namespace {

class Partitioner {
 public:
  explicit Partitioner(const Graph& graph) : graph_(graph), rest_(graph), search_(graph, rest_) {}

  std::vector<Part> run() {
    for (Vertex v = 0; v < graph_.num_vertices(); ++v) note_degree(v);
    while (take_next()) {
    }
    // Nothing is later than a body anyway.
    std::stable_partition(parts_.begin(), parts_.end(),
                          [](const Part& part) { return part.kind != PartKind::body; });
    return std::move(parts_);
  }

  std::uint64_t looked_at() const { return search_.looked_at(); }

 private:
  bool take_next() {
    if (std::optional<Vertex> v = next_of(full_leaves_, 1)) return take_single(*v);
    if (std::optional<Vertex> v = next_of(leaves_, 1)) return take_single(*v);
    if (std::optional<Vertex> v = next_of(passages_, 2)) {
      const std::vector<Vertex> cycle = search_.cycle_component(*v);
      return cycle.empty() ? take_single(*v) : take({PartKind::cycle, cycle, nullptr});
    }
    while (first_ < graph_.num_vertices() && !rest_.has(first_)) ++first_;
    if (first_ == graph_.num_vertices()) return false;
    return take_from_core(first_);
  }

  /// The first one of the queue that is still there and has at most this degree.
  std::optional<Vertex> next_of(std::deque<Vertex>& queue, std::uint32_t degree) {
    while (!queue.empty()) {
      const Vertex v = queue.front();
      queue.pop_front();
      if (rest_.has(v) && rest_.degree(v) <= degree) return v;
    }
    return std::nullopt;
  }

  void note_degree(Vertex v) {
    const std::uint32_t degree = rest_.degree(v);
    if (degree == 2) passages_.push_back(v);
    if (degree <= 1) (graph_.degree(v) == 4 ? full_leaves_ : leaves_).push_back(v);
  }

  bool take_single(Vertex v) {
    expect(graph_.degree(v) - rest_.degree(v) <= 3, "a single has at most 3 earlier neighbours");
    return take({PartKind::single, {v}, nullptr});
  }

  bool take(Part part) {
    for (const Vertex v : part.vertices) rest_.remove(v);
    for (const Vertex v : part.vertices) {
      for (const HalfEdge& half : graph_.incident(v)) {
        if (rest_.has(half.to)) note_degree(half.to);
      }
    }
    parts_.push_back(std::move(part));
    return true;
  }

  /// From a component in which all degrees are at least 3: an induced cycle that leaves only
  /// components alive, or the component as a body.
  bool take_from_core(Vertex root) {
    std::vector<Vertex> cycle = search_.first_cycle(root);
    if (search_.leaves_all_alive(cycle)) return take({PartKind::cycle, cycle, nullptr});
    const std::vector<Vertex> core = search_.component(root);
    Pieces pieces = search_.pieces(core, cycle);
    if (!pieces.has_alive()) {
      cycle = search_.cycle_beside_cycle(core);
      if (cycle.empty()) return take_body(core);
      pieces = search_.pieces(core, cycle);
    }
    // The largest living piece grows, so this ends (Lemma E.2).
    while (const std::vector<Vertex>* dead = pieces.first_dead()) {
      cycle = search_.cycle_off(cycle, *dead, pieces.largest_alive());
      pieces = search_.pieces(core, cycle);
    }
    return take({PartKind::cycle, cycle, nullptr});
  }

  bool take_body(const std::vector<Vertex>& core) {
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < core.size(); ++i) {
      for (const HalfEdge& half : graph_.incident(core[i])) {
        const auto at = std::find(core.begin(), core.end(), half.to);
        if (at != core.end() && half.to > core[i]) {
          edges.push_back({static_cast<Vertex>(i), static_cast<Vertex>(at - core.begin())});
        }
      }
    }
    const std::optional<FoundBody> found = find_body(Graph(core.size(), std::move(edges)));
    expect(found.has_value(), "a core without two disjoint cycles is one of the small bodies");
    Part part{PartKind::body, {}, found->body};
    for (const Vertex i : found->vertices) part.vertices.push_back(core[i]);
    return take(std::move(part));
  }

  const Graph& graph_;
  Rest rest_;
  CycleSearch search_;
  std::vector<Part> parts_;
  std::deque<Vertex> full_leaves_;  ///< degree at most 1 in the rest, 4 in the graph
  std::deque<Vertex> leaves_;       ///< degree at most 1 in the rest, less than 4 in the graph
  std::deque<Vertex> passages_;     ///< degree 2 in the rest
  Vertex first_ = 0;                ///< all before it are taken
};

}  // namespace

std::vector<Part> find_partition(const Graph& graph, std::uint64_t* looked_at) {
  Partitioner partitioner(graph);
  std::vector<Part> parts = partitioner.run();
  if (looked_at != nullptr) *looked_at = partitioner.looked_at();
  return parts;
}

}  // namespace ar3d::two_bend_109
