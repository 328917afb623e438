#pragma once

#include <cstddef>

#include "ar3d/algorithms/routed/steps.h"

namespace ar3d::routed {

/// The points of a class in a box, with what it costs a route to pass them: 4 for the step, the
/// point's history, and the price for each route that passes it already. A vertex there counts as two
/// routes, so routes and vertices, too, negotiate. 5 bytes a point. A point with 127 routes is
/// blocked.
class CostBox {
 public:
  static constexpr int kStep = 4;
  static constexpr int kBlocked = 16383;

  CostBox(const PointClass& points, const Limits& limits);
  /// The bytes that such a box takes.
  static std::int64_t bytes(const PointClass& points, const Limits& limits);

  const Limits& limits() const { return limits_; }
  bool contains(Spot p) const { return limits_.contain(p); }
  /// Index of a point of the class in the box.
  int index(Spot p) const {
    return is_body_ ? ((p.x * rows_ + (p.y >> 1)) * layers_ + (p.z >> 1)) - origin_
                    : ((p.x * rows_ + p.y) * layers_ + (p.z >> 1)) - origin_;
  }
  static int parity(Spot p) { return p.z & 1; }
  /// What a step in direction d adds to the index of a point, by the point's parity.
  int stride(int parity, int d) const {
    return strides_[static_cast<std::size_t>(parity)][static_cast<std::size_t>(d)];
  }
  /// 1 if a step in direction d changes the parity.
  int flip(int d) const { return flips_[static_cast<std::size_t>(d)]; }

  /// Cost of passing point i above that of the step.
  int cost(int i) const { return costs_[static_cast<std::size_t>(i)]; }
  int uses(int i) const { return uses_[static_cast<std::size_t>(i)] & kMostUses; }
  bool has_vertex(int i) const { return (uses_[static_cast<std::size_t>(i)] & kVertex) != 0; }

  void put_vertex(int i);
  void take_vertex(int i) { set_uses(i, uses(i)); }
  /// Cost of a vertex at point i, beside the routes that pass it.
  int cost_of_vertex(int i) const {
    return history_[static_cast<std::size_t>(i)] + kVertexUses * price_ * uses(i);
  }
  /// Adds a route from `from`, or takes it away; its points have below 127 uses or had it before.
  void put(Spot from, const Route& route);
  void take(Spot from, const Route& route);

  /// Calls visit(i) for the points between the ends of a route.
  template <class Visit>
  void walk(Spot from, const Route& route, const Visit& visit) const {
    int i = index(from);
    int side = parity(from);
    for (std::size_t s = 0; s < route.segments; ++s) {
      const int d = route.direction[s];
      const int last = route.length[s] - (s + 1 == route.segments ? 1 : 0);
      for (int t = 0; t < last; ++t) {
        i += stride(side, d);
        side ^= flip(d);
        visit(i);
      }
    }
  }
  /// Returns what a route costs that is not in the box; kNoRoute if a point is blocked or there is
  /// no route.
  static constexpr int kNoRoute = 1 << 27;
  int cost_of(Spot from, const Route& route) const;
  bool is_shared(Spot from, const Route& route) const;

  /// Adds to the history of every point with two routes or more.
  void remember_shared(int increase);
  /// Sets the price; the points of vertices and routes then need refresh().
  void set_price(int price) { price_ = price; }
  void refresh(int i) { set_cost(static_cast<std::size_t>(i)); }
  void refresh(Spot from, const Route& route);

 private:
  static constexpr int kBytesPerPoint = 5;
  static constexpr int kVertex = 0x80;
  static constexpr int kMostUses = 0x7f;
  static constexpr int kVertexUses = 2;
  static constexpr int kMostHistory = 8000;
  void set_uses(int i, int uses);
  void set_cost(std::size_t i);

  bool is_body_;
  Limits limits_;
  int rows_;
  int layers_;
  int origin_ = 0;
  int price_ = 4;
  std::array<std::array<int, kMostDirections>, 2> strides_{};
  std::array<int, kMostDirections> flips_{};
  std::vector<std::uint16_t> costs_;
  std::vector<std::uint16_t> history_;
  std::vector<std::uint8_t> uses_;
  std::vector<int> shared_;  // points that a route shares; some have lost it again
};

}  // namespace ar3d::routed
