// Segments with big coordinates, and the miss of an angle without cancellation.
#include "ar3d/verify/assessment/real_segments.h"

#include <cmath>
#include <numbers>

namespace ar3d::verify {

double rounded(const BigInteger& value, int shift) {
  if (value == 0) return 0;
  const BigInteger size = abs(value);
  // 62 bits and a sticky one below them: rounding to 53 bits then is rounding of the value.
  const int lost = std::max(0, static_cast<int>(msb(size)) + 1 - 62);
  auto kept = static_cast<std::int64_t>(BigInteger(size >> static_cast<unsigned>(lost)));
  if (lost > 0 && lsb(size) < static_cast<unsigned>(lost)) kept |= 1;
  return std::ldexp(static_cast<double>(value < 0 ? -kept : kept), lost + shift);
}

RoundedPoint rounded(const BigPoint& p, int shift) {
  return {rounded(p.x, shift), rounded(p.y, shift), rounded(p.z, shift)};
}

// With a = <u,v>, b = <u,u>, c = <v,v> and S = |u x v| = sqrt(bc - a^2), the angle phi has tan phi
// = S / a, so tan(phi - 120) = (S + sqrt3 a) / (a - sqrt3 S) = (bc - 4 a^2) / ((S - sqrt3 a) (a -
// sqrt3 S)), where for a < 0 nothing cancels but bc - 4 a^2, and that is an exact integer.
double short_of_120(const BigVector& u, const BigVector& v) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  const BigInteger a = dot(u, v);
  const BigInteger product = dot(u, u) * dot(v, v);
  const BigInteger square = a * a;
  const BigInteger excess = product - 4 * square;  // negative: the angle is larger than 120 degrees
  const BigInteger sine_square = product - square;
  const int scale = -(static_cast<int>(msb(product)) / 2) * 2;  // product * 2^scale is below 4
  const double cosine = rounded(a, scale / 2);
  const double sine = std::sqrt(rounded(sine_square, scale));
  if (a >= 0) return 120 - std::atan2(sine, cosine) * kDegrees;
  const double root = std::numbers::sqrt3;
  const double numerator = rounded(excess, scale);
  const double denominator = (sine - root * cosine) * (root * sine - cosine);
  return std::atan(numerator / denominator) * kDegrees;
}

std::vector<RealSegment> segments_of(const Graph& graph, const RealPoints& points) {
  std::vector<RealSegment> result;
  for (EdgeId e = 0; e < graph.num_edges(); ++e) {
    const Edge ends = graph.edge(e);
    const std::size_t begin = result.size();
    BigPoint from = points.vertices[ends.u];
    const auto bends = points.bends_of(e);
    for (std::size_t i = 0; i <= bends.size(); ++i) {
      const BigPoint& to = i < bends.size() ? bends[i] : points.vertices[ends.v];
      if (from == to) continue;
      result.push_back({from, to, e, false, false, false});
      from = to;
    }
    if (result.size() == begin) continue;
    result[begin].is_first = true;
    result.back().is_last = true;
  }
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    if (graph.degree(v) > 0) continue;
    result.push_back({points.vertices[v], points.vertices[v], 0, false, false, true});
  }
  return result;
}

}  // namespace ar3d::verify
