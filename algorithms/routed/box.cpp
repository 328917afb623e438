// Step R.4, the prices of points (PathFinder; McMurchie and Ebeling 1995): a point costs more the
// more routes pass it, and the longer it has been wanted by several. Costs are kept for each point,
// since searches read many points and routes change few. Only lists of shared points are swept, so
// a round costs what its routes do: O(length of the routes).
#include "ar3d/algorithms/routed/box.h"

#include <algorithm>

namespace ar3d::routed {

namespace {

/// Rounded down to even coordinates, so that parities stay those of the points.
Spot even(Spot p) { return {p.x & ~1, p.y & ~1, p.z & ~1}; }

std::int64_t num_points(const PointClass& points, const Limits& limits) {
  const Spot sides = limits.high - even(limits.low) + Spot{1, 1, 1};
  const std::int64_t rows = points.is_body() ? (sides.y + 1) / 2 : sides.y;
  return sides.x * rows * ((sides.z + 1) / 2);
}

}  // namespace

std::int64_t CostBox::bytes(const PointClass& points, const Limits& limits) {
  return num_points(points, limits) * kBytesPerPoint;
}

CostBox::CostBox(const PointClass& points, const Limits& limits)
    : is_body_(points.is_body()), limits_(limits) {
  const Spot sides = limits.high - even(limits.low) + Spot{1, 1, 1};
  rows_ = is_body_ ? (sides.y + 1) / 2 : sides.y;
  layers_ = (sides.z + 1) / 2;
  origin_ = index(even(limits.low));
  const auto count = static_cast<std::size_t>(num_points(points, limits));
  costs_.assign(count, 0);
  history_.assign(count, 0);
  uses_.assign(count, 0);
  for (int d = 0; d < points.num_directions(); ++d) {
    const Spot step = points.step(d);
    flips_[static_cast<std::size_t>(d)] = step.z & 1;
    for (int side = 0; side < 2; ++side) {
      const Spot from = is_body_ ? Spot{2 + side, 2 + side, 2 + side} : Spot{2, 2 + side, 2 + side};
      strides_[static_cast<std::size_t>(side)][static_cast<std::size_t>(d)] =
          index(from + step) - index(from);
    }
  }
}

void CostBox::set_cost(std::size_t i) {
  const int routes = uses_[i] & kMostUses;
  const int users = routes + (uses_[i] & kVertex ? kVertexUses : 0);
  costs_[i] = static_cast<std::uint16_t>(
      routes == kMostUses ? kBlocked : std::min(kBlocked - 1, history_[i] + price_ * users));
}

void CostBox::set_uses(int i, int uses) {
  const auto at = static_cast<std::size_t>(i);
  uses_[at] = static_cast<std::uint8_t>(uses);
  set_cost(at);
}

void CostBox::put_vertex(int i) {
  if (uses(i) > 0) shared_.push_back(i);
  set_uses(i, uses(i) | kVertex);
}

void CostBox::put(Spot from, const Route& route) {
  walk(from, route, [this](int i) {
    if (uses(i) == 1 || has_vertex(i)) shared_.push_back(i);
    set_uses(i, uses_[static_cast<std::size_t>(i)] + 1);
  });
}

void CostBox::take(Spot from, const Route& route) {
  walk(from, route, [this](int i) { set_uses(i, uses_[static_cast<std::size_t>(i)] - 1); });
}

int CostBox::cost_of(Spot from, const Route& route) const {
  if (!route) return kNoRoute;
  int total = 0;
  bool is_blocked = false;
  walk(from, route, [&](int i) {
    is_blocked |= cost(i) == kBlocked;
    total += cost(i) + kStep;
  });
  return is_blocked ? kNoRoute : std::min(total + kStep, kNoRoute);
}

bool CostBox::is_shared(Spot from, const Route& route) const {
  bool shared = !route;
  walk(from, route, [&](int i) { shared |= uses(i) > 1 || has_vertex(i); });
  return shared;
}

void CostBox::remember_shared(int increase) {
  std::sort(shared_.begin(), shared_.end());
  shared_.erase(std::unique(shared_.begin(), shared_.end()), shared_.end());
  const auto others = [this](int i) { return uses(i) + (has_vertex(i) ? 1 : 0) - 1; };
  std::erase_if(shared_, [&](int i) { return others(i) < 1; });
  for (const int i : shared_) {
    const auto at = static_cast<std::size_t>(i);
    history_[at] =
        static_cast<std::uint16_t>(std::min(kMostHistory, history_[at] + increase * others(i)));
    set_cost(at);
  }
}

void CostBox::refresh(Spot from, const Route& route) {
  walk(from, route, [this](int i) { refresh(i); });
}

}  // namespace ar3d::routed
