#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "ar3d/algorithms/two_bend_paper/contraction.h"
#include "ar3d/algorithms/two_bend_paper/growth.h"
#include "ar3d/algorithms/two_bend_paper/stacking.h"
#include "ar3d/base/error.h"

namespace ar3d::two_bend_paper {

/// The rooms of figures that replace nodes, of all contractions whose result is left in the
/// contracted graph, by contraction: the radius within which the figure stays, a power of two, and
/// whether the node's two edges leave it at 180 degrees. Step P.9: the radius is at most a third of 1, of the lengths of the first pieces at the place,
/// and of its distance from every other segment of the component. Others get radius 0. Found in
/// double, on the drawing in double. Cost: O(m) for each of them.
std::vector<std::pair<double, bool>> top_rooms(const ContractedGraph& graph,
                                               const std::vector<Component>& components,
                                               std::size_t num_edges);

/// Undoes the contractions in a drawing of the contracted graph, the last one first (Steps P.9 to
/// P.12): each node becomes a small planar figure of its members. A figure of radius r lies in the
/// ball of radius r around the node; the directions of its edges are computed from offsets of
/// unit size, never from points. O(contractions) operations.
template <class T>
class Expansion {
 public:
  Expansion(const ContractedGraph& graph, NodePoints<T>& points) : graph_(graph), points_(points) {
    directions_.resize(points.bends.size());
  }

  /// @param rooms  of top_rooms().
  void run(std::vector<std::pair<double, bool>> rooms) {
    const auto& steps = graph_.contractions;
    const Node inputs = graph_.num_nodes() - static_cast<Node>(steps.size());
    for (const Contraction& step : steps) {
      if (graph_.alive[step.result]) read_directions(step);
    }
    for (std::size_t i = steps.size(); i-- > 0;) {
      std::tie(radius_, is_straight_) = rooms[i];
      expect(radius_ > 0, "a contraction has a radius when it is undone");
      expand(steps[i]);
      for (std::size_t m = 0; m < steps[i].members.size(); ++m) {
        const Node member = steps[i].members[m];
        // Only the third corner of a heptagon inherits the angle of the node.
        const bool is_third = steps[i].outer.size() == 2 && m == 2;
        if (member >= inputs) rooms[member - inputs] = {child_radius_, is_straight_ && is_third};
      }
    }
  }

 private:
  using V = Vector3<T>;

  /// At the top, directions are those of the first pieces.
  void read_directions(const Contraction& step) {
    for (const auto& [edge, slot] : step.outer) {
      const auto& bends = points_.bends[edge];
      const V next = bends.empty() ? points_.of_node[graph_.ends[edge][1 - slot]]
                                   : (slot == 0 ? bends.front() : bends.back());
      directions_[edge][slot] = unit(next - points_.of_node[step.result]);
    }
  }

  void expand(const Contraction& step) {
    at_ = points_.of_node[step.result];
    switch (step.figure) {
      case FigureKind::triangle:
        return step.outer.size() == 2 ? heptagon(step) : hexagon(step);
      case FigureKind::diamond:
        return diamond(step);
      case FigureKind::fat_leaf:
        return fat_leaf(step);
    }
  }

  V outer_direction(const Contraction& step, std::size_t i) const {
    const auto [edge, slot] = step.outer[i];
    return directions_[edge][slot];
  }

  /// d turned by 120 degrees about n.
  static V turn(const V& d, const V& n, int sign) {
    const T wide = T(T(sign) * square_root(T(3)) / 2);
    return T(T(-1) / 2) * d + wide * cross(n, d);
  }

  /// A unit vector perpendicular to the unit vector a: its cross product with the first axis along
  /// which a component is small. No component that occurs is as close to 0.6 as rounding goes.
  static V perpendicular(const V& a) {
    const auto is_small = [](const T& c) { return std::abs(static_cast<double>(c)) < 0.6; };
    if (is_small(a.x)) return unit(cross(a, V{T(1), T(0), T(0)}));
    return unit(cross(a, is_small(a.y) ? V{T(0), T(1), T(0)} : V{T(0), T(0), T(1)}));
  }

  V place(const V& offset) const { return at_ + T(radius_) * offset; }

  void set_member(const Contraction& step, std::size_t member, const V& offset) {
    offsets_[member] = offset;
    points_.of_node[step.members[member]] = place(offset);
  }

  /// The bends of the edge between two members, given as offsets from the first one on.
  void set_inner(const Contraction& step, std::size_t from, std::size_t to,
                 std::vector<V> offsets) {
    for (const auto& [edge, first_member, last_member] : step.inner) {
      const bool is_forward = first_member == from && last_member == to;
      if (!is_forward && !(first_member == to && last_member == from)) continue;
      const V first = offsets.empty() ? offsets_[to] : offsets.front();
      const V last = offsets.empty() ? offsets_[from] : offsets.back();
      directions_[edge][is_forward ? 0 : 1] = unit(first - offsets_[from]);
      directions_[edge][is_forward ? 1 : 0] = unit(last - offsets_[to]);
      if (!is_forward) std::reverse(offsets.begin(), offsets.end());
      for (V& offset : offsets) offset = place(offset);
      points_.bends[edge] = std::move(offsets);
      return;
    }
    expect(false, "members of a figure are adjacent");
  }

  /// Three outer edges, one or none: a regular hexagon.
  void hexagon(const Contraction& step) {
    std::array<V, 3> d{V{T(1), T(0), T(0)}, V{}, V{}};
    for (std::size_t i = 0; i < step.outer.size(); ++i) d[i] = outer_direction(step, i);
    if (step.outer.size() < 3) {
      const V n = perpendicular(d[0]);
      d[1] = turn(d[0], n, 1);
      d[2] = turn(d[0], n, -1);
    }
    for (std::size_t i = 0; i < 3; ++i) set_member(step, i, d[i]);
    for (std::size_t i = 0; i < 3; ++i) set_inner(step, i, (i + 1) % 3, {-d[(i + 2) % 3]});
    child_radius_ = radius_ / 2;
  }

  /// The plane of two directions d1 and d2 at an angle of 120 to 180 degrees and their bisector.
  struct BisectorFrame {
    V d1;
    V f;  ///< along d1 - d2
    V e;  ///< along d1 + d2
    V n;  ///< e x f

    /// The mirror image that exchanges d1 and d2.
    V mirrored(const V& a) const { return a - T(T(2) * dot(a, f)) * f; }
    /// Returns the part of a point along e.
    V on_axis(const T& part) const { return part * e; }
  };

  static BisectorFrame frame_of(const V& d1, const V& d2, bool is_straight) {
    BisectorFrame frame;
    frame.f = unit(d1 - d2);
    const V sum = d1 + d2;
    if (is_straight) {
      frame.d1 = frame.f;
      frame.e = perpendicular(frame.f);
    } else {
      frame.d1 = d1;
      frame.e = unit(sum - dot(sum, frame.f) * frame.f);
    }
    frame.n = cross(frame.e, frame.f);
    return frame;
  }

  BisectorFrame frame_of(const Contraction& step) const {
    const V d1 = step.outer.empty() ? V{T(1), T(0), T(0)} : outer_direction(step, 0);
    if (step.outer.size() == 2) return frame_of(d1, outer_direction(step, 1), is_straight_);
    return frame_of(d1, turn(d1, perpendicular(d1), 1), false);
  }

  /// From `from` on against d1 until only `share` of its part along f is left.
  static V along(const BisectorFrame& frame, const V& from, const T& share) {
    const T t = T(dot(from, frame.f) * (T(1) - share) / dot(frame.d1, frame.f));
    return from - t * frame.d1;
  }

  /// Two outer edges at corners 0 and 1.
  void heptagon(const Contraction& step) {
    const BisectorFrame frame = frame_of(step);
    const V u = frame.d1;
    const V b1 = u + T(T(1) / 2) * turn(u, frame.n, -1);
    const V b4 = u + T(T(1) / 2) * turn(u, frame.n, 1);
    set_member(step, 0, u);
    set_member(step, 1, frame.mirrored(u));
    set_member(step, 2, frame.on_axis(dot(along(frame, b4, T(0)), frame.e)));
    set_inner(step, 0, 1, {b1, frame.mirrored(b1)});
    set_inner(step, 0, 2, {b4});
    set_inner(step, 1, 2, {frame.mirrored(b4)});
    child_radius_ = radius_ / 4;
  }

  void diamond(const Contraction& step) {
    const BisectorFrame frame = frame_of(step);
    const V u = frame.d1;
    const V b1 = u + T(T(1) / 2) * turn(u, frame.n, -1);
    const V b4 = u + T(T(1) / 2) * turn(u, frame.n, 1);
    const V b2 = along(frame, b1, T(T(1) / 2)), b5 = along(frame, b4, T(T(1) / 2));
    const T root = square_root(T(3));
    set_member(step, 0, u);
    set_member(step, 1, frame.mirrored(u));
    set_member(step, 2, frame.on_axis(T(dot(b2, frame.e) - dot(b2, frame.f) / root)));
    set_member(step, 3, frame.on_axis(T(dot(b5, frame.e) + dot(b5, frame.f) / root)));
    set_inner(step, 0, 2, {b1, b2});
    set_inner(step, 0, 3, {b4, b5});
    set_inner(step, 1, 2, {frame.mirrored(b1), frame.mirrored(b2)});
    set_inner(step, 1, 3, {frame.mirrored(b4), frame.mirrored(b5)});
    set_inner(step, 2, 3, {});
    child_radius_ = radius_ / 8;
  }

  /// Two regular hexagons with a common side, in the plane of the outer edge, if there is one.
  void fat_leaf(const Contraction& step) {
    const V a = step.outer.empty() ? V{T(0), T(0), T(1)} : -outer_direction(step, 0);
    const V b = perpendicular(a);
    const T rise = T(T(1) / square_root(T(3)));
    const auto at = [&](int x, int z) { return T(T(1) / 8) * (T(x) * b + T(T(z) * rise) * a); };
    set_member(step, 0, at(0, 0));
    set_member(step, 1, at(-2, 6));
    set_member(step, 2, at(2, 6));
    set_member(step, 3, at(0, 6));
    set_member(step, 4, at(0, 8));
    for (const int side : {-1, 1}) {
      const std::size_t tip = side < 0 ? 1 : 2;
      set_inner(step, 0, tip, {at(3 * side, 3), at(3 * side, 5)});
      set_inner(step, tip, 3, {at(side, 5)});
      set_inner(step, tip, 4, {at(2 * side, 8), at(side, 9)});
    }
    set_inner(step, 3, 4, {});
    child_radius_ = radius_ / 32;
  }

  const ContractedGraph& graph_;
  NodePoints<T>& points_;
  std::vector<std::array<V, 2>> directions_;  // unit, of an edge at its slots, into the edge
  V at_{};                                    // of the node at hand
  double radius_ = 0;                         // of the room that is filled
  bool is_straight_ = false;
  double child_radius_ = 0;
  std::array<V, 5> offsets_{};  // of the members, in units of the radius
};

}  // namespace ar3d::two_bend_paper
