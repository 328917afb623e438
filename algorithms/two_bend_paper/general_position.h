#pragma once

#include <cstdint>
#include <vector>

namespace ar3d::two_bend_paper {

template <class T>
struct Point2 {
  T x{};
  T y{};
};

/// Says where a ray stands in the plane.
using Foot = Point2<double>;

/// k quarter turns to the left; exact.
Foot turned(Foot foot, unsigned quarter_turns);

/// Returns how well a place avoids the lines through any two of the feet (Step P.3): 0 if it is one
/// of them or all but collinear with two of them, at least 1 if it keeps the distance that N =
/// max(3, feet) places leave room for. For neighbouring directions from the place to the feet,
/// whose sine is s and whose nearer foot is at distance l: the least max(s N^2 / 0.4, 8 N s l).
/// Cost: O(N log N).
double position_quality(Foot place, const std::vector<Foot>& feet);

/// Candidates are tried in rounds; in round r the demanded quality is 2^-r.
inline constexpr unsigned kRounds = 24;
/// Up to this round twice as many candidates are tried as in the round before.
inline constexpr unsigned kFinestGrowth = 8;

/// Returns whether a place has the quality demanded in a round.
bool is_good(Foot place, const std::vector<Foot>& feet, unsigned round);

/// 0, 1, -1, 2, -2, ... for 0, 1, 2, ...
inline std::int64_t alternating(std::int64_t i) { return i % 2 == 0 ? -(i / 2) : (i + 1) / 2; }

/// A side of the polygon that a cycle projects to: its vertex in the middle, the axis-parallel unit
/// vector along which the cycle runs, and half of its length.
struct Side {
  Foot middle;
  Foot along;
  double half = 0;
};

/// The polygon of a cycle (Step P.5): one vertex on each of its L axis-parallel sides, which
/// alternate with diagonals: a staircase of L - 3 sides towards the east, then one side towards the
/// north, the west and the south. It lies right of all feet.
/// @param feet  all active ones, in the frame in which it lies to their right.
/// @param needs_position  for every vertex whether it must keep general position.
/// @throws InternalError if no place is found.
std::vector<Side> cycle_polygon(const std::vector<Foot>& feet,
                                const std::vector<bool>& needs_position);

/// Right of all feet, by 1 to 2, and at their middle height, both integers. The origin without
/// feet.
Foot right_of(const std::vector<Foot>& feet);

}  // namespace ar3d::two_bend_paper
