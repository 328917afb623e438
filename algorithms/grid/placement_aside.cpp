// Step 3.5: in a cubic component some vertex has three earlier neighbours, so one edge fr is set
// aside: f comes first, r last. If their free labels differ, fr becomes a defect with a slot beside
// f, and f stands outside the zone of all other numbers, where nothing can be in the way. O(log n)
// expected.

#include "ar3d/algorithms/grid/placement.h"
#include "ar3d/base/error.h"

namespace ar3d::grid {

void Placement::set_aside() {
  aside_.f = part_.begin;
  aside_.r = part_.end - 1;
  for (const HalfEdge& half : graph_.incident(aside_.f)) {
    if (half.to == aside_.r) aside_.edge = half.edge;
  }
  aside_.phi = planes_.labels.at(aside_.edge, aside_.f, aside_.r);
  aside_.psi = planes_.labels.at(aside_.edge, aside_.r, aside_.f);
  aside_.p = next(aside_.phi);
  aside_.m = previous(aside_.phi);
}

/// f gets X_p and X_m; X_phi(f) follows with r. If psi = phi nothing special is needed.
void Placement::place_f() {
  if (aside_.is_defect()) return place_f_of_defect();
  Site site = look(aside_.f);
  site.next_to_f = false;
  for (const HalfEdge& half : graph_.incident(aside_.f)) {
    if (half.edge == aside_.edge) continue;
    const Colour c = planes_.labels.at(half.edge, aside_.f, half.to);
    site.forward[c] = half;
    site.forward_colours |= only(c);
  }
  for (const Colour c : {aside_.p, aside_.m}) {
    const auto number = choose(c, {});
    take(c, number.value());
    assign(site, c, *number);
  }
  aside_.a = planes_.of[aside_.f][aside_.p];
  aside_.b = planes_.of[aside_.f][aside_.m];
}

/// X_p(f) = a below everything of colour p, with a + 1 and a + 2 kept free; X_m(f) = b follows with
/// x_m.
void Placement::place_f_of_defect() {
  aside_.a_prime = taken_[aside_.p].previous_outside(-zone_);
  take(aside_.p, aside_.a_prime);
  aside_.a = near_taken_[aside_.p].previous_outside(aside_.a_prime - 1) - 2;
  Site site;
  site.v = aside_.f;
  for (const HalfEdge& half : graph_.incident(aside_.f)) {
    if (planes_.labels.at(half.edge, aside_.f, half.to) != aside_.p) continue;
    site.forward[aside_.p] = half;
    site.forward_colours = only(aside_.p);
  }
  for (std::int64_t j = 0; j < 3; ++j) take(aside_.p, aside_.a + j);
  assign(site, aside_.p, aside_.a);
}

/// f's neighbour x_m: a forward plane of colour p becomes a', so that x_m is never the w of a clash
/// of label p; its last number is b = X_m(f), above everything of colour m, with b - 1 and b - 2
/// kept free.
bool Placement::place_x_m(const Site& site) {
  ColourSet missing = missing_colours(site.v) & ~only(aside_.m);
  if (contains(missing, aside_.p)) {
    assign(site, aside_.p, aside_.a_prime);
    missing &= ~only(aside_.p);
  }
  if (missing != 0) {
    const auto number = choose(aside_.phi, {});
    if (!number) return false;
    take(aside_.phi, *number);
    assign(site, aside_.phi, *number);
  }
  SumRule rule = site.rule;
  const PlaneNumbers& x = planes_.of[site.v];
  rule.known = std::int64_t{x[aside_.p]} + x[aside_.phi];
  const std::int64_t low = zone_ + 2;
  aside_.b =
      triple_search_
          .find_up(near_taken_[aside_.m], {&rule, 1}, {low, low + proof_.sure_triple_length()})
          .value();
  for (std::int64_t j = 0; j < 3; ++j) take(aside_.m, aside_.b - j);
  assign(site, aside_.m, aside_.b);
  Site f;
  f.v = aside_.f;
  assign(f, aside_.m, aside_.b);
  finish(site);
  return true;
}

/// If psi = phi, S(r) - S(f) = X_p(r) + X_m(r) - a - b does not depend on the shared number: the
/// last one chosen of X_p(r) and X_m(r) keeps it away from -1, 0, 1.
std::optional<SumRule> Placement::apart_rule(const Site& site, Colour c) const {
  if (!part_.cubic || aside_.is_defect() || c == aside_.phi) return std::nullopt;
  if (!contains(site.forward_colours, c) || site.forward[c].to != aside_.r) return std::nullopt;
  const Colour other = c == aside_.p ? aside_.m : aside_.p;
  if (contains(missing_colours(aside_.r), other)) return std::nullopt;
  SumRule rule;
  rule.is_new = false;
  rule.known = planes_.of[aside_.r][other];
  rule.join(aside_.a + aside_.b);
  return rule;
}

SumRule Placement::f_rule() const {
  SumRule rule;
  rule.known = aside_.a + aside_.b;
  for (const HalfEdge& half : graph_.incident(aside_.f)) {
    if (half.edge != aside_.edge) rule.join(sum_of(planes_.of[half.to]));
  }
  return rule;
}

bool Placement::place_last() {
  const Site site = look(aside_.r);
  if (!(site.opens != 0 ? place_clash(site) : place_r(site))) return false;
  if (!aside_.is_defect()) {
    ++planes_.counts.last_edge_u;
    settle_f(planes_.of[aside_.r][aside_.phi]);
  } else if (aside_.psi == aside_.m) {
    close_defect_m();
  } else {
    close_defect_p();
  }
  return true;
}

/// r without a clash: its last number X_psi(r), shared with f if psi = phi.
bool Placement::place_r(const Site& site) {
  const PlaneNumbers& x = planes_.of[aside_.r];
  std::array<SumRule, 2> rules{site.rule, {}};
  rules[0].known = std::int64_t{x[next(aside_.psi)]} + x[previous(aside_.psi)];
  if (!aside_.is_defect()) rules[1] = f_rule();
  const auto number = choose(aside_.psi, {rules.data(), aside_.is_defect() ? 1u : 2u});
  if (!number) return false;
  take(aside_.psi, *number);
  assign(site, aside_.psi, *number);
  finish(site);
  return true;
}

/// Defect (f: phi, r: m), third colour p, slot a + 2: C = X_p(r) - a >= 3, B = b - X_m(r) >= 3, A
/// >= C.
void Placement::close_defect_m() {
  ++planes_.counts.last_edge_m;
  const PlaneNumbers& r = planes_.of[aside_.r];
  const std::int64_t c = r[aside_.p] - aside_.a;
  expect(c >= 3 && aside_.b - r[aside_.m] >= 3, "f stands outside the zone");
  const SumRule rule = f_rule();
  const std::int64_t low = r[aside_.phi] + c;
  const auto number =
      search_.find_up(taken_[aside_.phi], {&rule, 1}, {low, low + proof_.sure_length()});
  take(aside_.phi, number.value());
  settle_f(*number);
  planes_.slots.push_back({aside_.edge, aside_.a + 2});
}

/// Defect (r: p, f: phi), third colour m, slot b - 1: A = X_p(r) - a >= 1, C = b - X_m(r) >= 3, B
/// >= C.
void Placement::close_defect_p() {
  ++planes_.counts.last_edge_p;
  const PlaneNumbers& r = planes_.of[aside_.r];
  const std::int64_t c = aside_.b - r[aside_.m];
  expect(c >= 3 && r[aside_.p] - aside_.a >= 1, "f stands outside the zone");
  const SumRule rule = f_rule();
  const std::int64_t high = r[aside_.phi] - c;
  const auto number =
      search_.find_down(taken_[aside_.phi], {&rule, 1}, {high - proof_.sure_length(), high});
  take(aside_.phi, number.value());
  settle_f(*number);
  planes_.slots.push_back({aside_.edge, aside_.b - 1});
}

void Placement::settle_f(std::int64_t number) {
  Site f;
  f.v = aside_.f;
  assign(f, aside_.phi, number);
  finish(f);
}

}  // namespace ar3d::grid
