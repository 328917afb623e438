// Step F.5: the stars of Rule F.1 from the two orders; then a and b, in which neighbouring values
// are as far apart as the drawings of vertices reach; then heights, so that the slabs of two
// vertices, in which all but the long segments lie, are apart. Cost: O(n).
#include "ar3d/algorithms/two_bend_120/placement.h"

#include <algorithm>
#include <cstdlib>

namespace ar3d::two_bend_120 {
namespace {

// Letters 1 to 4 of the page.
constexpr Direction k12{0, 1}, k13{0, 2}, k14{0, 3}, k23{1, 2}, k24{1, 3}, k34{2, 3};

/// Letters 1 and 4, 2 and 3 swapped: with S for T and a for b, what holds at T holds at S.
constexpr Direction dual(Direction d) { return {3 - d.plus, 3 - d.minus}; }

/// One end, T or S: its neighbours by their roles, seen from T.
struct End {
  Vertex vertex = 0;
  bool middle_is_least = false;  ///< else it is the largest
  Vertex middle = 0;             ///< the second one in b, and the first or last one in a
  Vertex across = 0, along = 0;  ///< the others; the first is on the other side in b than in a
};

class Placer {
 public:
  Placer(const ForkOrder& numbering, const Orders& orders, const Reach& reach)
      : graph_(numbering.graph), forks_(numbering.forks), reach_(reach) {
    a_.resize(graph_.size());
    b_.resize(graph_.size());
    number(orders.a, a_);
    number(orders.b, b_);
    top_ = end(static_cast<Vertex>(graph_.size()) - 1, b_, a_);
    bottom_ = end(0, a_, b_);
  }

  ForkPlaces run(const Orders& orders) {
    set_stars();
    Margins in_a(graph_.size(), {1, 1}), in_b = in_a;
    reserve_for_forks(in_a, in_b);
    reserve_for_end(top_, in_a, in_b);
    reserve_for_end(bottom_, in_b, in_a);
    spread(orders.a, in_a, a_);
    spread(orders.b, in_b, b_);
    place_end(top_, a_, b_);
    place_end(bottom_, b_, a_);
    set_heights();
    return std::move(result_);
  }

 private:
  using Values = std::vector<std::int64_t>;
  using Margins = std::vector<std::array<std::int64_t, 2>>;  // per vertex: below and above it

  /// True if v is a D with a U above it.
  bool joined(Vertex v) const { return !forks_[v].opens_up && forks_[forks_[v].stem].opens_up; }

  /// Values 0, 1, 2, ...
  void number(const std::vector<Vertex>& order, Values& values) const {
    std::int64_t value = 0;
    for (const Vertex v : order) set(v, value++, values);
  }
  void set(Vertex v, std::int64_t value, Values& values) const {
    values[v] = value;
    if (joined(v)) values[forks_[v].stem] = value;
  }

  /// @param b, a  for S the other way round.
  End end(Vertex vertex, const Values& b, const Values& a) const {
    std::array<Vertex, 3> near{graph_[vertex][0].to, graph_[vertex][1].to, graph_[vertex][2].to};
    std::sort(near.begin(), near.end(), [&](Vertex v, Vertex w) { return b[v] < b[w]; });
    const auto [low, middle, high] = near;
    const bool least = a[middle] < a[low];
    return {vertex, least, middle, least ? low : high, least ? high : low};
  }

  Direction& star(Vertex v, Vertex to) { return result_.stars[v][slot(v, to)]; }
  std::size_t slot(Vertex v, Vertex to) const {
    return graph_[v][0].to == to ? 0 : graph_[v][1].to == to ? 1 : 2;
  }
  std::int64_t reach(Vertex v, Vertex to) const { return reach_[v][slot(v, to)]; }

  /// The prongs of v, the one with the smaller value first: a of a U, b of a D.
  std::array<Vertex, 2> prongs(Vertex v) const {
    const Values& values = forks_[v].opens_up ? a_ : b_;
    const auto [first, second] = forks_[v].prongs;
    if (values[first] < values[second]) return {first, second};
    return {second, first};
  }

  void set_stars() {
    result_.stars.resize(graph_.size());
    for (Vertex v = 1; v + 1 < graph_.size(); ++v) {
      const auto [less, more] = prongs(v);
      const bool up = forks_[v].opens_up;
      star(v, forks_[v].stem) = up ? -k14 : k14;
      star(v, less) = up ? k12 : -k34;
      star(v, more) = up ? k24 : -k13;
    }
    const auto set_end = [&](const End& end, auto turn) {
      star(end.vertex, end.middle) = turn(end.middle_is_least ? k12 : k24);
      star(end.vertex, end.across) = turn(end.middle_is_least ? k23 : -k23);
      star(end.vertex, end.along) = turn(end.middle_is_least ? -k13 : -k34);
    };
    set_end(top_, [](Direction d) { return d; });
    set_end(bottom_, dual);
  }

  /// Lemma F.8: the drawing of a U is in the plane of its b, that of a D in the plane of its a.
  void reserve_for_forks(Margins& in_a, Margins& in_b) const {
    for (Vertex v = 1; v + 1 < graph_.size(); ++v) {
      const auto [less, more] = prongs(v);
      (forks_[v].opens_up ? in_a : in_b)[v] = {reach(v, less), reach(v, more)};
      // The lists name the D of two joined vertices.
      if (forks_[v].opens_up && joined(forks_[v].stem)) in_a[forks_[v].stem] = in_a[v];
    }
  }

  /// @param in_a, in_b  for S the other way round.
  void reserve_for_end(const End& end, Margins& in_a, Margins& in_b) const {
    const std::int64_t across = reach(end.vertex, end.across);
    const std::size_t side = end.middle_is_least ? 1 : 0;  // of the middle one in a, where T is
    const auto raise = [&](Margins& margins, std::size_t at, std::int64_t least) {
      std::int64_t& margin = margins[end.middle][at];
      margin = std::max(margin, least);
    };
    raise(in_a, side, reach(end.vertex, end.middle) + 2 + across);
    raise(in_b, 1 - side, across);
    raise(in_b, side, reach(end.vertex, end.along));
  }

  void spread(const std::vector<Vertex>& order, const Margins& margins, Values& values) const {
    std::int64_t value = 0, above = 0;
    for (const Vertex v : order) {
      value += std::max(above, order.front() == v ? 0 : margins[v][0]);
      set(v, value, values);
      above = margins[v][1];
    }
  }

  /// Of two places for T, in one the bend of the word to the one across is not ambiguous.
  void place_end(const End& end, Values& a, Values& b) const {
    b[end.vertex] = b[end.middle];
    const std::int64_t step = reach(end.vertex, end.middle) + 1;
    const std::int64_t sign = end.middle_is_least ? 1 : -1;
    a[end.vertex] = a[end.middle] + sign * step;
    const auto from_across = [&](const Values& values) {
      return std::abs(values[end.across] - values[end.vertex]);
    };
    if (from_across(a) == from_across(b)) a[end.vertex] += sign;
  }

  /// How far below and above v the short segments of its edges and its drawing reach.
  std::array<std::int64_t, 2> slab(Vertex v) const {
    const auto distance = [&](const Values& values, Vertex w) {
      return std::abs(values[v] - values[w]);
    };
    if (v == top_.vertex || v == bottom_.vertex) {
      std::int64_t most = 0;
      for (const HalfEdge& half : graph_[v]) {
        most = std::max(most, distance(a_, half.to) + distance(b_, half.to));
      }
      return {most, most};
    }
    const auto [less, more] = prongs(v);
    const std::int64_t to_stem = reach(v, forks_[v].stem);
    if (forks_[v].opens_up) {
      return {to_stem, distance(a_, more) + (forks_[more].opens_up ? distance(b_, more) : 0)};
    }
    return {distance(b_, less) + (forks_[less].opens_up ? 0 : distance(a_, less)), to_stem};
  }

  void set_heights() {
    result_.at.resize(graph_.size());
    std::int64_t height = 0, above = 0;
    for (Vertex v = 0; v < graph_.size(); ++v) {
      const auto [down, up] = slab(v);
      height += above + down + 1;
      above = up;
      result_.at[v] = {height - a_[v] - b_[v], a_[v], b_[v], -height};
    }
  }

  const CubicGraph& graph_;
  const std::vector<Fork>& forks_;
  const Reach& reach_;
  Values a_, b_;
  End top_, bottom_;
  ForkPlaces result_;
};

}  // namespace

ForkPlaces place(const ForkOrder& numbering, const Orders& orders, const Reach& reach) {
  return Placer(numbering, orders, reach).run(orders);
}

}  // namespace ar3d::two_bend_120
