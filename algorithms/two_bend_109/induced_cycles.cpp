// Step E.1, the searches for cycles in what is left of a component K: cases (b) to (d) of the proof
// of Lemma E.2. A breadth-first search finds an induced cycle, which costs what it visits, O(|K|)
// at worst. Trying all induced cycles, in case (d), is exponential in |K|, but Step E.1 shows that
// |K| is at most 60 there.
#include "ar3d/algorithms/two_bend_109/induced_cycles.h"

#include <algorithm>

#include "ar3d/base/error.h"

namespace ar3d::two_bend_109 {

Rest::Rest(const Graph& graph) : graph_(graph), degree_(graph.num_vertices()) {
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    degree_[v] = static_cast<std::int8_t>(graph.degree(v));
  }
}

void Rest::remove(Vertex v) {
  degree_[v] = -1;
  for (const HalfEdge& half : graph_.incident(v)) {
    if (has(half.to)) --degree_[half.to];
  }
}

bool Pieces::has_alive() const {
  return std::find(alive.begin(), alive.end(), true) != alive.end();
}

const std::vector<Vertex>* Pieces::first_dead() const {
  const auto dead = std::find(alive.begin(), alive.end(), false);
  return dead == alive.end() ? nullptr : &of[static_cast<std::size_t>(dead - alive.begin())];
}

const std::vector<Vertex>& Pieces::largest_alive() const {
  const std::vector<Vertex>* largest = nullptr;
  for (std::size_t i = 0; i < of.size(); ++i) {
    if (alive[i] && (largest == nullptr || of[i].size() > largest->size())) largest = &of[i];
  }
  expect(largest != nullptr, "a piece is alive");
  return *largest;
}

CycleSearch::CycleSearch(const Graph& graph, const Rest& rest)
    : graph_(graph), rest_(rest), mark_(graph.num_vertices()), parent_(graph.num_vertices()) {}

void CycleSearch::new_marks() { ++stamp_; }

std::span<const HalfEdge> CycleSearch::look_at(Vertex v) {
  looked_at_ += graph_.degree(v);
  return graph_.incident(v);
}

std::vector<Vertex> CycleSearch::cycle_component(Vertex v) {
  std::vector<Vertex> walk = {v};
  Vertex before = v;
  for (Vertex at = v; rest_.degree(at) == 2;) {
    Vertex next = at;
    for (const HalfEdge& half : look_at(at)) {
      if (rest_.has(half.to) && half.to != before) next = half.to;
    }
    if (next == v) return walk;
    before = at;
    at = next;
    walk.push_back(at);
  }
  return {};
}

std::vector<Vertex> CycleSearch::component(Vertex v) {
  new_marks();
  mark_[v] = stamp_;
  std::vector<Vertex> found = {v};
  for (std::size_t i = 0; i < found.size(); ++i) {
    for (const HalfEdge& half : look_at(found[i])) {
      if (!rest_.has(half.to) || marked(half.to)) continue;
      mark_[half.to] = stamp_;
      found.push_back(half.to);
    }
  }
  return found;
}

/// From x up to the common ancestor of both in the breadth-first tree and down to y.
std::vector<Vertex> CycleSearch::joined(Vertex x, Vertex y) const {
  std::vector<Vertex> up;
  for (Vertex v = x;; v = parent_[v]) {
    up.push_back(v);
    if (parent_[v] == v) break;
  }
  std::vector<Vertex> down;
  for (Vertex v = y;; v = parent_[v]) {
    const auto meeting = std::find(up.begin(), up.end(), v);
    if (meeting != up.end()) {
      up.erase(meeting + 1, up.end());
      break;
    }
    down.push_back(v);
  }
  up.insert(up.end(), down.rbegin(), down.rend());
  return up;
}

/// The cycle is induced: a chord would join two vertices of which one was gone through before, and
/// would have ended the search then.
template <class Allowed>
std::vector<Vertex> CycleSearch::first_cycle_in(Vertex root, Allowed&& allowed) {
  new_marks();
  mark_[root] = stamp_;
  parent_[root] = root;
  std::vector<Vertex> queue = {root};
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const Vertex at = queue[i];
    for (const HalfEdge& half : look_at(at)) {
      if (!allowed(half.to) || half.to == parent_[at]) continue;
      if (marked(half.to)) return joined(at, half.to);
      mark_[half.to] = stamp_;
      parent_[half.to] = at;
      queue.push_back(half.to);
    }
  }
  return {};
}

std::vector<Vertex> CycleSearch::first_cycle(Vertex root) {
  std::vector<Vertex> cycle = first_cycle_in(root, [&](Vertex v) { return rest_.has(v); });
  expect(!cycle.empty(), "a core has a cycle");
  return cycle;
}

bool CycleSearch::leaves_all_alive(const std::vector<Vertex>& cycle) {
  new_marks();
  const std::uint64_t off = stamp_;
  for (const Vertex v : cycle) mark_[v] = off;
  const std::uint64_t first_round = stamp_ + 1;
  std::vector<Vertex> queue;
  for (const Vertex on : cycle) {
    for (const HalfEdge& half : look_at(on)) {
      if (!rest_.has(half.to) || mark_[half.to] >= off) continue;
      new_marks();
      mark_[half.to] = stamp_;
      parent_[half.to] = half.to;
      queue = {half.to};
      bool is_alive = false;
      for (std::size_t i = 0; i < queue.size() && !is_alive; ++i) {
        const Vertex at = queue[i];
        is_alive = graph_.degree(at) < 4;
        for (const HalfEdge& next : look_at(at)) {
          if (!rest_.has(next.to) || mark_[next.to] == off || next.to == parent_[at]) continue;
          // A mark of this round closes a cycle; one of a round before leads to a living vertex.
          if (mark_[next.to] >= first_round) {
            is_alive = true;
            break;
          }
          mark_[next.to] = stamp_;
          parent_[next.to] = at;
          queue.push_back(next.to);
        }
      }
      if (!is_alive) return false;
    }
  }
  return true;
}

Pieces CycleSearch::pieces(const std::vector<Vertex>& core, const std::vector<Vertex>& cycle) {
  new_marks();
  for (const Vertex v : cycle) mark_[v] = stamp_;
  Pieces pieces;
  for (const Vertex root : core) {
    if (marked(root)) continue;
    mark_[root] = stamp_;
    std::vector<Vertex> piece = {root};
    std::size_t ends = 0;  // of the piece's edges
    bool is_full = true;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      is_full = is_full && graph_.degree(piece[i]) == 4;
      for (const HalfEdge& half : look_at(piece[i])) {
        if (!rest_.has(half.to) || std::find(cycle.begin(), cycle.end(), half.to) != cycle.end()) {
          continue;
        }
        ++ends;
        if (marked(half.to)) continue;
        mark_[half.to] = stamp_;
        piece.push_back(half.to);
      }
    }
    pieces.alive.push_back(!is_full || ends / 2 >= piece.size());
    pieces.of.push_back(std::move(piece));
  }
  return pieces;
}

std::vector<Vertex> CycleSearch::cycle_off(const std::vector<Vertex>& cycle,
                                           const std::vector<Vertex>& dead,
                                           const std::vector<Vertex>& alive) {
  new_marks();
  for (const Vertex v : alive) mark_[v] = stamp_;
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

/// Extends an induced path in all ways whose vertices are larger than the first one; true as soon
/// as it is a cycle that leaves a living piece.
bool CycleSearch::extend_path(std::vector<Vertex>& path, const std::vector<Vertex>& core) {
  for (const HalfEdge& half : look_at(path.back())) {
    const Vertex next = half.to;
    if (!rest_.has(next) || next <= path.front()) continue;
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

std::vector<Vertex> CycleSearch::cycle_beside_cycle(const std::vector<Vertex>& core) {
  std::vector<Vertex> path;
  for (const Vertex first : core) {
    path = {first};
    if (extend_path(path, core)) return path;
  }
  return {};
}

}  // namespace ar3d::two_bend_109
