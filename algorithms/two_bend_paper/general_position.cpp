// Step P.3: how far a foot is from being on a line with two others. The paper's condition that no
// three rays are coplanar cannot be tested in real arithmetic; a quality that doubles compute, with
// a demand that is halved from round to round, takes its place. Directions are sorted, so that only
// neighbours are compared. Cost: O(N log N) for N feet.
#include "ar3d/algorithms/two_bend_paper/general_position.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ar3d::two_bend_paper {
namespace {

constexpr double kLeastSine = 0x1p-40;  // below, a sine may be rounding

/// From the place to a foot or away from it, whichever points to x > 0.
struct Direction {
  double x;
  double y;
  double length;
  double slope() const { return x > 0 ? y / x : std::numeric_limits<double>::infinity(); }
};

}  // namespace

Foot turned(Foot foot, unsigned quarter_turns) {
  for (unsigned i = 0; i < quarter_turns % 4; ++i) foot = {-foot.y, foot.x};
  return foot;
}

double position_quality(Foot place, const std::vector<Foot>& feet) {
  std::vector<Direction> directions;
  directions.reserve(feet.size());
  for (const Foot foot : feet) {
    double x = foot.x - place.x, y = foot.y - place.y;
    if (x == 0 && y == 0) return 0;
    if (x < 0 || (x == 0 && y < 0)) {
      x = -x;
      y = -y;
    }
    directions.push_back({x, y, std::sqrt(x * x + y * y)});
  }
  double quality = std::numeric_limits<double>::infinity();
  if (directions.size() < 2) return quality;
  std::sort(directions.begin(), directions.end(),
            [](const Direction& a, const Direction& b) { return a.slope() < b.slope(); });
  const double n = std::max<double>(3, static_cast<double>(feet.size()));
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Direction& a = directions[i];
    const Direction& b = directions[(i + 1) % directions.size()];
    const double sine = std::abs(a.x * b.y - a.y * b.x) / (a.length * b.length);
    if (sine < kLeastSine) return 0;
    quality = std::min(quality, sine * n * std::max(n / 0.4, 8 * std::min(a.length, b.length)));
  }
  return quality;
}

bool is_good(Foot place, const std::vector<Foot>& feet, unsigned round) {
  return position_quality(place, feet) >= std::ldexp(1.0, -static_cast<int>(round));
}

}  // namespace ar3d::two_bend_paper
