// Step L.3: where a connected graph lies in a net. Each vertex goes to a free point beside its
// predecessor, near enough to the end of its ear. Where none is left, the search jumps back to the
// latest vertex that forbade one (conflict-directed backjumping, Prosser 1993). It skips no
// solution: if it ends at the root, there is none. By the net's symmetry the first edge has one
// place. Cost: see embed().
#include "ar3d/algorithms/lattice/embedding.h"

#include <algorithm>
#include <unordered_map>

namespace ar3d::lattice {
namespace {

class Search {
 public:
  Search(const Graph& graph, const SpaceNet& net, std::uint64_t most_tries)
      : graph_(graph),
        net_(net),
        most_tries_(most_tries),
        steps_(ear_order(graph)),
        step_of_(graph.num_vertices()),
        points_(steps_.size()),
        next_(steps_.size()),
        conflicts_(steps_.size()) {
    for (std::uint32_t i = 0; i < steps_.size(); ++i) step_of_[steps_[i].vertex] = i;
    taken_.reserve(steps_.size());
  }

  Embedding run() {
    std::uint32_t at = 0;
    while (at < steps_.size()) {
      if (tries_ > most_tries_) return {true, {}, tries_};
      if (place(at)) {
        if (++at < steps_.size()) begin(at);
        continue;
      }
      const std::uint32_t back = culprit(at);
      if (back == kNoStep) return {false, {}, tries_};
      while (at > back) taken_.erase(points_[--at]);
    }
    Embedding result{false, std::vector<Point>(steps_.size()), tries_};
    for (std::size_t i = 0; i < steps_.size(); ++i) result.points[steps_[i].vertex] = points_[i];
    return result;
  }

 private:
  void begin(std::uint32_t at) {
    next_[at] = 0;
    conflicts_[at].clear();
  }

  /// Puts the step's vertex at the next point that nothing forbids.
  bool place(std::uint32_t at) {
    const EarStep& step = steps_[at];
    if (step.from == kNoStep) return next_[at]++ == 0 && put(at, Point{});
    const Point before = points_[step.from];
    const std::span<const Vector> ways = net_.steps(before);
    const std::size_t most = at == 1 ? 1 : ways.size();
    conflicts_[at].push_back(step.from);
    while (next_[at] < most) {
      ++tries_;
      const Point point = before + ways[next_[at]++];
      const std::uint32_t forbidding = who_forbids(at, point);
      if (forbidding == kNoStep) return put(at, point);
      conflicts_[at].push_back(forbidding);
    }
    return false;
  }

  bool put(std::uint32_t at, Point point) {
    points_[at] = point;
    taken_.emplace(point, at);
    return true;
  }

  /// An earlier step because of which the vertex cannot be there; kNoStep if there is none.
  std::uint32_t who_forbids(std::uint32_t at, Point point) const {
    const EarStep& step = steps_[at];
    if (const auto there = taken_.find(point); there != taken_.end()) return there->second;
    for (const HalfEdge& half : graph_.incident(step.vertex)) {
      const std::uint32_t other = step_of_[half.to];
      if (other < at && !net_.are_adjacent(point, points_[other])) return other;
    }
    const bool is_far =
        step.target != kNoStep && !net_.may_reach(point, points_[step.target], step.left);
    return is_far ? step.target : kNoStep;
  }

  /// The latest step that has a part in the dead end here; it takes over the others.
  std::uint32_t culprit(std::uint32_t at) {
    std::vector<std::uint32_t>& steps = conflicts_[at];
    std::sort(steps.begin(), steps.end());
    steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
    if (steps.empty()) return kNoStep;
    const std::uint32_t back = steps.back();
    steps.pop_back();
    conflicts_[back].insert(conflicts_[back].end(), steps.begin(), steps.end());
    return back;
  }

  const Graph& graph_;
  const SpaceNet& net_;
  std::uint64_t most_tries_;
  std::vector<EarStep> steps_;
  std::vector<std::uint32_t> step_of_;
  std::vector<Point> points_;      // of the steps
  std::vector<std::size_t> next_;  // which way from the predecessor a step tries next
  std::vector<std::vector<std::uint32_t>> conflicts_;
  std::unordered_map<Point, std::uint32_t, PointHash> taken_;
  std::uint64_t tries_ = 0;
};

}  // namespace

Embedding embed(const Graph& graph, const SpaceNet& net, std::uint64_t most_tries) {
  return Search(graph, net, most_tries).run();
}

}  // namespace ar3d::lattice
