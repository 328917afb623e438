// Step E.1, which is the proof of Lemma E.2 case by case: singles from queues of vertices of low
// degree, else an induced cycle, else a body. A component of what is left is alive if it has a
// cycle or a vertex of degree below 4 in the graph; all stay alive. A breadth-first search finds an
// induced cycle, which costs what it visits; trying all of them, in case (d), is exponential in the
// size of the component, which Step E.1 shows to be at most 60 there. Cost: O(n) and what the
// searches go through.
#include "ar3d/algorithms/two_bend_109/partition.h"

#include <algorithm>
#include <deque>
#include <optional>

#include "ar3d/base/error.h"

namespace ar3d::two_bend_109 {
namespace {

/// The components of a core without an induced cycle.
struct Pieces {
  std::vector<std::vector<Vertex>> of;
  std::vector<bool> alive;  ///< has a cycle or a vertex of degree below 4 in the graph
  bool has_alive() const { return std::find(alive.begin(), alive.end(), true) != alive.end(); }
  /// Null if all are alive.
  const std::vector<Vertex>* first_dead() const {
    const auto dead = std::find(alive.begin(), alive.end(), false);
    return dead == alive.end() ? nullptr : &of[static_cast<std::size_t>(dead - alive.begin())];
  }
  /// @pre has_alive().
  const std::vector<Vertex>& largest_alive() const {
    const std::vector<Vertex>* largest = nullptr;
    for (std::size_t i = 0; i < of.size(); ++i) {
      if (alive[i] && (largest == nullptr || of[i].size() > largest->size())) largest = &of[i];
    }
    expect(largest != nullptr, "a piece is alive");
    return *largest;
  }
};

/// The rest of a graph, which are the vertices that are in no part yet, and searches in it. "Core"
/// is a component of it in which all degrees are at least 3.
class Rest {
 public:
  explicit Rest(const Graph& graph) : graph_(graph), at_(graph.num_vertices()) {
    for (Vertex v = 0; v < graph.num_vertices(); ++v) {
      at_[v].degree = static_cast<std::int8_t>(graph.degree(v));
    }
  }
  bool has(Vertex v) const { return at_[v].degree >= 0; }
  std::uint32_t degree(Vertex v) const { return static_cast<std::uint32_t>(at_[v].degree); }
  void remove(Vertex v) {
    at_[v].degree = -1;
    for (const HalfEdge& half : graph_.incident(v)) {
      if (has(half.to)) --at_[half.to].degree;
    }
  }

  /// Half-edges that all searches have looked at, which is what they cost.
  std::uint64_t looked_at() const { return looked_at_; }
  /// The component of v, in cyclic order, if it is a cycle; else nothing. Walks over vertices of
  /// degree 2 only. @pre v has degree 2.
  std::vector<Vertex> cycle_component(Vertex v) {
    std::vector<Vertex> walk = {v};
    Vertex before = v;
    for (Vertex at = v; degree(at) == 2;) {
      Vertex next = at;
      for (const HalfEdge& half : look_at(at)) {
        if (has(half.to) && half.to != before) next = half.to;
      }
      if (next == v) return walk;
      before = at;
      at = next;
      walk.push_back(at);
    }
    return {};
  }

  std::vector<Vertex> component(Vertex v) {
    ++stamp_;
    at_[v].mark = stamp_;
    std::vector<Vertex> found = {v};
    for (std::size_t i = 0; i < found.size(); ++i) {
      for (const HalfEdge& half : look_at(found[i])) {
        if (!has(half.to) || marked(half.to)) continue;
        at_[half.to].mark = stamp_;
        found.push_back(half.to);
      }
    }
    return found;
  }
  /// An induced cycle in the core of root: the first one that a breadth-first search meets, which
  /// is at most 2 log2(k) + 1 long for k vertices.
  std::vector<Vertex> first_cycle(Vertex root) {
    std::vector<Vertex> cycle = first_cycle_in(root, [&](Vertex v) { return has(v); });
    expect(!cycle.empty(), "a core has a cycle");
    return cycle;
  }

  /// True if every component of the core without the cycle is alive. Goes through each only until
  /// that is seen: a tree of t vertices has at least t + 2 edges to the cycle, which has at most
  /// two at each of its vertices, so what is larger is no tree.
  bool leaves_all_alive(const std::vector<Vertex>& cycle) {
    ++stamp_;
    const std::uint64_t off = stamp_;
    for (const Vertex v : cycle) at_[v].mark = off;
    const std::uint64_t first_round = stamp_ + 1;
    for (const Vertex on : cycle) {
      for (const HalfEdge& half : look_at(on)) {
        if (!has(half.to) || at_[half.to].mark >= off) continue;
        ++stamp_;
        at_[half.to].mark = stamp_;
        at_[half.to].parent = half.to;
        queue_ = {half.to};
        bool is_alive = false;
        for (std::size_t i = 0; i < queue_.size() && !is_alive; ++i) {
          const Vertex at = queue_[i];
          is_alive = graph_.degree(at) < 4 || queue_.size() + 2 > 2 * cycle.size();
          for (const HalfEdge& next : look_at(at)) {
            if (!has(next.to) || at_[next.to].mark == off || next.to == at_[at].parent) continue;
            // A mark of this round closes a cycle; one of a round before leads to a living vertex.
            if (at_[next.to].mark >= first_round) {
              is_alive = true;
              break;
            }
            at_[next.to].mark = stamp_;
            at_[next.to].parent = at;
            queue_.push_back(next.to);
          }
        }
        if (!is_alive) return false;
      }
    }
    return true;
  }
  Pieces pieces(const std::vector<Vertex>& core, const std::vector<Vertex>& cycle) {
    ++stamp_;
    for (const Vertex v : cycle) at_[v].mark = stamp_;
    Pieces pieces;
    for (const Vertex root : core) {
      if (marked(root)) continue;
      at_[root].mark = stamp_;
      std::vector<Vertex> piece = {root};
      std::size_t ends = 0;  // of the piece's edges
      bool is_full = true;
      for (std::size_t i = 0; i < piece.size(); ++i) {
        is_full = is_full && graph_.degree(piece[i]) == 4;
        for (const HalfEdge& half : look_at(piece[i])) {
          if (!has(half.to) || std::find(cycle.begin(), cycle.end(), half.to) != cycle.end()) {
            continue;
          }
          ++ends;
          if (marked(half.to)) continue;
          at_[half.to].mark = stamp_;
          piece.push_back(half.to);
        }
      }
      pieces.alive.push_back(!is_full || ends / 2 >= piece.size());
      pieces.of.push_back(std::move(piece));
    }
    return pieces;
  }

  /// An induced cycle in `dead` and `cycle` less one vertex beside `alive`.
  std::vector<Vertex> cycle_off(const std::vector<Vertex>& cycle, const std::vector<Vertex>& dead,
                                const std::vector<Vertex>& alive) {
    ++stamp_;
    for (const Vertex v : alive) at_[v].mark = stamp_;
    const auto beside = std::find_if(cycle.begin(), cycle.end(), [&](Vertex v) {
      const auto incident = look_at(v);
      return std::any_of(incident.begin(), incident.end(),
                         [&](const HalfEdge& half) { return marked(half.to); });
    });
    expect(beside != cycle.end(), "the cycle touches every piece");
    std::vector<Vertex> allowed = dead;
    for (const Vertex v : cycle) {
      if (v != *beside) allowed.push_back(v);
    }
    std::sort(allowed.begin(), allowed.end());
    std::vector<Vertex> found = first_cycle_in(dead.front(), [&](Vertex v) {
      return std::binary_search(allowed.begin(), allowed.end(), v);
    });
    expect(!found.empty(), "a dead piece and the cycle without a vertex have a cycle");
    return found;
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

 private:
  /// The half-edges of v, counted.
  std::span<const HalfEdge> look_at(Vertex v) {
    looked_at_ += graph_.degree(v);
    return graph_.incident(v);
  }

  bool marked(Vertex v) const { return at_[v].mark == stamp_; }
  template <class Allowed>
  std::vector<Vertex> first_cycle_in(Vertex root, Allowed&& allowed) {
    // The cycle is induced: a chord would join two vertices of which one was gone through before,
    // and would have ended the search then.
    ++stamp_;
    at_[root].mark = stamp_;
    at_[root].parent = root;
    queue_ = {root};
    for (std::size_t i = 0; i < queue_.size(); ++i) {
      const Vertex at = queue_[i];
      for (const HalfEdge& half : look_at(at)) {
        if (!allowed(half.to) || half.to == at_[at].parent) continue;
        if (marked(half.to)) return joined(at, half.to);
        at_[half.to].mark = stamp_;
        at_[half.to].parent = at;
        queue_.push_back(half.to);
      }
    }
    return {};
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
    for (const HalfEdge& half : look_at(path.back())) {
      const Vertex next = half.to;
      if (!has(next) || next <= path.front()) continue;
      std::size_t neighbours = 0;  // on the path
      bool closes = false;
      for (const HalfEdge& back : look_at(next)) {
        neighbours += static_cast<std::size_t>(std::count(path.begin(), path.end(), back.to));
        closes = closes || back.to == path.front();
      }
      if (std::find(path.begin(), path.end(), next) != path.end()) continue;
      if (neighbours == 1 && path.size() == 1) closes = false;  // the first edge
      if (neighbours > (closes ? 2U : 1U)) continue;
      path.push_back(next);
      if (closes ? pieces(core, path).has_alive() : extend_path(path, core)) return true;
      path.pop_back();
    }
    return false;
  }

  const Graph& graph_;
  struct VertexState {
    std::uint64_t mark = 0;
    Vertex parent = 0;        ///< in the breadth-first tree, of marked vertices
    std::int8_t degree = -1;  ///< -1: not there
  };
  std::vector<VertexState> at_;
  std::vector<Vertex> queue_;
  std::uint64_t looked_at_ = 0;
  std::uint64_t stamp_ = 0;
};

class Partitioner {
 public:
  explicit Partitioner(const Graph& graph) : graph_(graph), rest_(graph) {}

  std::vector<VertexPart> run() {
    for (Vertex v = 0; v < graph_.num_vertices(); ++v) note_degree(v);
    while (take_next()) {
    }
    // Nothing is later than a body anyway.
    std::stable_partition(parts_.begin(), parts_.end(),
                          [](const VertexPart& part) { return part.kind != PartKind::body; });
    return std::move(parts_);
  }

  std::uint64_t looked_at() const { return rest_.looked_at(); }

 private:
  bool take_next() {
    if (std::optional<Vertex> v = next_of(full_leaves_, 1)) return take_single(*v);
    if (std::optional<Vertex> v = next_of(leaves_, 1)) return take_single(*v);
    if (std::optional<Vertex> v = next_of(passages_, 2)) {
      const std::vector<Vertex> cycle = rest_.cycle_component(*v);
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

  bool take(VertexPart part) {
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
    std::vector<Vertex> cycle = rest_.first_cycle(root);
    if (rest_.leaves_all_alive(cycle)) return take({PartKind::cycle, cycle, nullptr});
    const std::vector<Vertex> core = rest_.component(root);
    Pieces pieces = rest_.pieces(core, cycle);
    if (!pieces.has_alive()) {
      cycle = rest_.cycle_beside_cycle(core);
      if (cycle.empty()) return take_body(core);
      pieces = rest_.pieces(core, cycle);
    }
    // The largest living piece grows, so this ends (Lemma E.2).
    while (const std::vector<Vertex>* dead = pieces.first_dead()) {
      cycle = rest_.cycle_off(cycle, *dead, pieces.largest_alive());
      pieces = rest_.pieces(core, cycle);
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
    auto [body, vertices] = find_body(Graph(core.size(), std::move(edges)));
    expect(body != nullptr, "a core without two disjoint cycles is one of the small bodies");
    for (Vertex& v : vertices) v = core[v];
    return take({PartKind::body, std::move(vertices), body});
  }

  const Graph& graph_;
  Rest rest_;
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
