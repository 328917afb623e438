// Step R.3, what it costs at least to reach each point: dynamic programming over bends and last
// directions. The field of one direction is swept row after row, along that direction. Rows are
// vectors of 16-bit costs, so eight points take the time that one takes in a search by a queue.
// Cost: O(bends x directions x points of the window).
#include "ar3d/algorithms/routed/fields.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace ar3d::routed {
namespace {

using Cost = CostFields::Cost;
static_assert(2 * CostFields::kInfinite <= std::numeric_limits<Cost>::max(), "sums of two fit");

/// Eight points of a row: the cheapest of five ways there, and their own costs.
inline void relax(Cost* __restrict out, const Cost* cost, const Cost* on, const Cost* a,
                  const Cost* b, const Cost* c, const Cost* d) {
  for (int k = 0; k < CostFields::kVector; ++k) {
    const Cost least = std::min(std::min(std::min(on[k], a[k]), std::min(b[k], c[k])), d[k]);
    out[k] = std::min(static_cast<Cost>(least + cost[k]), CostFields::kInfinite);
  }
}

int distance(int a, int b, int radius) { return std::max(0, std::abs(a - b) - radius); }

}  // namespace

bool CostFields::is_open(Spot p) const {
  if (p.x < 0 || p.x >= width_ || p.z < 0 || p.z >= 2 * (stride_ - 1)) return false;
  const auto [low, high] = clip_[static_cast<std::size_t>(p.x)];
  return p.y >= low && p.y <= high;
}

/// For each x the range of y that routes of at most so many steps may reach.
void CostFields::clip_rows(Spot to, int radius, int steps) {
  for (int x = 0; x < width_; ++x) {
    const int a = std::abs(x - from_.x);
    const int b = distance(x, to.x, radius);
    const auto is_reached = [&](int y) {
      return std::max(a, std::abs(y - from_.y)) + std::max(b, distance(y, to.y, radius)) <= steps;
    };
    auto& [low, high] = clip_[static_cast<std::size_t>(x)];
    while (low <= high && !is_reached(low)) ++low;
    while (low <= high && !is_reached(high)) --high;
  }
}

void CostFields::copy_costs(const CostBox& box) {
  const Limits& limits = box.limits();
  for (int x = 0; x < width_; ++x) {
    const auto [low, high] = clip_[static_cast<std::size_t>(x)];
    for (int y = low; y <= high; ++y) {
      if (points_.is_body() && ((x ^ y) & 1) != 0) continue;
      Cost* to = &costs_[static_cast<std::size_t>(row(x, y) * stride_) + 1];
      std::fill(to, to + stride_ - 1, kInfinite);
      const int first = low_.z + parity(x, y);  // z of k = 0
      const int begin = first >= limits.low.z ? 0 : (limits.low.z - first + 1) / 2;
      const int end = std::min(stride_ - 1, (limits.high.z - first + 2) / 2);
      if (begin >= end) continue;
      const int i = box.index({low_.x + x, low_.y + y, first + 2 * begin}) - begin;
      for (int k = begin; k < end; ++k) {
        to[k] = static_cast<Cost>(std::min<int>(kInfinite, box.cost(i + k) + CostBox::kStep));
      }
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
    return Range{std::max(least, std::min(a, b - radius) - slack),
                 std::min(most, std::max(a, b + radius) + slack)};
  };
  const auto [x0, x1] = range(from.at.x, to.x, limits.low.x, limits.high.x);
  const auto [y0, y1] = range(from.at.y, to.y, limits.low.y, limits.high.y);
  const auto [z0, z1] = range(from.at.z, to.z, limits.low.z, limits.high.z);
  low_ = {x0 & ~1, y0 & ~1, z0 & ~1};
  from_ = from.at - low_;
  width_ = x1 - low_.x + 1;
  const int height = y1 - low_.y + 1;
  rows_ = points_.is_body() ? (height + 1) / 2 : height;
  stride_ = ((z1 - low_.z) / 2 + kVector) / kVector * kVector + 1;
  clip_.assign(static_cast<std::size_t>(width_), {y0 - low_.y, y1 - low_.y});
  if (low_.x < x0) clip_[0] = {1, 0};
  clip_rows(to - low_, radius, steps);
  costs_.resize(static_cast<std::size_t>(row(width_, 0) * stride_) + kVector);
  copy_costs(box);
  costs_[index(from_)] = kInfinite;
  const Spot end = to - low_;
  if (is_open(end)) costs_[index(end)] = radius == 0 ? kInfinite : CostBox::kStep;
  allot(layers, from.arms);
  fill_rays();
  for (int layer = 1; layer < layers; ++layer) {
    for (int d = 0; d < points_.num_directions(); ++d) {
      if (field(layer, d)) sweep(layer, d);
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
    for (Spot p = from_ + points_.step(d); is_open(p); p = p + points_.step(d)) {
      total += costs_[index(p)];
      if (total >= kInfinite) break;
      field[index(p)] = static_cast<Cost>(total);
    }
  }
}

/// One field: each point is reached from the point before it, straight on or after a turn.
void CostFields::sweep(int layer, int d) {
  const Spot step = points_.step(d);
  Cost* field = fields_[static_cast<std::size_t>(layer)][static_cast<std::size_t>(d)];
  std::array<const Cost*, 4> sources{};
  std::size_t num_sources = 0;
  for (int e = 0; e < points_.num_directions(); ++e) {
    const Cost* source = this->field(layer - 1, e);
    if (source && has(points_.turns(e), d)) sources[num_sources++] = source;
  }
  for (std::size_t i = num_sources; i < sources.size(); ++i) sources[i] = sources[0];
  const int count = stride_ - 1;
  for (int i = 0; i < width_; ++i) {
    const int x = step.x >= 0 ? i : width_ - 1 - i;
    const auto [low, high] = clip_[static_cast<std::size_t>(x)];
    for (int j = low; j <= high; ++j) {
      const int y = step.x != 0 || step.y > 0 ? j : high + low - j;
      if (points_.is_body() && ((x ^ y) & 1) != 0) continue;
      Cost* out = field + row(x, y) * stride_ + 1;
      out[-1] = out[count] = kInfinite;
      const Spot before = {x - step.x, y - step.y, 0};
      if (!is_open(before)) {
        std::fill(out, out + count, kInfinite);
        continue;
      }
      const int shift = (parity(x, y) - step.z - parity(before.x, before.y)) / 2;
      const std::ptrdiff_t at = row(before.x, before.y) * stride_ + 1 + shift;
      const Cost* cost = costs_.data() + row(x, y) * stride_ + 1;
      for (int k = 0; k < count; k += kVector) {
        relax(out + k, cost + k, field + at + k, sources[0] + at + k, sources[1] + at + k,
              sources[2] + at + k, sources[3] + at + k);
      }
    }
  }
}

}  // namespace ar3d::routed
