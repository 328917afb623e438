// Step F.3: Tarjan's st-numbering (1986) of the graph in which T with its neighbours, and S with
// its, is one vertex: depth-first search from T, lowpoints, and a list in which each vertex is
// inserted beside its parent. It fails iff one of these two cuts the others, and says which one
// does. Cost: O(n) per trial.
#include "ar3d/algorithms/two_bend_120/numbering.h"

#include <algorithm>

namespace ar3d::two_bend_120 {
namespace {

class StNumbering {
 public:
  explicit StNumbering(const CubicGraph& graph)
      : graph_(graph), number_(graph.size()), previous_(graph.size()), next_(graph.size()) {}

  /// @return the end that cuts others off, kNoVertex if neither does.
  Vertex number(Vertex bottom, Vertex top) {
    number_.assign(graph_.size(), kNoVertex);
    found_.assign(2, {});
    found_[kBottom].vertex = bottom;
    found_[kTop].vertex = top;
    mark(bottom, kBottom);
    mark(top, kTop);
    search(top);
    if (found_.size() + 6 < graph_.size()) return bottom;
    return insert() ? kNoVertex : top;
  }

  /// If neither does.
  ForkOrder result() const {
    ForkOrder result;
    result.order.reserve(graph_.size());
    const Vertex bottom = found_[kBottom].vertex, top = found_[kTop].vertex;
    result.order.push_back(bottom);
    for (const HalfEdge& half : graph_[bottom]) result.order.push_back(half.to);
    for (Vertex i = next_[kBottom]; i != kTop; i = next_[i]) {
      result.order.push_back(found_[i].vertex);
    }
    for (const HalfEdge& half : graph_[top]) result.order.push_back(half.to);
    result.order.push_back(top);
    name_by_order(result);
    return result;
  }

 private:
  static constexpr Vertex kBottom = 0, kTop = 1;  // numbers of the two joined vertices
  struct Visited {
    Vertex vertex = 0;
    Vertex parent = 0;  // a number, as low is
    Vertex low = 0;
  };

  void mark(Vertex v, Vertex number) {
    number_[v] = number;
    for (const HalfEdge& half : graph_[v]) number_[half.to] = number;
  }

  /// Numbers in preorder what is connected to T without S.
  void search(Vertex top) {
    std::vector<std::pair<Vertex, Vertex>> turns;  // a vertex, and the number it was seen from
    for (const HalfEdge& half : graph_[top]) {
      for (const HalfEdge& next : graph_[half.to]) {
        if (number_[next.to] == kNoVertex) turns.emplace_back(next.to, kTop);
      }
    }
    while (!turns.empty()) {
      const auto [v, parent] = turns.back();
      turns.pop_back();
      if (number_[v] != kNoVertex) continue;
      const auto number = static_cast<Vertex>(found_.size());
      number_[v] = number;
      Vertex low = number;
      for (const HalfEdge& half : graph_[v]) {
        const Vertex other = number_[half.to];
        if (other == kNoVertex) {
          turns.emplace_back(half.to, number);
        } else if (other != parent) {
          low = std::min(low, other);
        }
      }
      found_.push_back({v, parent, low});
    }
    for (std::size_t i = found_.size(); i-- > 2;) {
      Visited& parent = found_[found_[i].parent];
      parent.low = std::min(parent.low, found_[i].low);
    }
  }

  /// @return false if T cuts a part off.
  bool insert() {
    next_[kBottom] = kTop;
    previous_[kTop] = kBottom;
    std::vector<bool> after(found_.size());  // the side of it that the next one takes
    for (Vertex i = 2; i < found_.size(); ++i) {
      const auto [vertex, parent, low] = found_[i];
      if (parent == kTop && low != kBottom) return false;
      const bool before = !after[low];
      after[parent] = before;
      const Vertex left = before ? previous_[parent] : parent;
      const Vertex right = before ? parent : next_[parent];
      next_[left] = previous_[right] = i;
      previous_[i] = left;
      next_[i] = right;
    }
    return true;
  }

  void name_by_order(ForkOrder& result) const {
    std::vector<Vertex> index(graph_.size());
    for (Vertex i = 0; i < index.size(); ++i) index[result.order[i]] = i;
    for (Vertex i = 0; i < index.size(); ++i) {
      auto near = graph_[result.order[i]];
      for (HalfEdge& half : near) half.to = index[half.to];
      result.graph.push_back(near);
      std::ranges::sort(near, {}, &HalfEdge::to);
      const auto [low, middle, high] = std::array{near[0].to, near[1].to, near[2].to};
      result.forks.push_back(middle > i ? Fork{true, low, {middle, high}}
                                        : Fork{false, high, {low, middle}});
    }
    result.forks.front() = {true, kNoVertex, {}};
    result.forks.back() = {false, kNoVertex, {}};
  }

  const CubicGraph& graph_;
  std::vector<Vertex> number_;           // per vertex
  std::vector<Visited> found_;           // per number
  std::vector<Vertex> previous_, next_;  // per number: the list
};

/// The vertices at distance at most 2 of v.
std::vector<Vertex> around(const CubicGraph& graph, Vertex v) {
  std::vector<Vertex> near{v};
  for (const HalfEdge& half : graph[v]) {
    near.push_back(half.to);
    for (const HalfEdge& next : graph[half.to]) near.push_back(next.to);
  }
  return near;
}

bool is_in_triangle(const CubicGraph& graph, Vertex v) {
  const auto& [x, y, z] = graph[v];
  const auto are_joined = [&](Vertex u, Vertex w) {
    return graph[u][0].to == w || graph[u][1].to == w || graph[u][2].to == w;
  };
  return are_joined(x.to, y.to) || are_joined(y.to, z.to) || are_joined(z.to, x.to);
}

}  // namespace

std::optional<ForkOrder> find_numbering(const CubicGraph& graph,
                                        const std::function<bool(const ForkOrder&)>& accepts) {
  constexpr int kMostRefused = 100;
  const auto n = static_cast<Vertex>(graph.size());
  StNumbering numbering(graph);
  std::vector<bool> bad(n);
  for (Vertex v = 0; v < n; ++v) bad[v] = is_in_triangle(graph, v);
  int refused = 0;
  for (Vertex bottom = 0; bottom < n; ++bottom) {
    const std::vector<Vertex> near = around(graph, bottom);
    for (Vertex top = n; top-- > 0 && !bad[bottom];) {
      if (bad[top] || std::find(near.begin(), near.end(), top) != near.end()) continue;
      const Vertex cutting = numbering.number(bottom, top);
      if (cutting != kNoVertex) {
        bad[cutting] = true;
        continue;
      }
      ForkOrder result = numbering.result();
      if (accepts(result)) return result;
      if (++refused == kMostRefused) return std::nullopt;
    }
  }
  return std::nullopt;
}

}  // namespace ar3d::two_bend_120
