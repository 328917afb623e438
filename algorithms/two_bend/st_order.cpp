#include "ar3d/algorithms/two_bend/st_order.h"

#include <algorithm>
#include <utility>

#include "ar3d/model/error.h"

namespace ar3d::two_bend {

StOrder::StOrder(const LocalGraph& graph, const Blocks& blocks)
    : graph_(graph), blocks_(blocks), cells_(graph.size()) {}

const std::vector<Vertex>& StOrder::order(Vertex s, Vertex t) {
  expect(s != t && !blocks_.is_bridge(s, t), "an st-order runs between two vertices of one block");
  search(s, t);
  find_lows(s, t);
  insert_in_preorder(s, t);
  list_.clear();
  for (Vertex v = s; list_.size() < visited_.size(); v = cells_[v].next) list_.push_back(v);
  expect(list_.back() == t, "an st-order ends at t");
  for (const Vertex v : visited_) cells_[v].preorder = kUnseen;
  return list_;
}

/// Depth-first search of the block from t, with the virtual tree edge s - t above it.
void StOrder::search(Vertex s, Vertex t) {
  visited_.assign({s, t});
  cells_[s].preorder = 0;
  cells_[t].preorder = 1;
  cells_[t].parent = s;
  Vertex at = t;
  while (at != s) {
    const Row& row = graph_.rows[at];
    Vertex down = kUnseen;
    for (std::size_t k = 0; k < row.degree && down == kUnseen; ++k) {
      const Vertex u = row.to[k];
      if (!blocks_.is_bridge(at, u) && cells_[u].preorder == kUnseen) down = u;
    }
    if (down == kUnseen) {
      at = cells_[at].parent;
      continue;
    }
    cells_[down].parent = at;
    cells_[down].preorder = static_cast<Vertex>(visited_.size());
    visited_.push_back(down);
    at = down;
  }
}

void StOrder::find_lows(Vertex s, Vertex t) {
  for (std::size_t i = visited_.size(); i-- > 1;) {
    const Vertex v = visited_[i];
    Cell& cell = cells_[v];
    cell.low = cell.preorder;
    const Row& row = graph_.rows[v];
    for (std::size_t k = 0; k < row.degree; ++k) {
      const Vertex u = row.to[k];
      if (blocks_.is_bridge(v, u) || u == cell.parent || (v == t && u == s)) continue;
      const bool is_child = cells_[u].preorder > cell.preorder && cells_[u].parent == v;
      cell.low = std::min(cell.low, is_child ? cells_[u].low : cells_[u].preorder);
    }
  }
}

void StOrder::insert_in_preorder(Vertex s, Vertex t) {
  cells_[s].next = t;
  cells_[t].previous = s;
  cells_[s].previous = cells_[t].next = kUnseen;
  cells_[s].plus = false;
  for (std::size_t i = 2; i < visited_.size(); ++i) {
    const Vertex v = visited_[i];
    const Vertex p = cells_[v].parent;
    const bool before = !cells_[visited_[cells_[v].low]].plus;
    const Vertex left = before ? cells_[p].previous : p;
    const Vertex right = before ? p : cells_[p].next;
    expect(left != kUnseen && right != kUnseen, "nothing is inserted outside s .. t");
    cells_[v].previous = left;
    cells_[v].next = right;
    cells_[left].next = cells_[right].previous = v;
    cells_[p].plus = before;
  }
}

namespace {

/// Case c: y is adjacent to both of m and not to z.
bool repair_around(const LocalGraph& graph, Vertex* last, Vertex p5, Vertex y,
                   std::pair<Vertex, Vertex> m, Vertex z) {
  Vertex first = y;
  Vertex end = z;
  if (!graph.adjacent(p5, z)) {
    if (!graph.adjacent(p5, y)) return false;
    std::swap(first, end);
  } else if (graph.adjacent(p5, y)) {
    return false;
  }
  last[0] = first;
  last[1] = m.first;
  last[2] = m.second;
  last[3] = end;
  return true;
}

}  // namespace

bool repair_true_sink(const LocalGraph& graph, std::vector<Vertex>& list) {
  if (list.size() < 6) return false;
  Vertex* last = list.data() + list.size() - 4;
  const Vertex y = last[0];
  const std::pair<Vertex, Vertex> wc{last[1], last[2]};
  const Vertex t = last[3];
  const bool meets_c = graph.adjacent(wc.first, wc.second);
  if (!meets_c || !graph.adjacent(wc.first, t)) {  // case a: w has one later neighbour
    if (meets_c) std::swap(last[2], last[3]);
    return true;
  }
  const Vertex triangle[3] = {wc.first, wc.second, t};
  unsigned hits = 0;
  std::size_t hit = 0;
  std::size_t miss = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (graph.adjacent(y, triangle[i])) {
      ++hits;
      hit = i;
    } else {
      miss = i;
    }
  }
  if (hits == 1) {  // case b: the vertex adjacent to y goes last
    last[1] = triangle[(hit + 1) % 3];
    last[2] = triangle[(hit + 2) % 3];
    last[3] = triangle[hit];
    return true;
  }
  if (hits != 2) return false;
  return repair_around(graph, last, last[-1], y,
                       {triangle[(miss + 1) % 3], triangle[(miss + 2) % 3]}, triangle[miss]);
}

unsigned count_closing_neighbours(const LocalGraph& graph, const std::vector<Vertex>& list) {
  const Vertex t = list.back();
  const Row& row = graph.rows[t];
  unsigned count = 0;
  for (std::size_t k = 0; k < row.degree; ++k) {
    const auto at = std::find(list.rbegin(), list.rend(), row.to[k]);
    if (at == list.rend()) continue;
    const auto is_later = [&](Vertex v) { return std::find(list.rbegin(), at, v) != at; };
    unsigned later = 0;
    const Row& other = graph.rows[*at];
    for (std::size_t j = 0; j < other.degree; ++j) later += is_later(other.to[j]) ? 1u : 0u;
    if (later == 1) ++count;
  }
  return count;
}

}  // namespace ar3d::two_bend
