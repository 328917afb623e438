#pragma once

#include <functional>
#include <span>
#include <vector>

#include "ar3d/algorithms/routed/box.h"
#include "ar3d/algorithms/routed/search.h"
#include "ar3d/model/graph.h"

namespace ar3d::routed {

/// Vertices in a box: a point of the class for each, no point twice, and a frame (its number).
struct Layout {
  Limits limits;
  std::vector<Spot> at;
  std::vector<std::uint8_t> frame;
};

/// A layout with a route for every edge, from its smaller end on.
struct Routing {
  Layout layout;
  std::vector<Route> routes;
};

/// Edges that negotiate for the points of a box. The result depends on the graph, the layout and the
/// seed alone, not on the number of threads.
class Negotiation {
 public:
  /// @param given  with all routes, or with none.
  Negotiation(const Graph& graph, const PointClass& points, int bends, Routing given,
              std::uint64_t seed);

  /// Routes edges anew, and moves vertices, until no point is shared.
  /// @param patience  rounds without gain after which it ends, from the 13th on.
  /// @param most_searches  no round begins after so many.
  /// @return the number of edges in conflict that are left; 0: the routing is a drawing.
  std::size_t run(int patience, std::uint64_t most_searches);

  const Routing& routing() const { return now_; }
  /// Searches made so far.
  std::uint64_t searches() const { return searches_; }

 private:
  Spot start(EdgeId e) const { return now_.layout.at[graph_.edge(e).u]; }
  End end(Vertex v) const { return {now_.layout.at[v], points_.frames()[now_.layout.frame[v]]}; }
  void put(EdgeId e) { box_.put(start(e), now_.routes[e]); }
  void take(EdgeId e) { box_.take(start(e), now_.routes[e]); }
  int cost_of(EdgeId e) const { return box_.cost_of(start(e), now_.routes[e]); }
  bool is_in_conflict(EdgeId e) const { return box_.is_shared(start(e), now_.routes[e]); }
  /// 1 if a route may be changed for one that costs the same.
  int tolerance() const { return conflicts_ * 4 < graph_.num_edges() ? 1 : 0; }
  std::vector<EdgeId> conflicts();

  void route_all(std::vector<EdgeId>& edges);
  void route_group(std::span<const EdgeId> edges);
  void move_vertices(const std::vector<EdgeId>& edges);
  void move_group(std::span<Trial> trials);
  void search_trial(Trial& trial, RouteSearch& search);
  bool settle(const Trial& trial);
  void place(Vertex v, Spot at, std::size_t frame);
  int price_edges(Vertex v);
  void raise_prices(int round);
  void search_side_by_side(std::size_t count,
                           const std::function<void(RouteSearch&, std::size_t)>& search);

  const Graph& graph_;
  const PointClass& points_;
  std::vector<std::size_t> frames_;  // that a vertex may take
  Routing now_;
  CostBox box_;
  std::uint64_t seed_;
  RandomStream random_;
  std::vector<RouteSearch> searchers_;  // one for each thread
  std::size_t conflicts_;
  int price_ = 48;    // in sixteenths
  int increase_ = 8;  // of the history, in quarters
  std::uint64_t groups_ = 0;
  std::uint64_t searches_ = 0;
};

}  // namespace ar3d::routed
