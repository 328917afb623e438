// Step E.1, which is the proof of Lemma E.2 case by case: singles from queues of vertices of low
// degree, else an induced cycle, else a body. A component of what is left is alive if it has a
// cycle or a vertex of degree below 4 in the graph; all stay alive. A breadth-first search finds an
// induced cycle, which costs what it visits; trying all of them, in case (d), is exponential in the
// size of the component, which Step E.1 shows to be at most 60 there. Cost: O(n) and what the
// searches go through.
#include "ar3d/algorithms/two_bend_109/partition.h"

#include <algorithm>
#include <deque>
#include <iterator>
#include <optional>
#include <tuple>

#include "ar3d/base/error.h"

namespace ar3d::two_bend_109 {
namespace {

/// The vertices that are in no part yet are the rest. "Core" is a component of it in which all
/// degrees are at least 3.
class Partitioner {
 public:
  explicit Partitioner(const Graph& graph) : at_(graph.num_vertices()) {
    for (Vertex v = 0; v < graph.num_vertices(); ++v) {
      for (const HalfEdge& half : graph.incident(v)) at_[v].to[at_[v].degree++] = half.to;
      at_[v].full_degree = at_[v].degree;
    }
  }

  std::vector<VertexPart> run() {
    parts_.reserve(at_.size());
    for (Vertex v = 0; v < at_.size(); ++v) note_degree(v);
    while (take_next()) {
    }
    // Nothing is later than a body anyway.
    std::stable_partition(parts_.begin(), parts_.end(),
                          [](const VertexPart& part) { return part.kind != PartKind::body; });
    return std::move(parts_);
  }

  /// Half-edges that all searches have looked at, which is what they cost.
  std::uint64_t looked_at() const { return looked_at_; }

 private:
  bool take_next() {
    if (std::optional<Vertex> v = next_of(full_leaves_, 1)) return take_single(*v);
    if (std::optional<Vertex> v = next_of(leaves_, 1)) return take_single(*v);
    if (std::optional<Vertex> v = next_of(passages_, 2)) {
      const std::vector<Vertex> cycle = cycle_component(*v);
      return cycle.empty() ? take_single(*v) : take(PartKind::cycle, cycle);
    }
    while (first_ < at_.size() && at_[first_].is_taken) ++first_;
    if (first_ == at_.size()) return false;
    return take_from_core(first_);
  }

  /// The first one of the queue that is still there and has at most this degree.
  std::optional<Vertex> next_of(std::deque<Vertex>& queue, std::uint32_t degree) {
    while (!queue.empty()) {
      const Vertex v = queue.front();
      queue.pop_front();
      if (!at_[v].is_taken && at_[v].degree <= degree) return v;
    }
    return std::nullopt;
  }

  void note_degree(Vertex v) {
    const std::size_t degree = at_[v].degree;
    if (degree == 2) passages_.push_back(v);
    if (degree <= 1) (at_[v].full_degree == 4 ? full_leaves_ : leaves_).push_back(v);
  }

  bool take_single(Vertex v) {
    expect(at_[v].full_degree - at_[v].degree <= 3, "a single has at most 3 earlier neighbours");
    return take(PartKind::single, {&v, 1});
  }

  bool take(PartKind kind, std::span<const Vertex> part, const SmallBody* body = nullptr) {
    for (const Vertex v : part) remove(v);
    for (const Vertex v : part) {
      for (const Vertex w : neighbours(v)) {
        if (!at_[w].is_taken) note_degree(w);
      }
    }
    parts_.push_back({kind, {part.begin(), part.end()}, body});
    return true;
  }

  /// From a component in which all degrees are at least 3: an induced cycle that leaves only
  /// components alive, or the component as a body.
  bool take_from_core(Vertex root) {
    // At most 2 log2(k) + 1 long for k vertices.
    std::vector<Vertex> cycle = first_cycle(root, [](Vertex) { return true; });
    if (leaves_all_alive(cycle)) return take(PartKind::cycle, cycle);
    ++stamp_;
    const std::vector<Vertex> core = unmarked_component(root);
    auto [dead, alive] = dead_and_alive(core, cycle);
    if (alive.empty()) {
      cycle = cycle_beside_cycle(core);
      if (cycle.empty()) return take_body(core);
      std::tie(dead, alive) = dead_and_alive(core, cycle);
    }
    // The largest living piece grows, so this ends (Lemma E.2).
    while (!dead.empty()) {
      cycle = cycle_off(cycle, dead, alive);
      std::tie(dead, alive) = dead_and_alive(core, cycle);
    }
    return take(PartKind::cycle, cycle);
  }

  bool take_body(const std::vector<Vertex>& core) {
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < core.size(); ++i) {
      for (const Vertex to : neighbours(core[i])) {
        const auto at = std::find(core.begin(), core.end(), to) - core.begin();
        if (to > core[i]) edges.push_back({static_cast<Vertex>(i), static_cast<Vertex>(at)});
      }
    }
    auto [body, vertices] = find_body(Graph(core.size(), std::move(edges)));
    expect(body != nullptr, "a core without two disjoint cycles is one of the small bodies");
    for (Vertex& v : vertices) v = core[v];
    return take(PartKind::body, vertices, body);
  }

  std::span<const Vertex> neighbours(Vertex v) const { return {at_[v].to.data(), at_[v].degree}; }

  void remove(Vertex v) {
    at_[v].is_taken = true;
    for (const Vertex w : neighbours(v)) {
      const auto end = at_[w].to.begin() + at_[w].degree--;
      std::shift_left(std::find(at_[w].to.begin(), end, v), end, 1);
    }
  }

  /// The component of v, in cyclic order, if it is a cycle; else nothing. Walks over vertices of
  /// degree 2 only. @pre v has degree 2.
  std::vector<Vertex> cycle_component(Vertex v) {
    std::vector<Vertex> walk = {v};
    Vertex before = v;
    for (Vertex at = v; at_[at].degree == 2;) {
      Vertex next = at;
      for (const Vertex w : look_at(at)) {
        if (w != before) next = w;
      }
      if (next == v) return walk;
      before = at;
      at = next;
      walk.push_back(at);
    }
    return {};
  }

  /// True if every component of the core without the cycle is alive. Goes through each only until
  /// that is seen: a tree of t vertices has at least t + 2 edges to the cycle, which has at most
  /// two at each of its vertices, so what is larger is no tree.
  bool leaves_all_alive(const std::vector<Vertex>& cycle) {
    const std::uint64_t off = ++stamp_;
    for (const Vertex v : cycle) {
      at_[v].mark = off;
      prefetch_neighbours(v);
    }
    for (const Vertex on : cycle) {
      for (const Vertex root : look_at(on)) {
        if (at_[root].mark < off && !is_seen_alive(root, off, 2 * cycle.size())) return false;
      }
    }
    return true;
  }

  /// Of the components of the core without the cycle the first one that is not alive and the
  /// largest one that is; empty if there is none.
  std::pair<std::vector<Vertex>, std::vector<Vertex>> dead_and_alive(
      const std::vector<Vertex>& core, const std::vector<Vertex>& cycle) {
    ++stamp_;
    for (const Vertex v : cycle) at_[v].mark = stamp_;
    std::pair<std::vector<Vertex>, std::vector<Vertex>> found;
    auto& [dead, alive] = found;
    for (const Vertex root : core) {
      if (marked(root)) continue;
      std::vector<Vertex> piece = unmarked_component(root);
      std::size_t ends = 0;  // of the piece's edges
      bool is_full = true;
      for (const Vertex v : piece) {
        is_full = is_full && at_[v].full_degree == 4;
        for (const Vertex w : neighbours(v)) {
          if (std::find(cycle.begin(), cycle.end(), w) == cycle.end()) ++ends;
        }
      }
      const bool is_alive = !is_full || ends / 2 >= piece.size();
      if (is_alive ? piece.size() > alive.size() : dead.empty()) {
        (is_alive ? alive : dead) = std::move(piece);
      }
    }
    return found;
  }

  /// An induced cycle in `dead` and `cycle` less one vertex beside `alive`.
  std::vector<Vertex> cycle_off(const std::vector<Vertex>& cycle, const std::vector<Vertex>& dead,
                                const std::vector<Vertex>& alive) {
    ++stamp_;
    for (const Vertex v : alive) at_[v].mark = stamp_;
    const auto beside = std::find_if(cycle.begin(), cycle.end(), [&](Vertex v) {
      const auto to = look_at(v);
      return std::any_of(to.begin(), to.end(), [&](Vertex w) { return marked(w); });
    });
    expect(beside != cycle.end(), "the cycle touches every piece");
    std::vector<Vertex> allowed = dead;
    std::remove_copy(cycle.begin(), cycle.end(), std::back_inserter(allowed), *beside);
    std::sort(allowed.begin(), allowed.end());
    return first_cycle(dead.front(), [&](Vertex v) {
      return std::binary_search(allowed.begin(), allowed.end(), v);
    });
  }

  /// An induced cycle that leaves a living piece, nothing if there is none. Goes through all
  /// induced cycles of the core, which has at most 60 vertices where this is needed (Lemma E.2).
  std::vector<Vertex> cycle_beside_cycle(const std::vector<Vertex>& core) {
    std::vector<Vertex> path;
    for (const Vertex first : core) {
      path = {first};
      if (extend_path(path, core)) return path;
    }
    return {};
  }

  /// The neighbours of v, counted.
  std::span<const Vertex> look_at(Vertex v) {
    looked_at_ += at_[v].degree;
    return neighbours(v);
  }

  bool marked(Vertex v) const { return at_[v].mark == stamp_; }
  void prefetch_neighbours(Vertex v) const {
    for (const Vertex w : neighbours(v)) __builtin_prefetch(&at_[w], 1);
  }

  std::vector<Vertex> unmarked_component(Vertex v) {
    at_[v].mark = stamp_;
    std::vector<Vertex> found = {v};
    for (std::size_t i = 0; i < found.size(); ++i) {
      for (const Vertex w : look_at(found[i])) {
        if (marked(w)) continue;
        at_[w].mark = stamp_;
        found.push_back(w);
      }
    }
    return found;
  }

  /// Searches for a sign of life off the vertices marked `off`; `most` bounds the edges to them.
  bool is_seen_alive(Vertex root, std::uint64_t off, std::size_t most) {
    ++stamp_;
    queue_.clear();
    visit(root, root);
    for (std::size_t i = 0; i < queue_.size(); ++i) {
      const Vertex at = queue_[i];
      if (at_[at].full_degree < 4 || queue_.size() + 2 > most) return true;
      for (const Vertex next : look_at(at)) {
        if (at_[next].mark == off || next == at_[at].parent) continue;
        // A mark of this search closes a cycle; a later one than `off` leads to a living vertex.
        if (at_[next].mark > off) return true;
        visit(next, at);
      }
    }
    return false;
  }

  void visit(Vertex v, Vertex parent) {
    at_[v].mark = stamp_;
    at_[v].parent = parent;
    queue_.push_back(v);
  }

  /// The first cycle of the vertices allowed that a breadth-first search from the root closes. It
  /// is induced: a chord would join two of which one was gone through before.
  template <class Allowed>
  std::vector<Vertex> first_cycle(Vertex root, Allowed&& allowed) {
    constexpr std::size_t kAhead = 8;
    ++stamp_;
    queue_.clear();
    visit(root, root);
    for (std::size_t i = 0; i < queue_.size(); ++i) {
      if (i + kAhead < queue_.size()) prefetch_neighbours(queue_[i + kAhead]);
      const Vertex at = queue_[i];
      for (const Vertex next : look_at(at)) {
        if (!allowed(next) || next == at_[at].parent) continue;
        if (marked(next)) return joined(at, next);
        visit(next, at);
      }
    }
    throw InternalError("internal error: what is searched has a cycle");
  }

  std::vector<Vertex> joined(Vertex x, Vertex y) const {
    // From x up to the common ancestor of both in the breadth-first tree and down to y.
    std::vector<Vertex> up = {x};
    while (at_[up.back()].parent != up.back()) up.push_back(at_[up.back()].parent);
    std::vector<Vertex> down;
    auto meeting = std::find(up.begin(), up.end(), y);
    for (Vertex v = y; meeting == up.end(); meeting = std::find(up.begin(), up.end(), v)) {
      down.push_back(v);
      v = at_[v].parent;
    }
    up.erase(meeting + 1, up.end());
    up.insert(up.end(), down.rbegin(), down.rend());
    return up;
  }

  bool extend_path(std::vector<Vertex>& path, const std::vector<Vertex>& core) {
    // Extends an induced path in all ways whose vertices are larger than the first one; true as
    // soon as it is a cycle that leaves a living piece.
    for (const Vertex next : look_at(path.back())) {
      if (next <= path.front()) continue;
      std::size_t neighbours = 0;  // on the path
      bool closes = false;
      for (const Vertex back : look_at(next)) {
        neighbours += static_cast<std::size_t>(std::count(path.begin(), path.end(), back));
        closes = closes || back == path.front();
      }
      if (std::find(path.begin(), path.end(), next) != path.end()) continue;
      if (neighbours == 1 && path.size() == 1) closes = false;  // the first edge
      if (neighbours > (closes ? 2U : 1U)) continue;
      path.push_back(next);
      if (closes ? !dead_and_alive(core, path).second.empty() : extend_path(path, core))
        return true;
      path.pop_back();
    }
    return false;
  }

  /// Fits half a cache line, as the searches wait for memory.
  struct alignas(32) VertexState {
    std::array<Vertex, 4> to{};  ///< the neighbours that are there
    std::uint64_t mark = 0;
    Vertex parent = 0;  ///< in the breadth-first tree, of marked vertices
    std::uint8_t degree = 0;
    std::uint8_t full_degree = 0;  ///< in the graph
    bool is_taken = false;
  };
  LongVector<VertexState> at_;
  std::vector<Vertex> queue_;
  std::uint64_t looked_at_ = 0;
  std::uint64_t stamp_ = 0;
  std::vector<VertexPart> parts_;
  std::deque<Vertex> full_leaves_;  ///< degree at most 1 in the rest, 4 in the graph
  std::deque<Vertex> leaves_;       ///< degree at most 1 in the rest, less than 4 in the graph
  std::deque<Vertex> passages_;     ///< degree 2 in the rest
  Vertex first_ = 0;                ///< all before it are taken
};

}  // namespace

std::vector<VertexPart> find_partition(const Graph& graph, std::uint64_t* looked_at) {
  Partitioner partitioner(graph);
  std::vector<VertexPart> parts = partitioner.run();
  if (looked_at != nullptr) *looked_at = partitioner.looked_at();
  return parts;
}

}  // namespace ar3d::two_bend_109
