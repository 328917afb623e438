#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "ar3d/algorithms/two_bend/local_graph.h"
#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"

namespace ar3d::two_bend {

/// At most two bends per edge, 32 bytes per edge. Two bends are kept in the order from the edge's
/// lower end (is_below) to the upper one: so nothing needs the order in which the input names the
/// ends.
class PackedBends final : public BendSource {
 public:
  /// The bends of an edge are undefined before they are set.
  explicit PackedBends(std::size_t num_edges) : places_(num_edges) {}
  /// x and y are below 2^31 in absolute value; at most two bends, from the lower end to the upper.
  void set(EdgeId e, std::span<const Point> bends);
  [[gnu::always_inline]] void ask_for(EdgeId e) const { __builtin_prefetch(places_.data() + e, 1); }
  void append_bends(EdgeId e, Edge ends, Point at_u, Point at_v,
                    std::vector<Point>& out) const override;

 private:
  static constexpr std::int64_t kNoBend = std::numeric_limits<std::int64_t>::min();
  struct alignas(32) Places {
    std::array<std::int32_t, 4> xy;
    std::array<std::int64_t, 2> z;
  };
  UnwrittenVector<Places> places_;
};

/// The order by z, then y, then x.
inline bool is_below(const Point& p, const Point& q) {
  return std::tie(p.z, p.y, p.x) < std::tie(q.z, q.y, q.x);
}

/// Collects a drawing component by component, stacked in z.
class Output {
 public:
  explicit Output(const Graph& graph) : graph_(graph) {}

  /// Returns where the next component begins: all of it is drawn at z >= base_z().
  std::int64_t base_z() const { return base_z_; }
  /// Before a component is written, and not earlier, since what is written is as large as all that
  /// it is computed from: room for the whole drawing.
  /// @param vertices  of the component. @param top  not less than its largest z.
  void make_room(std::size_t vertices, std::int64_t top);
  /// Ends a component whose largest z is `top`. @throws InternalError if it passes kMaxCoordinate.
  void end_component(std::int64_t top);

  void set_vertex(Vertex v, Point p) {
    if (vertices_) return vertices_->set(v, p);
    points_[v] = p;
    largest_ = std::max({largest_, p.x, p.y, p.z});
  }
  /// @param bends  two of them from the lower end (is_below) to the upper one.
  void set_bends(EdgeId e, std::span<const Point> bends) { bends_->set(e, bends); }

  /// Ask memory for what is soon to be set.
  [[gnu::always_inline]] void ask_for_vertex(Vertex v) const {
    if (vertices_) {
      vertices_->prefetch(v);
    } else {
      __builtin_prefetch(points_.data() + v, 1);
    }
  }
  [[gnu::always_inline]] void ask_for_bends(EdgeId e) const { bends_->ask_for(e); }

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
