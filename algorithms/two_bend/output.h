#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "ar3d/algorithms/two_bend/local_graph.h"
#include "ar3d/base/error.h"
#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"

namespace ar3d::two_bend {

/// The bends of a long edge, at most two in all. Upwards, first those drawn in the slab of the
/// lower end, then the vertical piece with the PASS vertices, then those drawn in the slab of the
/// upper end. 32 bytes: the numbers of bends are kept in the last two bits of their heights.
class alignas(32) LongBends {
 public:
  std::size_t lower_count() const { return static_cast<std::size_t>(coded_[0] & 3); }
  std::size_t upper_count() const { return static_cast<std::size_t>(coded_[1] & 3); }
  std::size_t count() const { return lower_count() + upper_count(); }
  Point operator[](std::size_t i) const { return {xy_[2 * i], xy_[2 * i + 1], coded_[i] >> 2}; }
  /// x and y are below 2^31 in absolute value, z below kMaxCoordinate.
  void add_lower(const Point& bend) {  ///< before any upper one, below any lower one
    expect(lower_count() < 2 && upper_count() == 0,
           "an edge has at most two bends, lower ones first");
    if (lower_count() == 1) set(1, (*this)[0]);
    set(0, bend);
    ++coded_[0];
  }
  void add_upper(const Point& bend) {  ///< in upward order
    expect(count() < 2, "an edge has at most two bends");
    set(count(), bend);
    ++coded_[1];
  }

  void set(std::size_t i, const Point& bend) {  ///< in place of the i-th bend
    expect(std::in_range<std::int32_t>(bend.x) && std::in_range<std::int32_t>(bend.y),
           "rows and columns fit 32 bits");
    expect(-kMaxCoordinate < bend.z && bend.z < kMaxCoordinate, "a bend's height fits 62 bits");
    xy_[2 * i] = static_cast<std::int32_t>(bend.x);
    xy_[2 * i + 1] = static_cast<std::int32_t>(bend.y);
    coded_[i] = bend.z * 4 + (coded_[i] & 3);
  }

 private:
  std::array<std::int32_t, 4> xy_{};
  std::array<std::int64_t, 2> coded_{};  // 4 z + number of lower bends, 4 z + number of upper ones
};

/// The bends of all edges. Two bends are kept in the order from the edge's lower end (is_below) to
/// the upper one: so nothing needs the order in which the input names the ends.
struct PackedBends final : BendSource {
  /// The bends of an edge are undefined before they are set.
  explicit PackedBends(std::size_t num_edges) : of_edge(num_edges) {}
  void append_bends(EdgeId e, Edge ends, Point at_u, Point at_v,
                    std::vector<Point>& out) const override;

  UnwrittenVector<LongBends> of_edge;
};

/// The order by z, then y, then x.
inline bool is_below(const Point& p, const Point& q) {
  return std::tie(p.z, p.y, p.x) < std::tie(q.z, q.y, q.x);
}

/// Collects a drawing component by component, stacked in z.
class Output {
 public:
  explicit Output(const Graph& graph)
      : graph_(graph), bends_(std::make_shared<PackedBends>(graph.num_edges())) {}

  /// Returns where the next component begins: all of it is drawn at z >= base_z().
  std::int64_t base_z() const { return base_z_; }
  /// Before a component's vertices are written, and not earlier, since memory that is taken later
  /// is needed for a shorter time: room for all vertices.
  /// @param vertices  of the component. @param top  not less than its largest z.
  void make_room(std::size_t vertices, std::int64_t top);
  /// Ends a component whose largest z is `top`. @throws InternalError if it passes kMaxCoordinate.
  void end_component(std::int64_t top);

  void set_vertex(Vertex v, Point p) {
    if (vertices_) return vertices_->set(v, p);
    points_[v] = p;
    largest_ = std::max({largest_, p.x, p.y, p.z});
  }
  /// @param bends  at most two, from the lower end (is_below) to the upper one.
  void set_bends(EdgeId e, std::span<const Point> bends);
  /// The bends of an edge: until they are set, what draw_slabs keeps there for a long edge whose
  /// first edge it is, z relative to the end in whose slab they are.
  LongBends& bends(EdgeId e) { return bends_->of_edge[e]; }

  /// Prefetch what is soon to be set.
  [[gnu::always_inline]] void prefetch_vertex(Vertex v) const {
    if (vertices_) {
      vertices_->prefetch(v);
    } else {
      __builtin_prefetch(points_.data() + v, 1);
    }
  }
  [[gnu::always_inline]] void prefetch_bends(EdgeId e) const {
    __builtin_prefetch(bends_->of_edge.data() + e, 1);
  }

  Drawing finish();

 private:
  const Graph& graph_;
  UnwrittenVector<Point> points_;
  std::optional<Coordinates>
      vertices_;  // at once if a single component needs 64 bits, else made of points_
  std::shared_ptr<PackedBends> bends_;
  std::int64_t base_z_ = 0;
  std::int64_t largest_ = 0;  // coordinate of a vertex in points_
};

}  // namespace ar3d::two_bend
