#pragma once

#include <cstdint>
#include <vector>

namespace ar3d::two_bend_paper {

/// A place in the plane: where a ray stands.
struct Foot {
  double x = 0;
  double y = 0;
};

/// k quarter turns to the left; exact.
Foot turned(Foot foot, unsigned quarter_turns);

/// How well a place avoids the lines through any two of the feet (Step P.3): 0 if it is one of them
/// or all but collinear with two of them, at least 1 if it keeps the distance that N = max(3, feet)
/// places leave room for. For neighbouring directions from the place to the feet, whose sine is s
/// and whose nearer foot is at distance l: the least max(s N^2 / 0.4, 8 N s l).
/// Cost: O(N log N).
double position_quality(Foot place, const std::vector<Foot>& feet);

/// Candidates are tried in rounds; in round r the demanded quality is 2^-r.
inline constexpr unsigned kRounds = 24;

/// Whether a place has the quality demanded in a round.
bool is_good(Foot place, const std::vector<Foot>& feet, unsigned round);

/// 0, 1, -1, 2, -2, ... for 0, 1, 2, ...
inline std::int64_t alternating(std::int64_t i) { return i % 2 == 0 ? -(i / 2) : (i + 1) / 2; }

}  // namespace ar3d::two_bend_paper
