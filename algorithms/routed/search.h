#pragma once

#include <span>
#include <vector>

#include "ar3d/algorithms/routed/fields.h"
#include "ar3d/base/random.h"
#include "ar3d/model/graph.h"

namespace ar3d::routed {

/// A vertex that may move: where to, and the routes to it there.
struct Trial {
  Vertex vertex = 0;
  int limit = 0;  ///< what it costs now
  bool is_found = false;
  std::uint64_t searches = 0;
  Spot at;
  std::size_t frame = 0;
  /// From its neighbours; none if a cheapest one passes a point twice.
  std::array<Route, 4> routes;
};

/// Searches for the cheapest routes, exactly; one for each thread, for its tables.
class RouteSearch {
 public:
  /// @param threads  that share the fields of a vertex, outside of parallel regions.
  RouteSearch(const PointClass& points, int bends, std::uint32_t threads = 1)
      : points_(points), bends_(bends), threads_(threads), fields_(4, CostFields(points)) {}

  /// Finds the cheapest route below `limit`. Steps away from the ends are limited, further if
  /// `is_wide`; what costs less than 4 times that limit is found for certain.
  /// @return its cost and the route; `limit` and none if there is none that passes no point twice.
  /// Cost: O(bends x directions x points of a window around the ends), 8 points at a time.
  int find(const CostBox& box, const End& u, const End& v, int limit, bool is_wide,
           RandomStream& random, Route& found);

  /// Finds the point at most `radius` from `now`, the frame and the arms with which routes from the
  /// neighbours and the vertex cost least in sum, each priced alone; one of several at random.
  /// @param frames  that are allowed, as numbers.
  /// @return the sum, and the place; `limit` if there is none below.
  int find_place(const CostBox& box, Spot now, std::span<const End> neighbours,
                 std::span<const std::size_t> frames, int radius, int limit, RandomStream& random,
                 Trial& found);

 private:
  using Cost = CostFields::Cost;
  static constexpr Cost kInfinite = CostFields::kInfinite;
  /// The last turn of a route: to direction `into`, `left` steps before its end.
  struct LastTurn {
    int layer = -1;  // bends before it; -1: a straight route
    int direction = 0;
    int into = 0;
    int left = 0;
    friend bool operator==(const LastTurn&, const LastTurn&) = default;
  };

  int steps_between(Spot a, Spot b) const;
  int best_end(const End& v, int limit, std::span<const LastTurn> excluded, RandomStream& random,
               LastTurn& best) const;
  Route trace(const CostFields& fields, Spot p, int layer, int d, RandomStream& random) const;
  Route route_to(const CostFields& fields, Spot at, int d, RandomStream& random);
  int find_in_window(const End& v, int limit, RandomStream& random, Route& found);
  bool meets_itself(const CostFields& fields, const Route& route);
  void list_places(const CostBox& box, Spot now, int radius);
  void note_arrivals(std::size_t neighbour, Directions arms);
  int cheapest_arms(std::size_t i, std::size_t neighbours, std::size_t frame, int limit,
                    std::array<std::uint8_t, 4>& arms) const;

  const PointClass& points_;
  int bends_;
  std::uint32_t threads_;
  std::vector<CostFields> fields_;  // of the first end, or of each neighbour
  std::vector<std::size_t> passed_;
  // The places of a vertex: rows of points, what they cost routes (-1: a vertex is there), a bound
  // from below for the vertex there; least costs of arriving, by neighbour and arm.
  std::vector<Spot> place_rows_;
  std::size_t place_lanes_ = 0;
  std::vector<int> place_costs_;
  std::vector<int> bounds_;
  std::array<std::array<std::vector<Cost>, kMostDirections>, 4> arrivals_;
};

}  // namespace ar3d::routed
