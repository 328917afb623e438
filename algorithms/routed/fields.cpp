// Step R.3, what it costs at least to reach each point: Lee's wave (1961) as dynamic programming
// over bends and last directions. The field of a direction is swept row by row along it. Rows are
// vectors of 16-bit costs: eight points take the time that one took in a search by a queue, which
// was dropped. A row holds only what routes of the length asked for can reach.
// Cost: O(bends x directions x points of the window).
#include "ar3d/algorithms/routed/fields.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace ar3d::routed {
namespace {

using Cost = CostFields::Cost;
static_assert(2 * CostFields::kInfinite <= std::numeric_limits<Cost>::max(), "sums of two fit");

/// Eight points of a row: the cheapest of the ways there, and their own costs.
template <std::size_t kTurns>
inline void relax(Cost* __restrict out, const Cost* cost, const Cost* on,
                  const std::array<const Cost*, kTurns>& turns, std::ptrdiff_t at) {
  for (int k = 0; k < CostFields::kVector; ++k) {
    Cost least = on[k];
    for (std::size_t t = 0; t < kTurns; ++t) least = std::min(least, turns[t][at + k]);
    out[k] = std::min(static_cast<Cost>(least + cost[k]), CostFields::kInfinite);
  }
}

/// Eight costs, or others if they are less.
inline void lower(Cost* __restrict out, const Cost* costs) {
  for (int k = 0; k < CostFields::kVector; ++k) out[k] = std::min(out[k], costs[k]);
}

int distance(int a, int b, int radius) { return std::max(0, std::abs(a - b) - radius); }

}  // namespace

/// In each row the points that routes of at most so many steps may reach: the larger differences of
/// coordinates to both ends are at most that in sum. Rows differ by at most 2 from those a step away.
/// @return the size of a field.
int CostFields::choose_rows(const CostBox& box, Spot to, int radius, int steps, Spot high) {
  const Spot low = box.limits().low - low_;
  parts_.assign(row(high.x + 2, 0), {});
  used_.clear();
  int size = high.z / 2 + kVector + 2 * kPad;  // of an empty row
  for (int x = std::max(0, low.x); x <= high.x; ++x) {
    for (int y = std::max(0, low.y); y <= high.y; ++y) {
      if (points_.is_body() && ((x ^ y) & 1) != 0) continue;
      const int a = std::max(std::abs(x - from_.x), std::abs(y - from_.y));
      const int b = std::max(distance(x, to.x, radius), distance(y, to.y, radius));
      if (a + b > steps) continue;
      const int z0 = std::max({from_.z - (steps - b), to.z - radius - (steps - a), low.z, 0});
      const int z1 = std::min({from_.z + (steps - b), to.z + radius + (steps - a), high.z});
      const int side = parity(x, y);
      const int first = (z0 - side + 1) >> 1;
      const int count = ((z1 - side + 2) >> 1) - first;
      if (count <= 0) continue;
      const int vectors = (count + kVector - 1) / kVector;
      parts_[row(x, y)] = {size + kPad - first,
                           first,
                           vectors,
                           count,
                           box.index(low_ + Spot{x, y, 2 * first + side}),
                           static_cast<std::size_t>(side)};
      used_.push_back(row(x, y));
      size += vectors * kVector + 2 * kPad;
    }
  }
  return size + 2 * kVector;
}

/// What it costs to pass the points of the rows.
void CostFields::copy_costs(const CostBox& box, int size) {
  costs_.assign(static_cast<std::size_t>(size), kInfinite);
  for (const std::size_t r : used_) {
    const Row& part = parts_[r];
    Cost* to = costs_.data() + part.base + part.first;
    for (int k = 0; k < part.points; ++k) {
      to[k] =
          static_cast<Cost>(std::min<int>(kInfinite, box.cost(part.in_box + k) + CostBox::kStep));
    }
  }
}

/// Fields for the directions that so many turns lead to.
void CostFields::allot(int layers, Directions first) {
  num_layers_ = layers;
  std::vector<Cost**> used;
  for (int layer = 0; layer < layers; ++layer) {
    Directions next = 0;
    for (int d = 0; d < points_.num_directions(); ++d) {
      Cost*& field = fields_[static_cast<std::size_t>(layer)][static_cast<std::size_t>(d)];
      field = nullptr;
      if (!has(first, d)) continue;
      used.push_back(&field);
      next = static_cast<Directions>(next | points_.turns(d));
    }
    first = next;
  }
  if (storage_.size() < used.size() * costs_.size()) storage_.resize(used.size() * costs_.size());
  for (std::size_t i = 0; i < used.size(); ++i) *used[i] = storage_.data() + i * costs_.size();
}

bool CostFields::open(const CostBox& box, const End& from, Spot to, int radius, int steps,
                      int layers) {
  const Limits& limits = box.limits();
  const auto range = [&](int a, int b, int least, int most) {
    const int slack = std::max(0, steps - distance(a, b, radius)) / 2;
    return std::array{std::max(least, std::min(a, b - radius) - slack),
                      std::min(most, std::max(a, b + radius) + slack)};
  };
  const auto [x0, x1] = range(from.at.x, to.x, limits.low.x, limits.high.x);
  const auto [y0, y1] = range(from.at.y, to.y, limits.low.y, limits.high.y);
  const auto [z0, z1] = range(from.at.z, to.z, limits.low.z, limits.high.z);
  low_ = {x0 & ~1, y0 & ~1, z0 & ~1};
  from_ = from.at - low_;
  const Spot high = Spot{x1, y1, z1} - low_;
  rows_ = (points_.is_body() ? high.y / 2 : high.y) + 3;
  const Spot end = to - low_;
  copy_costs(box, choose_rows(box, end, radius, steps, high));
  costs_[index(from_)] = kInfinite;
  const Spot apart = end - from_;
  const int least = std::max({std::abs(apart.x), std::abs(apart.y), std::abs(apart.z)});
  if (radius == 0) costs_[index(end)] = kInfinite;
  if (radius > 0 && least <= steps) costs_[index(end)] = CostBox::kStep;
  allot(layers, from.arms);
  fill_rays();
  for (int layer = 1; layer < layers; ++layer) {
    for (int d = 0; d < points_.num_directions(); ++d) {
      if (!field(layer, d)) continue;
      points_.is_body() ? sweep<3>(layer, d) : sweep<4>(layer, d);
    }
  }
  return x0 > limits.low.x || x1 < limits.high.x || y0 > limits.low.y || y1 < limits.high.y ||
         z0 > limits.low.z || z1 < limits.high.z || steps < 2 * (limits.longest() + radius);
}

/// The routes without a bend.
void CostFields::fill_rays() {
  for (int d = 0; d < points_.num_directions(); ++d) {
    Cost* field = fields_[0][static_cast<std::size_t>(d)];
    if (!field) continue;
    std::fill(field, field + costs_.size(), kInfinite);
    int total = 0;
    for (Spot p = from_ + points_.step(d);; p = p + points_.step(d)) {
      total += costs_[index(p)];
      if (total >= kInfinite) break;
      field[index(p)] = static_cast<Cost>(total);
    }
  }
}

/// One field: each point is reached from the point before it, straight on or after a turn.
template <std::size_t kTurns>
void CostFields::sweep(int layer, int d) {
  const Spot step = points_.step(d);
  Cost* field = fields_[static_cast<std::size_t>(layer)][static_cast<std::size_t>(d)];
  std::array<const Cost*, kTurns> turns{};
  std::size_t found = 0;
  for (int e = 0; e < points_.num_directions(); ++e) {
    const Cost* source = this->field(layer - 1, e);
    if (source && has(points_.turns(e), d)) turns[found++] = source;
  }
  for (std::size_t i = found; i < kTurns; ++i) turns[i] = turns[0];
  std::array<std::size_t, 2> rows_before{};  // modulo 2^64
  std::array<int, 2> shift{};
  for (int side = 0; side < 2; ++side) {
    const Spot p = {points_.is_body() ? 2 + side : 2, 2 + side, 0};
    rows_before[static_cast<std::size_t>(side)] = row(p.x - step.x, p.y - step.y) - row(p.x, p.y);
    shift[static_cast<std::size_t>(side)] = (side - step.z) >> 1;
  }
  const auto fill_row = [&](std::size_t r) {
    const Row& part = parts_[r];
    const Row& before = parts_[r + rows_before[part.parity]];
    Cost* out = field + part.base + part.first;
    const int count = part.vectors * kVector;
    out[-2] = out[-1] = out[count] = out[count + 1] = kInfinite;
    if (before.vectors == 0) {
      std::fill(out, out + count, kInfinite);
      return;
    }
    const Cost* cost = costs_.data() + part.base + part.first;
    const std::ptrdiff_t at = before.base + part.first + shift[part.parity];
    for (int k = 0; k < count; k += kVector) {
      relax<kTurns>(out + k, cost + k, field + at + k, turns, at + k);
    }
  };
  if (step.x > 0 || (step.x == 0 && step.y > 0)) {
    std::for_each(used_.begin(), used_.end(), fill_row);
  } else {
    std::for_each(used_.rbegin(), used_.rend(), fill_row);
  }
}

void CostFields::write_arrivals(int d, std::span<const Spot> rows, std::span<Cost> costs) const {
  std::array<const Cost*, kMostBends + 1> sources{};
  std::size_t found = 0;
  for (int layer = 0; layer < num_layers_; ++layer) {
    if (field(layer, d)) sources[found++] = field(layer, d);
  }
  const int count = static_cast<int>(costs.size() / rows.size());
  std::fill(costs.begin(), costs.end(), kInfinite);
  Cost* out = costs.data();
  for (std::size_t r = 0; r < rows.size(); ++r, out += count) {
    const Spot p = rows[r] - low_;
    const Row& part = parts_[row(p.x, p.y)];
    const int first = p.z >> 1;
    for (std::size_t t = 0; t < found; ++t) {
      for (int k = 0; k < count; k += kVector) {
        lower(out + k, sources[t] + part.base + first + k);
      }
    }
    const int begin = std::clamp(part.first - first, 0, count);
    const int end = std::clamp(part.first + part.vectors * kVector - first, begin, count);
    std::fill(out, out + begin, kInfinite);
    std::fill(out + end, out + count, kInfinite);
  }
}

}  // namespace ar3d::routed
