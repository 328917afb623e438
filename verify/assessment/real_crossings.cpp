// Counts crossings of exact points. A sweep over boxes and a filter in double leave few pairs, and
// these are decided in big integers; the bounds of the filter stand where they are used.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "ar3d/verify/assessment/real_segments.h"
#include "ar3d/verify/predicates/meeting.h"

namespace ar3d::verify {
namespace {

bool between(const BigInteger& value, const BigInteger& a, const BigInteger& b) {
  return (a <= value && value <= b) || (b <= value && value <= a);
}

bool on_segment(const BigPoint& p, const BigPoint& a, const BigPoint& b) {
  return between(p.x, a.x, b.x) && between(p.y, a.y, b.y) && between(p.z, a.z, b.z) &&
         cross(p - a, b - a) == BigVector{};
}

meeting::Triple<BigInteger> triple(const BigPoint& p) { return {p.x, p.y, p.z}; }

bool meet(const RealSegment& s, const RealSegment& t) {
  if (s.is_vertex) return t.is_vertex ? s.from == t.from : on_segment(s.from, t.from, t.to);
  if (t.is_vertex) return on_segment(t.from, s.from, s.to);
  return meeting::kind(triple(s.from), triple(s.to), triple(t.from), triple(t.to)) !=
         MeetingKind::nothing;
}

/// The end that two segments may share: of consecutive ones their bend, of end segments their
/// vertex. Which end of s, and of t: true for `to`.
std::optional<std::pair<bool, bool>> joint(const Graph& graph,
                                           const std::vector<RealSegment>& segments, std::size_t i,
                                           std::size_t j) {
  const RealSegment &s = segments[i], &t = segments[j];
  if (s.is_vertex || t.is_vertex) return std::nullopt;
  if (s.edge == t.edge) {
    if (i + 1 == j) return std::pair{true, false};
    if (j + 1 == i) return std::pair{false, true};
    return std::nullopt;
  }
  const Edge a = graph.edge(s.edge), b = graph.edge(t.edge);
  if (s.is_first && t.is_first && a.u == b.u) return std::pair{false, false};
  if (s.is_first && t.is_last && a.u == b.v) return std::pair{false, true};
  if (s.is_last && t.is_first && a.v == b.u) return std::pair{true, false};
  if (s.is_last && t.is_last && a.v == b.v) return std::pair{true, true};
  return std::nullopt;
}

/// From a common end two segments of positive length share more exactly if they run the same way.
bool overlap_from(std::pair<bool, bool> at, const RealSegment& s, const RealSegment& t) {
  BigVector u = s.to - s.from, v = t.to - t.from;
  if (at.first) u = -u;
  if (at.second) v = -v;
  return dot(u, v) > 0 && cross(u, v) == BigVector{};
}

/// A segment in doubles, for the filter: its box is widened by the rounding.
struct Rounded {
  RoundedPoint from, to, low, high;
};

constexpr double kHalfUlp = 0x1p-53;

Rounded boxed(const RealSegment& s, int unit_exponent) {
  Rounded r{verify::rounded(s.from, unit_exponent), verify::rounded(s.to, unit_exponent), {}, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [low, high] = std::minmax(r.from[i], r.to[i]);
    const double slack = 2 * kHalfUlp * std::max(std::abs(low), std::abs(high));
    r.low[i] = low - slack;
    r.high[i] = high + slack;
  }
  return r;
}

bool boxes_meet(const Rounded& a, const Rounded& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (a.low[i] > b.high[i] || b.low[i] > a.high[i]) return false;
  }
  return true;
}

/// True only if the four ends are surely not in one plane. Let m be the largest coordinate and D
/// the largest difference. A difference of rounded points is off by at most E = 2^-51 m (two points
/// by 2^-53 m, itself by 2^-53 * 2 m). For D >= 32 E a product of three of them is off by less than
/// 3.2 D^2 E, six of them by 20 D^2 E, and their own roundings, thirty of at most 2^-53 D^3, add
/// less than 30 * 2^-53 * 2 m D^2 = 15 D^2 E: less than 2^-44 m D^2 in all.
bool surely_not_coplanar(const Rounded& s, const Rounded& t) {
  double largest = 0, widest = 0;
  RoundedPoint u, v, w;
  for (std::size_t i = 0; i < 3; ++i) {
    u[i] = s.to[i] - s.from[i];
    v[i] = t.to[i] - t.from[i];
    w[i] = t.from[i] - s.from[i];
    largest = std::max(
        {largest, std::abs(s.from[i]), std::abs(s.to[i]), std::abs(t.from[i]), std::abs(t.to[i])});
    widest = std::max({widest, std::abs(u[i]), std::abs(v[i]), std::abs(w[i])});
  }
  const double determinant = w[0] * (u[1] * v[2] - u[2] * v[1]) +
                             w[1] * (u[2] * v[0] - u[0] * v[2]) +
                             w[2] * (u[0] * v[1] - u[1] * v[0]);
  return widest > 0x1p-46 * largest && std::abs(determinant) > 0x1p-44 * largest * widest * widest;
}

/// The axis along which the fewest boxes are expected at one place: their lengths there, added up,
/// over the length of all. Components stand side by side in x, cycles one above the other in z.
std::size_t sweep_axis(const std::vector<Rounded>& boxes) {
  std::size_t best = 0;
  double fewest = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double sum = 0, low = boxes[0].low[axis], high = boxes[0].high[axis];
    for (const Rounded& box : boxes) {
      sum += box.high[axis] - box.low[axis];
      low = std::min(low, box.low[axis]);
      high = std::max(high, box.high[axis]);
    }
    // All in one plane across the axis: all at one place.
    const double expected = high > low ? sum / (high - low) : static_cast<double>(boxes.size());
    if (expected < fewest) {
      fewest = expected;
      best = axis;
    }
  }
  return best;
}

}  // namespace

bool crosses(const Graph& graph, const std::vector<RealSegment>& segments, std::size_t i,
             std::size_t j) {
  const auto at = joint(graph, segments, i, j);
  return at ? overlap_from(*at, segments[i], segments[j]) : meet(segments[i], segments[j]);
}

std::uint64_t count_crossings(const Graph& graph, const std::vector<RealSegment>& segments,
                              int unit_exponent) {
  std::vector<Rounded> boxes;
  boxes.reserve(segments.size());
  for (const RealSegment& s : segments) boxes.push_back(boxed(s, unit_exponent));
  if (boxes.empty()) return 0;
  const std::size_t axis = sweep_axis(boxes);
  const auto low = [&](std::size_t i) { return boxes[i].low[axis]; };
  std::vector<std::size_t> order(segments.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return low(a) < low(b); });
  std::uint64_t count = 0;
  std::vector<std::size_t> active;
  for (const std::size_t i : order) {
    std::erase_if(active, [&](std::size_t j) { return boxes[j].high[axis] < low(i); });
    for (const std::size_t j : active) {
      if (!boxes_meet(boxes[i], boxes[j])) continue;
      if (surely_not_coplanar(boxes[i], boxes[j])) continue;
      count += crosses(graph, segments, i, j) ? 1 : 0;
    }
    active.push_back(i);
  }
  return count;
}

}  // namespace ar3d::verify
