// Step P.3, how far a foot is from being on a line with two others, and Step P.5 with Lemma P.2,
// the polygon that a cycle projects to. That no three rays are coplanar cannot be tested in real
// arithmetic; a quality that doubles compute, with a demand that is halved from round to round,
// takes its place. Each side of the polygon is lengthened until its own vertex is in general
// position; the last two close it. Cost: O(N log N) for N feet and per candidate of a side.
#include "ar3d/algorithms/two_bend_paper/general_position.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ar3d/base/error.h"

namespace ar3d::two_bend_paper {
namespace {

constexpr double kLeastSine = 0x1p-40;  // below, a sine may be rounding

double norm(Foot foot) { return std::sqrt(foot.x * foot.x + foot.y * foot.y); }

double slope(Foot foot) {
  return foot.x > 0 ? foot.y / foot.x : std::numeric_limits<double>::infinity();
}

constexpr std::size_t kLongCycle = 16;  // from here on the staircase bends by itself
constexpr double kSlowestBend = 64;

class PolygonBuilder {
 public:
  PolygonBuilder(const std::vector<Foot>& feet, const std::vector<bool>& needs_position)
      : feet_(feet), needs_position_(needs_position), length_(needs_position.size()) {
    const auto count = std::count(needs_position.begin(), needs_position.end(), true);
    is_long_ = static_cast<std::size_t>(count) >= kLongCycle;
  }

  std::vector<Side> build() {
    corner_ = right_of(feet_);
    place_first();
    for (std::size_t i = 1; i + 3 < length_; ++i) place_next(false);
    place_next(true);
    close();
    return std::move(sides_);
  }

 private:
  bool try_side(const Side& side, unsigned round) const {
    return !needs_position_[sides_.size()] || is_good(side.middle, feet_, round);
  }

  void keep(const Side& side) {
    if (needs_position_[sides_.size()]) feet_.push_back(side.middle);
    sides_.push_back(side);
  }

  void place_first() {
    const double y = corner_.y - std::floor(static_cast<double>(length_) / 2);
    for (unsigned round = 0; round < kRounds; ++round) {
      const double step = std::ldexp(1.0, -static_cast<int>(round));
      const std::int64_t most = std::int64_t{64} << std::min(round, kFinestGrowth);
      for (std::int64_t j = 0; j < most; ++j) {
        const Foot at{corner_.x + 2, y + static_cast<double>(alternating(j)) * step};
        const Side side{at, {1, 0}, 1};
        if (try_side(side, round)) return keep(side);
      }
    }
    expect(false, "the first vertex of a cycle finds its place");
  }

  /// Calls found(a, b) for two lengths from 0 on, small sums first, until it returns true.
  template <class Found>
  void try_lengths(const Found& found) const {
    for (unsigned round = 0; round < kRounds; ++round) {
      const double step = std::ldexp(1.0, -static_cast<int>(round));
      const int most = 16 << std::min(round, kFinestGrowth / 2);
      for (int sum = 0; sum < most; ++sum) {
        for (int a = 0; a <= sum; ++a) {
          if (found(a * step, (sum - a) * step, round)) return;
        }
      }
    }
    expect(false, "a vertex of a cycle finds its place");
  }

  /// The diagonal that is added after the i-th side at least: a long staircase is convex.
  double least_diagonal() const {
    if (!is_long_) return 1;
    const double slope = std::min(1.0, static_cast<double>(length_) / kSlowestBend);
    return 1 + std::floor(static_cast<double>(sides_.size()) * slope);
  }

  void place_next(bool north) {
    const Side last = sides_.back();
    const double start_x = last.middle.x + last.half, least = least_diagonal();
    try_lengths([&](double a, double b, unsigned round) {
      const double half = 1 + a, diagonal = least + b;
      const double x = start_x + diagonal, y = last.middle.y + diagonal;
      const Side side =
          north ? Side{{x, y + half}, {0, 1}, half} : Side{{x + half, y}, {1, 0}, half};
      if (!try_side(side, round)) return false;
      keep(side);
      return true;
    });
  }

  /// The sides towards west and south, between diagonals of lengths g, h and 1.
  void close() {
    const Side north = sides_.back();
    const double x = north.middle.x, y = north.middle.y + north.half;
    const double bottom = sides_.front().middle.y;
    try_lengths([&](double a, double b, unsigned round) {
      const double g = 1 + a, h = 1 + b;
      const double west_half = (x - g - h - corner_.x) / 2;
      const double south_half = (y + g - h - 1 - bottom) / 2;
      if (west_half < 0.5 || south_half < 0.5) return false;
      const Side west{{x - g - west_half, y + g}, {-1, 0}, west_half};
      const Side south{{corner_.x, bottom + 1 + south_half}, {0, -1}, south_half};
      if (!try_side(west, round)) return false;
      const std::size_t feet = feet_.size();
      keep(west);
      if (try_side(south, round)) {
        keep(south);
        return true;
      }
      sides_.pop_back();
      feet_.resize(feet);
      return false;
    });
  }

  std::vector<Foot> feet_;  // with the polygon's own
  const std::vector<bool>& needs_position_;
  const std::size_t length_;
  bool is_long_ = false;
  Foot corner_;
  std::vector<Side> sides_;
};

}  // namespace

Foot turned(Foot foot, unsigned quarter_turns) {
  for (unsigned i = 0; i < quarter_turns % 4; ++i) foot = {-foot.y, foot.x};
  return foot;
}

double position_quality(Foot place, const std::vector<Foot>& feet) {
  std::vector<Foot> directions;  // to feet or away from them, whichever points to x > 0
  directions.reserve(feet.size());
  for (const Foot foot : feet) {
    double x = foot.x - place.x, y = foot.y - place.y;
    if (x == 0 && y == 0) return 0;
    if (x < 0 || (x == 0 && y < 0)) {
      x = -x;
      y = -y;
    }
    directions.push_back({x, y});
  }
  double quality = std::numeric_limits<double>::infinity();
  if (directions.size() < 2) return quality;
  std::sort(directions.begin(), directions.end(),
            [](Foot a, Foot b) { return slope(a) < slope(b); });
  const double n = std::max<double>(3, static_cast<double>(feet.size()));
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Foot a = directions[i], b = directions[(i + 1) % directions.size()];
    const double sine = std::abs(a.x * b.y - a.y * b.x) / (norm(a) * norm(b));
    if (sine < kLeastSine) return 0;
    quality = std::min(quality, sine * n * std::max(n / 0.4, 8 * std::min(norm(a), norm(b))));
  }
  return quality;
}

bool is_good(Foot place, const std::vector<Foot>& feet, unsigned round) {
  return position_quality(place, feet) >= std::ldexp(1.0, -static_cast<int>(round));
}

Foot right_of(const std::vector<Foot>& feet) {
  if (feet.empty()) return {};
  double right = feet[0].x, low = feet[0].y, high = feet[0].y;
  for (const Foot foot : feet) {
    right = std::max(right, foot.x);
    low = std::min(low, foot.y);
    high = std::max(high, foot.y);
  }
  return {std::ceil(right) + 1, std::floor((low + high) / 2)};
}

std::vector<Side> cycle_polygon(const std::vector<Foot>& feet,
                                const std::vector<bool>& needs_position) {
  return PolygonBuilder(feet, needs_position).build();
}

}  // namespace ar3d::two_bend_paper
