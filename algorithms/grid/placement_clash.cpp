// Step 3.4, Rules 3.1 and 3.2: two earlier neighbours w and w' chose the same label lambda for a
// vertex, so one of the two edges becomes a defect. Neither rule alone keeps numbers small: the
// first lets H feed on earlier differences, the second L on earlier L. Together they do (Lemma
// 3.5). Cost: one or two searches per clash, O(log n) expected each.

#include <algorithm>

#include "ar3d/algorithms/grid/placement.h"
#include "ar3d/base/error.h"

namespace ar3d::grid {

Placement::Clash Placement::look_at_clash(const Site& site) const {
  expect(site.opens == 2, "a clash has two edges");
  Clash clash;
  clash.site = &site;
  clash.lambda = planes_.labels.at(site.open[0].edge, site.open[0].to, site.v);
  clash.beta = previous(clash.lambda);
  clash.gamma = next(clash.lambda);
  const auto plane = [&](const HalfEdge& half) { return planes_.of[half.to][clash.lambda]; };
  const bool first_is_lower = plane(site.open[0]) < plane(site.open[1]);
  clash.w_prime = site.open[first_is_lower ? 0 : 1];
  clash.w = site.open[first_is_lower ? 1 : 0];
  clash.plane = plane(clash.w_prime);
  clash.a = plane(clash.w) - clash.plane;
  expect(clash.a > 0, "w and w' own different planes");
  clash.w_beta = planes_.of[clash.w.to][clash.beta];
  clash.w_gamma = planes_.of[clash.w.to][clash.gamma];
  clash.closes_u_edge = part_.cubic && site.v == aside_.r && !aside_.is_defect();
  return clash;
}

/// Rule 3.1 (NT, E < 0) if it fits, else Rule 3.2 (PQ, E > 0). Rule 3.1 alone would let numbers H
/// feed on each other, Rule 3.2 alone the numbers L; together every number stays within O(n)
/// (Lemma 3.5).
bool Placement::place_clash(const Site& site) {
  Clash clash = look_at_clash(site);
  planes_.labels.set(clash.w.edge, site.v, clash.w.to, clash.beta);
  planes_.labels.set(clash.w_prime.edge, site.v, clash.w_prime.to, clash.lambda);
  clash_edges_.emplace_back(site.v, clash.w);
  clash_edges_.emplace_back(site.v, clash.w_prime);
  assign(site, clash.lambda, clash.plane);
  const bool placed = place_clash_nt(clash) || place_clash_pq(clash);
  if (placed) finish(site);
  return placed;
}

/// L_0: the largest free number below X_beta(w) and in the window; S(r) and S(f) stay apart if H is
/// shared.
std::int64_t Placement::highest_low_number(const Clash& clash) const {
  std::int64_t low = taken_[clash.beta].previous_outside(std::min(window_, clash.w_beta - 1));
  if (!clash.closes_u_edge) return low;
  const std::int64_t apart = aside_.a + aside_.b - clash.plane;
  while (low >= apart - 1 && low <= apart + 1) {
    low = taken_[clash.beta].previous_outside(low - 1);
  }
  return low;
}

/// Rule 3.1: H so large that C > A + B. Must succeed if X_gamma(w) is very low, so that low numbers
/// do not feed.
bool Placement::place_clash_nt(const Clash& clash) {
  const std::int64_t low = highest_low_number(clash);
  const std::int64_t least = clash.w_gamma + clash.a + clash.w_beta - low + 1;
  std::array<SumRule, 2> rules{clash.site->rule, {}};
  rules[0].known = clash.plane + low;
  rules[0].join(sum_of(planes_.of[clash.w_prime.to]));
  const auto apart = apart_rule(*clash.site, clash.gamma);
  if (clash.closes_u_edge) rules[1] = f_rule();
  if (apart) rules[1] = *apart;
  const std::span<const SumRule> used(rules.data(), clash.closes_u_edge || apart ? 2 : 1);
  const bool forced = clash.w_gamma < proof_.lowest_for_pq();
  const std::int64_t reach = forced ? proof_.far_window() : window_;
  const auto high = search_.find_up(taken_[clash.gamma], used, {std::max(-reach, least), reach});
  expect(high.has_value() || !forced, "NT fits when X_gamma(w) is very low");
  if (!high || (zoned() && *high >= zone_)) return false;
  ++planes_.counts.nt;
  settle_clash(clash, *high, low);
  return true;
}

/// Rule 3.2: H - 2, H - 1, H free and L so low that B >= C; the slot is H - 1.
bool Placement::place_clash_pq(const Clash& clash) {
  const std::int64_t start = std::max(clash.w_gamma + 3, -window_ + 2);
  const NumberSet& near = near_taken_[clash.gamma];
  std::int64_t high = near.next_outside(start);
  if (const auto apart = apart_rule(*clash.site, clash.gamma)) {
    while (!search_.obeys(high, *apart)) high = near.next_outside(high + 1);
  }
  SumRule rule = clash.site->rule;
  rule.join(sum_of(planes_.of[clash.w_prime.to]));
  if (clash.closes_u_edge) {
    const SumRule f = f_rule();
    const NumberRange range{start, start + proof_.sure_triple_length()};
    high = triple_search_.find_up(near, {&f, 1}, range).value();
    rule.join(f.known + high);
  } else if (zoned() && high >= zone_) {
    return false;
  }
  rule.known = clash.plane + high;
  const std::int64_t top =
      std::min({window_, clash.w_beta - 3, clash.w_beta + clash.w_gamma - high});
  const auto low =
      search_.find_down(taken_[clash.beta], {&rule, 1}, {top - proof_.sure_length(), top});
  ++planes_.counts.pq;
  settle_clash(clash, high, low.value());
  take(clash.gamma, high - 2);
  take(clash.gamma, high - 1);
  planes_.slots.push_back({clash.w.edge, high - 1});
  return true;
}

void Placement::settle_clash(const Clash& clash, std::int64_t high, std::int64_t low) {
  take(clash.gamma, high);
  take(clash.beta, low);
  assign(*clash.site, clash.gamma, high);
  assign(*clash.site, clash.beta, low);
}

}  // namespace ar3d::grid
