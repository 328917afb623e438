#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"

namespace ar3d::two_bend {

/// At most two bends an edge, 33 bytes an edge.
class PackedBends final : public BendSource {
 public:
  explicit PackedBends(std::size_t num_edges) : counts_(num_edges, 0), places_(num_edges) {}
  /// x and y are below 2^31 in absolute value; at most two bends, in the order of the input edge's
  /// ends.
  void set(EdgeId e, std::span<const Point> bends);
  void append_bends(EdgeId e, Edge ends, Point at_u, Point at_v,
                    std::vector<Point>& out) const override;

 private:
  struct Places {
    std::array<std::int32_t, 4> xy{};
    std::array<std::int64_t, 2> z{};
  };
  std::vector<std::uint8_t> counts_;
  std::vector<Places> places_;
};

/// Collects a drawing component by component, stacked in z.
class Output {
 public:
  explicit Output(const Graph& graph);

  /// Where the next component begins: all of it is drawn at z >= base_z().
  std::int64_t base_z() const { return base_z_; }
  /// Ends a component whose largest z is `top`. @throws InternalError if it passes kMaxCoordinate.
  void end_component(std::int64_t top);

  void set_vertex(Vertex v, Point p);
  /// @param from  the end of e (an input vertex) at which `bends` begin.
  void set_bends(EdgeId e, Vertex from, std::span<const Point> bends);

  Drawing finish();

 private:
  const Graph& graph_;
  std::vector<Point> points_;
  std::shared_ptr<PackedBends> bends_;
  std::int64_t base_z_ = 0;
  std::int64_t largest_ = 0;  // coordinate of a vertex
};

}  // namespace ar3d::two_bend
