// Step E.2: the order along x, and which tetrahedron of Lemma E.3 stands at each vertex. New slots
// open beside the highest earlier neighbour, so that a vertex with three of them stands between
// two. The list compares by labels, which are spread again where they run out. Cost: O(n), and O(n)
// more each time labels are spread.
#include "ar3d/algorithms/two_bend_109/slots.h"

#include <algorithm>
#include <boost/container/static_vector.hpp>
#include <numeric>
#include <tuple>

#include "ar3d/base/error.h"

namespace ar3d::two_bend_109 {

OrderedGraph::OrderedGraph(const Graph& graph, std::vector<VertexPart> all_parts,
                           const Components& components)
    : parts(all_parts.size()), numbers(graph.num_vertices()), offsets{0} {
  const auto component_of = [&](const VertexPart& part) { return components.of[part.vertices[0]]; };
  std::vector<std::size_t> next(components.count + 1);
  for (const VertexPart& part : all_parts) ++next[component_of(part) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  for (VertexPart& part : all_parts) parts[next[component_of(part)]++] = std::move(part);
  std::vector<Vertex> index(graph.num_vertices());
  names.reserve(graph.num_vertices());
  for (VertexPart& part : parts) {
    for (Vertex& v : part.vertices) {
      index[v] = num_vertices();
      names.push_back(v);
      v = index[v];
    }
  }
  std::vector<Vertex> seen(components.count);
  for (Vertex v = 0; v < graph.num_vertices(); ++v) numbers[index[v]] = seen[components.of[v]]++;
  half_edges.reserve(std::size_t{2} * graph.num_edges());
  offsets.reserve(names.size() + 1);
  for (const Vertex v : names) {
    for (const auto [to, edge] : graph.incident(v)) {
      half_edges.push_back({index[to], 2 * edge + (v < to ? 0 : 1)});
    }
    offsets.push_back(static_cast<std::uint32_t>(half_edges.size()));
  }
}

std::uint32_t SlotList::insert_after(std::uint32_t at) {
  constexpr std::int64_t kStep = std::int64_t{1} << 40;
  const auto label_after = [&](std::uint32_t slot) {
    const std::uint32_t next = slot == kNone ? first_ : after_[slot];
    const std::int64_t low =
        slot == kNone ? (next == kNone ? 0 : label_[next] - 2 * kStep) : label_[slot];
    const std::int64_t high = next == kNone ? low + 2 * kStep : label_[next];
    return std::pair(low, high);
  };
  auto [low, high] = label_after(at);
  constexpr std::int64_t kFar = std::numeric_limits<std::int64_t>::max() / 4;
  if (high - low < 2 || low < -kFar || high > kFar) {
    spread_labels();
    std::tie(low, high) = label_after(at);
  }
  const std::uint32_t added = size();
  const std::uint32_t next = at == kNone ? first_ : after_[at];
  label_.push_back(low + (high - low) / 2);
  before_.push_back(at);
  after_.push_back(next);
  (at == kNone ? first_ : after_[at]) = added;
  (next == kNone ? last_ : before_[next]) = added;
  return added;
}

std::vector<std::uint32_t> SlotList::in_order() const {
  std::vector<std::uint32_t> order;
  order.reserve(size());
  for (std::uint32_t s = first_; s != kNone; s = after_[s]) order.push_back(s);
  return order;
}

void SlotList::spread_labels() {
  const std::int64_t step = (std::int64_t{1} << 60) / size();
  std::int64_t label = 0;
  for (std::uint32_t s = first_; s != kNone; s = after_[s]) label_[s] = label += step;
}

namespace {

/// Lays the parts out one after the other.
class Arranger {
 public:
  explicit Arranger(const OrderedGraph& graph) : graph_(graph), parts_(graph.parts) {
    const std::size_t n = graph.num_vertices();
    made_.slot.assign(n, SlotList::kNone);
    made_.spot.resize(n);
    made_.part.reserve(n);
    made_.stubs.resize(n);
    made_.port.resize(graph.half_edges.size());
    for (std::uint32_t i = 0; i < parts_.size(); ++i) {
      made_.part.insert(made_.part.end(), parts_[i].vertices.size(), i);
    }
  }

  SlotArrangement run() {
    for (const VertexPart& part : parts_) {
      if (part.kind == PartKind::single) open_single(part.vertices[0]);
      if (part.kind == PartKind::cycle) open_cycle(part.vertices);
    }
    number_slots();
    for (const VertexPart& part : parts_) {
      if (part.kind == PartKind::single) stand_single(part.vertices[0]);
      if (part.kind == PartKind::cycle && part.vertices.size() > 3) stand_cycle(part.vertices);
    }
    for (const auto& corners : triangles_) stand_triangle(corners);
    return std::move(made_);
  }

 private:
  bool is_down(Vertex v, Vertex to) const { return to < parts_[made_.part[v]].vertices[0]; }

  using Downs = boost::container::static_vector<Vertex, 4>;

  /// Neighbours in earlier parts, upwards.
  Downs downs(Vertex v) const {
    Downs found;
    for (const HalfEdge& half : graph_.incident(v)) {
      if (!is_down(v, half.to)) continue;
      found.insert(std::upper_bound(found.begin(), found.end(), half.to), half.to);
    }
    return found;
  }

  std::uint32_t new_slot_after(std::uint32_t at, SlotKind kind) {
    made_.kind.push_back(kind);
    triangle_of_.push_back(SlotList::kNone);
    return list_.insert_after(at);
  }

  void open_single(Vertex v) {
    made_.spot[v] = SlotSpot::middle;
    const Downs below = downs(v);
    if (below.size() == 3) return open_three_down(v, below);
    const std::uint32_t at = below.empty() ? list_.last() : made_.slot[below.back()];
    made_.slot[v] = new_slot_after(at, SlotKind::single);
  }

  /// Between two of the neighbours, beside the highest one.
  void open_three_down(Vertex v, const Downs& below) {
    std::array<std::uint32_t, 3> slots{};
    for (std::size_t i = 0; i < 3; ++i) slots[i] = made_.slot[below[i]];
    const std::uint32_t near = slots[2];
    std::sort(slots.begin(), slots.end(),
              [&](std::uint32_t a, std::uint32_t b) { return list_.is_before(a, b); });
    if (slots[0] == slots[2]) return go_inside(v, slots[0], below);
    made_.slot[v] = new_slot_after(near == slots[2] ? list_.before(near) : near, SlotKind::single);
  }

  void go_inside(Vertex v, std::uint32_t slot, const Downs& below) {
    expect(triangle_of_[slot] != SlotList::kNone, "three in one slot are in a triangle");
    auto& corners = triangles_[triangle_of_[slot]];
    made_.slot[v] = slot;
    const auto other = std::find_if(corners.begin(), corners.end(), [&](Vertex corner) {
      return std::find(below.begin(), below.end(), corner) == below.end();
    });
    made_.spot[v] = other == corners.end() ? SlotSpot::centre : SlotSpot::left_inside;
    if (other != corners.end()) std::swap(corners[0], *other);
  }

  void open_cycle(const PartVertices& cycle) {
    std::uint32_t at = list_.last();
    Vertex highest = 0;
    for (const Vertex v : cycle) {
      for (const Vertex w : downs(v)) {
        if (w < highest) continue;
        highest = w;
        at = made_.slot[w];
      }
    }
    if (cycle.size() == 3) {
      at = new_slot_after(at, SlotKind::triangle);
      triangle_of_[at] = static_cast<std::uint32_t>(triangles_.size());
      triangles_.push_back({cycle[0], cycle[1], cycle[2]});
      for (const Vertex v : cycle) made_.slot[v] = at;
      return;
    }
    // Two ends, each of two vertices in one slot: 0 and 1, k - 2 and k - 1.
    const std::size_t k = cycle.size();
    for (std::size_t i = 1; i + 1 < k; ++i) {
      at = new_slot_after(at, SlotKind::cycle);
      made_.slot[cycle[i]] = at;
      made_.spot[cycle[i]] = SlotSpot::upper;
    }
    made_.slot[cycle[0]] = made_.slot[cycle[1]];
    made_.slot[cycle[k - 1]] = made_.slot[cycle[k - 2]];
    made_.spot[cycle[0]] = made_.spot[cycle[k - 1]] = SlotSpot::lower;
  }

  /// Slots get their indices in the order as numbers.
  void number_slots() {
    list_of_ = list_.in_order();
    const std::vector<std::uint32_t>& order = list_of_;
    std::vector<std::uint32_t> index(order.size());
    std::vector<SlotKind> kinds(order.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) {
      index[order[i]] = i;
      kinds[i] = made_.kind[order[i]];
    }
    made_.kind = std::move(kinds);
    for (std::uint32_t& slot : made_.slot) {
      if (slot != SlotList::kNone) slot = index[slot];
    }
  }

  /// The edge from v to w takes this stub.
  void use(Vertex v, Vertex w, std::uint8_t stub) {
    for (const HalfEdge& half : graph_.incident(v)) {
      if (half.to == w) made_.port[half.edge] = stub;
    }
  }

  void stand_single(Vertex v) {
    const Downs below = downs(v);
    std::uint8_t up = 0;
    for (const HalfEdge& half : graph_.incident(v)) {
      if (!is_down(v, half.to)) use(v, half.to, up++);
    }
    if (below.size() < 3) {
      expect(up <= 2, "a single with at most 2 earlier neighbours has at most 2 later ones");
      made_.stubs[v] = number_of_stubs(Stance::middle, 0);
      for (std::size_t i = 0; i < below.size(); ++i) {
        use(v, below[i], static_cast<std::uint8_t>(2 + i));
      }
      return;
    }
    expect(up <= 1, "a vertex with 3 earlier neighbours has at most one later one");
    made_.stubs[v] = number_of_stubs(Stance::three_down, 3);
    if (made_.spot[v] != SlotSpot::middle) return stand_inside(v, below);
    const auto is_right = [&](Vertex w) { return made_.slot[w] > made_.slot[v]; };
    const auto rights = std::count_if(below.begin(), below.end(), is_right);
    expect(rights == 1 || rights == 2, "it stands between two of them");
    if (rights == 2) made_.stubs[v] = number_of_stubs(Stance::three_down, 3, true);
    std::uint8_t pair = 2;
    for (const Vertex w : below) {
      const bool is_alone = is_right(w) == (rights == 1);
      use(v, w, is_alone ? std::uint8_t{1} : pair++);
    }
  }

  void stand_inside(Vertex v, const Downs& below) {
    const auto& corners = triangle_at(made_.slot[v]);
    use(v, corners[1], 2);
    use(v, corners[2], 3);
    for (const Vertex w : below) {
      if (w != corners[1] && w != corners[2]) use(v, w, 1);
    }
  }

  const std::array<Vertex, 3>& triangle_at(std::uint32_t index) const {
    return triangles_[triangle_of_[list_of_[index]]];
  }

  void stand(Vertex v, Stance stance, bool in_x, bool in_y, Vertex first, Vertex second) {
    const Downs below = downs(v);
    made_.stubs[v] = number_of_stubs(stance, below.size(), in_x, in_y);
    // Of two edges down the steeper one leads to the lower vertex (Lemma E.5).
    std::uint8_t outer = 0;
    for (const HalfEdge& half : graph_.incident(v)) {
      const bool is_on_cycle = half.to == first || half.to == second;
      if (!is_on_cycle && !is_down(v, half.to)) use(v, half.to, outer++);
    }
    outer = below.size() == 1 ? 1 : 0;
    for (const Vertex w : below) use(v, w, outer++);
    use(v, first, 2);
    use(v, second, 3);
  }

  void stand_cycle(const PartVertices& c) {
    const std::size_t k = c.size();
    stand(c[0], Stance::corner, false, false, c[k - 1], c[1]);
    stand(c[1], Stance::corner, false, true, c[2], c[0]);
    for (std::size_t i = 2; i + 2 < k; ++i) {
      stand(c[i], Stance::chain, false, false, c[i + 1], c[i - 1]);
    }
    stand(c[k - 2], Stance::corner, true, true, c[k - 3], c[k - 1]);
    stand(c[k - 1], Stance::corner, true, false, c[0], c[k - 2]);
  }

  void stand_triangle(const std::array<Vertex, 3>& c) {
    made_.spot[c[0]] = SlotSpot::right_corner;
    made_.spot[c[1]] = SlotSpot::upper_corner;
    made_.spot[c[2]] = SlotSpot::lower_corner;
    stand(c[0], Stance::triangle_right, false, false, c[1], c[2]);
    stand(c[1], Stance::triangle_upper, false, false, c[0], c[2]);
    stand(c[2], Stance::triangle_upper, false, true, c[0], c[1]);
  }

  const OrderedGraph& graph_;
  const std::vector<VertexPart>& parts_;
  SlotArrangement made_;
  SlotList list_;
  std::vector<std::uint32_t> list_of_;            ///< slots of the list in their order
  std::vector<std::uint32_t> triangle_of_;        ///< of each slot of the list: its triangle
  std::vector<std::array<Vertex, 3>> triangles_;  ///< right, upper and lower corner
};

}  // namespace

SlotArrangement arrange(const OrderedGraph& graph) { return Arranger(graph).run(); }

}  // namespace ar3d::two_bend_109
