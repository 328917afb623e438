#pragma once

#include <vector>

#include "ar3d/algorithms/routed/box.h"
#include "ar3d/algorithms/routed/words.h"
#include "ar3d/base/random.h"

namespace ar3d::routed {

/// Says which lengths of chosen segments are tried: all of 1 ... near where two or three are
/// chosen, and random longer ones. A single chosen segment takes every length.
struct Lengths {
  int near_of_three = 2;
  int near_of_two = 10;
  int random = 0;  ///< longer ones for three chosen segments; four times as many for two
};

/// A vertex as an end of a route.
struct End {
  Spot at;
  std::size_t frame = 0;
  Directions arms = 0;  ///< those of the frame that the route may use
};

/// Searches for cheap routes; one for each thread, for its tables.
class RouteSearch {
 public:
  explicit RouteSearch(const Words& words);

  /// Finds the cheapest route below `limit` among those tried, which passes no point twice.
  /// @return its cost and the route; `limit` and none if there is none.
  /// Cost: O(groups of words) and the points walked; no memory.
  int find(const CostBox& box, const End& u, const End& v, int limit, const Lengths& lengths,
           RandomStream& random, Route& found);

 private:
  static constexpr std::size_t kMostLengths = 64;
  struct Choices {
    std::array<int, kMostLengths> length{};
    int count = 0;
    int largest = 0;
  };

  void fill_arms(const End& u, const End& v);
  void fill_arm(std::vector<int>& costs, Spot from, int d);
  void choose_lengths(const Lengths& lengths, RandomStream& random);
  void choose(Choices& choices, int near, int others, RandomStream& random,
              bool prefers_short) const;
  void try_short_words(const End& u, const End& v);
  void try_planar_words(const End& u, const End& v);
  void try_groups(std::span<const WordGroup> groups, RandomStream& random);
  bool is_hopeless(const WordGroup& group) const;
  void try_group(const WordGroup& group);
  void solve(const WordGroup& group, std::array<int, 3> rest, int chosen_steps);
  void consider(std::size_t segments, const std::uint8_t* direction, int steps);
  int middle_cost(std::size_t segments, const std::uint8_t* direction, int cost) const;
  bool meets_itself(std::size_t segments, const std::uint8_t* direction);

  const Words& words_;
  const PointClass& points_;
  const CostBox* box_ = nullptr;
  Spot from_;
  Spot across_;  // from u to v
  Directions arms_u_ = 0;
  Directions arms_v_ = 0;
  int best_ = 0;
  Route* found_ = nullptr;
  int longest_ = 0;
  std::array<int, kMostSegments> length_{};
  std::array<int, 3> chosen_{};
  /// Costs of the first l points from u in direction d, and of the last l into v.
  std::array<std::vector<int>, kMostDirections> out_of_u_;
  std::array<std::vector<int>, kMostDirections> into_v_;
  std::array<Choices, 3> of_three_;
  std::array<Choices, 2> of_two_;
  std::vector<std::array<int, 3>> products_;           // by basis: rows . across
  std::vector<std::pair<int, std::uint32_t>> passed_;  // a hash table of points: point, stamp
  std::uint32_t stamp_ = 0;
};

}  // namespace ar3d::routed
