#pragma once

#include <boost/container/static_vector.hpp>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <set>
#include <vector>

#include "ar3d/algorithms/grid_paper/grid_paper.h"
#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"
#include "ar3d/model/vector3.h"

namespace ar3d::grid_paper {

/// Holds what one stage adds to the set S of vertices that are drawn, in this order. Then every
/// vertex outside has two neighbours outside, hence at most one in S.
struct GrowthStage {
  std::vector<Vertex> cycle;  ///< without chord, in cyclic order; empty in the first stage
  std::vector<Vertex>
      between;  ///< they have a neighbour on the cycle and one in the old S; ascending
  std::vector<Vertex> closure;  ///< those that wait (Repair G.12), then first in, first out
};

/// Steps G.1 and G.2: the vertices, ascending, of every connected component, and the stages that
/// they are in; components in the order of their least vertices. Cost: that of the cycles, and
/// O(n log n). @param any_cycle  of the options.
std::vector<std::pair<std::vector<Vertex>, std::vector<GrowthStage>>> grow(
    const Graph& graph, bool any_cycle, const RepairSwitches& repairs);

/// A point of a layer. h = 2y + x is twice the distance to the right in the true picture: e_Y is
/// (2, 0), e_X is (1, 1), e_X - e_Y is (-1, 1).
struct LayerPoint {
  std::int64_t h = 0;
  std::int64_t x = 0;
  std::int64_t y() const { return (h - x) / 2; }
};

/// A cycle drawn in one layer.
struct FlatCycle {
  std::vector<LayerPoint> at;                  ///< the first at h = 0
  std::vector<std::vector<LayerPoint>> bends;  ///< of edge i from vertex i to vertex i + 1; of the
                                               ///< last one, which closes the cycle, from vertex 0
  std::int64_t spread = 0;                     ///< vertices that are not at the nearest place
};

/// Steps G.4 and G.5 (the paper's lemma "flat single cycle"): every vertex i at x[i], with its leg
/// from (h, x) to (h + 2, x) free.
/// @param x  at least three even numbers, which may repeat; if their number is odd, x[0] < x[1].
/// @param least_run  half the least length of a run: 2 for K4, else 1.
/// @param all_spread  Repair G.8; without it only the lengths of runs keep vertices apart.
/// Cost: k vertices are compared with the few before them whose pieces they can reach; O(k^2 log k)
/// at worst, O(k) with Spread::columns.
FlatCycle draw_flat_cycle(const std::vector<std::int64_t>& x, Spread spread, std::int64_t least_run,
                          bool all_spread);

/// x e_X + y e_Y + z e_Z with e_X = (0,1,1), e_Y = (1,1,0), e_Z = (1,0,1): x a vertical plane, z a
/// horizontal one, y to the right.
using SkewPoint = Vector3<std::int64_t>;
inline Point cartesian(const SkewPoint& p) { return {p.y + p.z, p.x + p.y, p.x + p.z}; }

/// Holds how often the cases of the construction occur; counters of the drawing.
struct CaseCensus {
  std::int64_t cycles = 0, on_cycles = 0, spread = 0, connections = 0, middles = 0, moved = 0,
               same_cycle = 0, three_of_cycle = 0, past_layer = 0, k4s = 0, merges = 0, threes = 0,
               ways_down = 0;
};

/// The drawing as it grows, and what the invariant of docs/theorem3-paper.md speaks of.
class DrawingBuilder {
 public:
  DrawingBuilder(const Graph& graph, const Options& options, const RepairSwitches& repairs);

  /// The empty state.
  void begin_component();
  /// Moves the component right of those before it (Repair G.2).
  void end_component(const std::vector<Vertex>& vertices);
  /// Steps G.3 to G.8: the cycle and all its connections to what is drawn.
  void add_cycle(const GrowthStage& stage);
  /// Steps G.9 to G.13: a vertex of a closure.
  void add_vertex(Vertex u);

  const CaseCensus& census() const { return census_; }
  /// All points, after the last component.
  Drawing finish();

 private:
  enum class VertexKind : std::uint8_t { outside, tree, cycle };
  using EdgeBends = boost::container::static_vector<SkewPoint, 3>;
  static constexpr std::int64_t kNoPlane = -1;

  bool is_drawn(Vertex v) const { return kind_[v] != VertexKind::outside; }
  bool is_tree(Vertex v) const { return kind_[v] == VertexKind::tree; }
  bool in_layer(Vertex v) const { return layer_of_[v] == layer_; }
  bool in_gap(Vertex v) const { return is_tree(v) && at_[v].z > old_top_ && at_[v].z < layer_z_; }
  void place(Vertex v, SkewPoint at, VertexKind kind);
  /// The bends of the edge, in order from `from`.
  void route(Vertex from, Vertex to, std::initializer_list<SkewPoint> bends);

  /// The neighbour of a vertex of the layer that is not in it; v itself if there is none.
  Vertex third_neighbour(Vertex v) const;
  /// The neighbour of u that was drawn before the layer.
  std::optional<Vertex> old_neighbour(Vertex u) const;

  void choose_planes(const std::vector<Vertex>& cycle, bool is_k4);
  void turn(std::vector<Vertex>& cycle) const;
  void lay(const std::vector<Vertex>& cycle, bool is_k4);
  std::int64_t height_of_layer(const std::vector<Vertex>& cycle) const;
  std::int64_t way_back(Vertex v, Vertex w) const;
  void connect(Vertex v, Vertex w);

  void add_between(const GrowthStage& stage);
  void add_middle(Vertex u, Vertex v, Vertex w);
  void add_past_layer(Vertex u, Vertex v, Vertex other, Vertex w);
  void clear_front(const std::vector<Vertex>& closure);

  std::int64_t go_up(Vertex v, std::int64_t front) const;
  void add_two_of_cycle(Vertex u, Vertex v, Vertex w);
  void add_k4_top(Vertex u, std::vector<Vertex> below);
  std::int64_t beyond_switch(Vertex p, std::int64_t x, std::int64_t front) const;
  void switch_to(Vertex p, Vertex u, std::int64_t front);
  void add_merge(Vertex u, Vertex p, Vertex q);
  void add_three(Vertex u, const std::vector<Vertex>& below);
  void turn_back(Vertex p, Vertex u);
  void arrive(Vertex q, Vertex u, std::int64_t side, std::int64_t front);

  const Graph& graph_;
  Options options_;
  RepairSwitches repairs_;
  std::vector<VertexKind> kind_;
  std::vector<SkewPoint> at_;  // x is kNoPlane before a vertex has its plane
  std::vector<EdgeBends> bends_;
  std::vector<std::uint32_t> layer_of_;  // 0 for vertices of no cycle
  CaseCensus census_;

  // Of the component: the next vertical plane, the height of the last vertex, the y of the
  // rightmost point and that of the leftmost one.
  std::int64_t next_x_ = 0, top_ = 0, front_ = 0, left_ = 0;
  std::int64_t end_x_ = 0;  // right of all components before
  // Of the layer of this stage: its number, height, largest y (legs included), top_ and front_
  // before it, and the heights in the gap below it that vertices have.
  std::uint32_t layer_ = 1;
  std::int64_t layer_z_ = 0, layer_right_ = 0, old_top_ = 0, old_front_ = 0;
  std::set<std::int64_t> gap_heights_;
};

}  // namespace ar3d::grid_paper
