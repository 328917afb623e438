#pragma once

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include "ar3d/algorithms/two_bend_paper/general_position.h"
#include "ar3d/algorithms/two_bend_paper/growth.h"
#include "ar3d/model/vector3.h"

namespace ar3d::two_bend_paper {

#ifdef __FAST_MATH__
#error \
    "the drawings of two-bend-paper tell what rounding does: they cannot be made with -ffast-math"
#endif
static_assert(FLT_EVAL_METHOD == 0, "every operation rounds to its own type (no x87 arithmetic)");

template <int bits>
using BinaryFloat = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<bits, boost::multiprecision::digit_base_2, void,
                                         std::int16_t, -16382, 16383>,
    boost::multiprecision::et_off>;

/// A significand of 64 bits: long double where it has them (x86-64), else Boost's type, whose
/// operations and square root round alike.
using Extended = std::conditional_t<LDBL_MANT_DIG == 64, long double, BinaryFloat<64>>;

/// A significand of 113 bits; arithmetic by the compiler's support library.
#ifdef __SIZEOF_FLOAT128__
__extension__ using Binary128 = __float128;
#else
static_assert(LDBL_MANT_DIG == 113);
using Binary128 = long double;
#endif

/// A significand of 237 bits: what the other types are measured against.
using Reference = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<237, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;

/// The square root, rounded as the type's own functions do; that of Binary128 to within a unit in
/// the last place: Newton's method from 64 bits, twice.
template <class T>
T square_root(const T& value) {
  if constexpr (std::is_same_v<T, Binary128>) {
    if (!(value > 0)) return value;
    T root = static_cast<T>(square_root(static_cast<Extended>(value)));
    for (int i = 0; i < 2; ++i) root = (root + value / root) / 2;
    return root;
  } else if constexpr (std::is_floating_point_v<T>) {
    return std::sqrt(value);
  } else {
    return boost::multiprecision::sqrt(value);
  }
}

template <class T>
Vector3<T> unit(const Vector3<T>& a) {
  const T length = square_root(dot(a, a));
  return {T(a.x / length), T(a.y / length), T(a.z / length)};
}

/// NodePoints of all nodes that are placed so far, and the bends of every edge from its slot 0 to
/// its slot 1: at most two.
template <class T>
struct NodePoints {
  std::vector<Vector3<T>> of_node;
  std::vector<std::vector<Vector3<T>>> bends;
};

/// Draws placed components in arithmetic of type T, one slab above the other (Steps P.2 and P.5 to
/// P.8). Nothing is decided here: every point is a function of the choices. O(n + m) operations.
template <class T>
class Stacking {
 public:
  Stacking(const ContractedGraph& graph, std::size_t num_edges) : graph_(graph) {
    points_.of_node.resize(graph.num_nodes());
    points_.bends.resize(num_edges);
    feet_.resize(graph.num_nodes());
    rise_ = T(1) / square_root(T(3));
  }

  void draw(const Component& component) {
    if (component.k4) return draw_k4(*component.k4, component.left);
    top_ = T(-1);
    for (const Step& step : component.steps) draw_step(step);
  }

  NodePoints<T> take() { return std::move(points_); }

 private:
  void draw_step(const Step& step) {
    switch (step.kind) {
      case StepKind::line:
        feet_[step.node] = {T(step.foot.x), T(step.foot.y)};
        return end_on_ray(step.node);
      case StepKind::pass:
        feet_[step.node] = feet_[step.below[0].to];
        return end_on_ray(step.node);
      case StepKind::merge:
        return draw_merge(step);
      case StepKind::triskelion:
        return draw_triskelion(step);
      case StepKind::cycle:
        return draw_cycle(step, step.sides);
    }
  }

  static Vector3<T> over(const Point2<T>& foot, const T& z) { return {foot.x, foot.y, z}; }

  static T distance(const Point2<T>& p, const Point2<T>& q) {
    const T x = T(q.x - p.x), y = T(q.y - p.y);
    return square_root(T(x * x + y * y));
  }

  /// Sets the bends of an edge, given from the node on.
  void set_bends(EdgeId edge, Node from, std::vector<Vector3<T>> bends) {
    if (graph_.ends[edge][0] != from) std::reverse(bends.begin(), bends.end());
    points_.bends[edge] = std::move(bends);
  }

  void end_on_ray(Node node) {
    top_ = T(top_ + 1);
    points_.of_node[node] = over(feet_[node], top_);
  }

  void draw_merge(const Step& step) {
    const Point2<T> p = feet_[step.below[0].to], q = feet_[step.below[1].to];
    const T share = T(step.share), rest = T(T(1) - share);
    const T rise = T(rise_ * distance(p, q));
    const T z = T(top_ + 1 + rise * std::max(share, rest));
    feet_[step.node] = {T(p.x + share * (q.x - p.x)), T(p.y + share * (q.y - p.y))};
    points_.of_node[step.node] = over(feet_[step.node], z);
    set_bends(step.below[0].edge, step.node, {over(p, T(z - share * rise))});
    set_bends(step.below[1].edge, step.node, {over(q, T(z - rest * rise))});
    top_ = z;
  }

  void draw_triskelion(const Step& step) {
    const auto foot = [&](std::size_t i) { return feet_[step.below[step.order[i]].to]; };
    const Point2<T> t = foot(0), u = foot(1), w = foot(2);
    const T base = distance(t, u);
    const Vector3<T> e{T((u.x - t.x) / base), T((u.y - t.y) / base), T(0)};
    const Vector3<T> to_w{T(w.x - t.x), T(w.y - t.y), T(0)};
    const Vector3<T> n =
        step.w_is_left ? Vector3<T>{T(-e.y), e.x, T(0)} : Vector3<T>{e.y, T(-e.x), T(0)};
    const T at = T(dot(e, to_w) + T(step.slide) * dot(n, to_w));
    const T r = T(step.radius), half = T(r / 2), wide = T(square_root(T(3)) * half);
    const Vector3<T> middle = Vector3<T>{t.x, t.y, T(0)} + T(at) * e;
    const std::array<Vector3<T>, 3> arm{middle - wide * e, middle + wide * e,
                                        middle + T(half + r) * n};
    const std::array<Point2<T>, 3> feet{t, u, w};
    std::array<T, 3> run;
    for (std::size_t i = 0; i < 3; ++i) run[i] = distance({arm[i].x, arm[i].y}, feet[i]);
    const T z = T(top_ + 1 + rise_ * std::max({run[0], run[1], run[2]}));
    const Vector3<T> up{T(0), T(0), z};
    points_.of_node[step.node] = middle + half * n + up;
    for (std::size_t i = 0; i < 3; ++i) {
      set_bends(step.below[step.order[i]].edge, step.node,
                {arm[i] + up, over(feet[i], T(z - rise_ * run[i]))});
    }
    top_ = z;
  }

  void draw_cycle(const Step& step, const std::vector<Side>& sides) {
    const std::size_t length = step.cycle.size();
    double longest = 0;
    for (std::size_t i = 0; i < length; ++i) {
      feet_[step.cycle[i].node] = {T(sides[i].middle.x), T(sides[i].middle.y)};
      longest = std::max(longest, sides[i].half);
      if (step.cycle[i].is_below) draw_transverse(step.cycle[i]);
    }
    const T plane = T(top_ + 1 + T(longest) * rise_);
    for (std::size_t i = 0; i < length; ++i) {
      const CycleVertex& vertex = step.cycle[i];
      const T height = T(T(sides[i].half) * rise_);
      points_.of_node[vertex.node] =
          over(feet_[vertex.node], vertex.is_below ? T(plane - height) : T(plane + height));
      set_bends(vertex.to_next, vertex.node,
                {corner(sides[i], 1, plane), corner(sides[(i + 1) % length], -1, plane)});
    }
    top_ = T(plane + T(longest) * rise_);
  }

  static Vector3<T> corner(const Side& side, int sign, const T& z) {
    const T half = T(T(sign) * T(side.half));
    return {T(T(side.middle.x) + half * T(side.along.x)),
            T(T(side.middle.y) + half * T(side.along.y)), z};
  }

  /// The edge from a ray to below a vertex of a cycle, in a slab of its own.
  void draw_transverse(const CycleVertex& vertex) {
    const Point2<T> from = feet_[vertex.third->to], to = feet_[vertex.node];
    const T low = T(top_ + 1), high = T(low + rise_ * distance(from, to));
    set_bends(vertex.third->edge, vertex.third->to, {over(from, low), over(to, high)});
    top_ = high;
  }

  void draw_k4(const std::array<Node, 4>& nodes, double left) {
    // x, y, and z in units of 1 / sqrt(3); vertices, then the bends of 01, 02, 03, 12, 23, 31.
    static constexpr int kVertices[4][3] = {{5, 6, 9}, {5, 2, 17}, {9, 2, 5}, {1, 2, 5}};
    static constexpr int kEnds[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {2, 3}, {3, 1}};
    static constexpr int kBends[6][2][3] = {{{5, 6, 17}, {5, 4, 19}}, {{9, 6, 5}, {10, 4, 4}},
                                            {{1, 6, 5}, {0, 4, 4}},   {{9, 0, 15}, {10, 0, 12}},
                                            {{6, 0, 0}, {4, 0, 0}},   {{0, 0, 12}, {1, 0, 15}}};
    const auto point = [&](const int(&p)[3]) {
      return Vector3<T>{T(T(left) + T(p[0])), T(p[1]), T(T(p[2]) * rise_)};
    };
    for (std::size_t i = 0; i < 4; ++i) points_.of_node[nodes[i]] = point(kVertices[i]);
    for (std::size_t i = 0; i < 6; ++i) {
      const Node from = nodes[static_cast<std::size_t>(kEnds[i][0])];
      const Node to = nodes[static_cast<std::size_t>(kEnds[i][1])];
      for (const HalfEdge incidence : graph_.stars[from]) {
        if (incidence.to != to) continue;
        set_bends(incidence.edge, from, {point(kBends[i][0]), point(kBends[i][1])});
      }
    }
  }

  const ContractedGraph& graph_;
  NodePoints<T> points_;
  std::vector<Point2<T>> feet_;  // by node
  T rise_;                       // over a distance of 1: 1 / sqrt(3), 30 degrees
  T top_{};                      // nothing but rays is higher
};

/// The drawing of the contracted graph.
template <class T>
NodePoints<T> stack(const ContractedGraph& graph, const std::vector<Component>& components,
                    std::size_t num_edges) {
  Stacking<T> stacking(graph, num_edges);
  for (const Component& component : components) stacking.draw(component);
  return stacking.take();
}

}  // namespace ar3d::two_bend_paper
