// Step 3.8, Lemma 3.2. Three bends from two labels, two ends and a slot, as in the figure of
// docs/theorem3.md. Residues modulo 3 keep routes of different planes apart (Lemma 3.3). Bends are
// computed when they are read, in O(1) for edges without a slot.
#include "ar3d/algorithms/grid/planes.h"

namespace ar3d::grid {
namespace {

constexpr unsigned kFourth = 3;  // the index of the fourth coordinate

/// Four integers of sum 0.
using Coordinates4 = std::array<std::int64_t, 4>;

Coordinates4 four(Point p) {
  const std::int64_t x0 = (p.x + p.y - p.z) / 2;
  return {x0, p.x - x0, p.y - x0, -(p.x + p.y + p.z) / 2};
}
Point cartesian(const Coordinates4& x) { return {x[0] + x[1], x[0] + x[2], x[1] + x[2]}; }

/// Walks `length` steps along e_head - e_tail. @return the bend there.
Point go(Coordinates4& at, unsigned head, unsigned tail, std::int64_t length) {
  at[head] += length;
  at[tail] -= length;
  return cartesian(at);
}

using Bends = std::array<Point, 3>;

/// Both ends labelled c. Walks from the end with the larger fourth coordinate: (p,q) l1, (p,4) l2,
/// (q,4) l3, (q,p) l4; every length is at least 1 because the sums differ by at least 2.
Bends u_edge(Colour c, Point upper, Point lower) {
  const Colour p = next(c);
  const Colour q = previous(c);
  Coordinates4 at = four(upper);
  const Coordinates4 b = four(lower);
  const std::int64_t dp = b[p] - at[p];
  const std::int64_t dq = b[q] - at[q];
  const std::int64_t l1 = dp > 0 && dq <= 0 ? 4 - dq : 1;
  const std::int64_t l4 = dp <= 0 ? 4 - dp : 1;
  return {go(at, p, q, l1), go(at, p, kFourth, dp - l1 + l4), go(at, q, kFourth, dq + l1 - l4)};
}

// A defect (u: alpha, v: beta) with alpha = beta + 1, from u to v, in the paper's sense "no common
// label"; gamma is the third colour.

/// E < 0: (gamma,beta) 1, (gamma,4) 3|E|, (gamma,beta) 3B - 1, (gamma,alpha) 3A.
Bends defect_nt(Colour alpha, Point from, Point to) {
  const Colour beta = previous(alpha);
  const Colour gamma = next(alpha);
  const Coordinates4 u = four(from);
  const Coordinates4 v = four(to);
  Coordinates4 at = u;
  return {go(at, gamma, beta, 1), go(at, gamma, kFourth, u[kFourth] - v[kFourth]),
          go(at, gamma, beta, u[beta] - v[beta] - 1)};
}

/// E > 0 with slot k: (gamma,beta) a, (4,beta) 3B - a, (4,alpha) 3A - d, (gamma,alpha) d with
/// a = 3(k - X_gamma(u)) + 1 and d = 3C - a.
Bends defect_pq(Colour alpha, Point from, Point to, std::int64_t k) {
  const Colour beta = previous(alpha);
  const Colour gamma = next(alpha);
  const Coordinates4 u = four(from);
  const Coordinates4 v = four(to);
  const std::int64_t first = 3 * k + 1 - u[gamma];
  const std::int64_t last = v[gamma] - u[gamma] - first;
  Coordinates4 at = u;
  return {go(at, gamma, beta, first), go(at, kFourth, beta, u[beta] - v[beta] - first),
          go(at, kFourth, alpha, u[alpha] - v[alpha] - last)};
}

}  // namespace

Point position(const PlaneNumbers& x) {
  return {3 * (std::int64_t{x[0]} + x[1]), 3 * (std::int64_t{x[0]} + x[2]),
          3 * (std::int64_t{x[1]} + x[2])};
}

std::int64_t Routes::slot_of(EdgeId e) const {
  const auto at = std::ranges::lower_bound(slots_, e, {}, &Slot::edge);
  expect(at != slots_.end() && at->edge == e, "a defect with E > 0 has a slot (I5)");
  return at->k;
}

void Routes::append_bends(EdgeId e, Edge ends, Point at_u, Point at_v,
                          std::vector<Point>& out) const {
  const Colour label_u = labels_.at(e, ends.u, ends.v);
  const Colour label_v = labels_.at(e, ends.v, ends.u);
  const std::int64_t drop = four(at_u)[kFourth] - four(at_v)[kFourth];
  Bends bends;
  bool reversed = false;
  if (label_u == label_v) {
    reversed = drop < 0;
    bends = reversed ? u_edge(label_u, at_v, at_u) : u_edge(label_u, at_u, at_v);
  } else {
    reversed = label_u != next(label_v);
    const Colour alpha = reversed ? label_v : label_u;
    const Point from = reversed ? at_v : at_u;
    const Point to = reversed ? at_u : at_v;
    const bool is_nt = reversed ? drop < 0 : drop > 0;
    bends = is_nt ? defect_nt(alpha, from, to) : defect_pq(alpha, from, to, slot_of(e));
  }
  if (reversed) std::ranges::reverse(bends);
  out.insert(out.end(), bends.begin(), bends.end());
}

}  // namespace ar3d::grid
