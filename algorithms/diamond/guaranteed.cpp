// Steps 1.3 to 1.6 in the order of the proof, with the count H of Lemma 1.5. Rotations, x, bumps
// and offsets come in an order in which no step undoes an earlier one, which the paper's shifting
// does not have. An offset is the least free value among at most (closing edges + 1) forbidden
// ones. O(n).
#include "ar3d/algorithms/diamond/guaranteed.h"

#include <algorithm>

#include "ar3d/algorithms/diamond/buckets.h"
#include "ar3d/algorithms/diamond/cycles.h"
#include "ar3d/algorithms/diamond/ordering.h"
#include "ar3d/model/error.h"
#include "ar3d/model/long_vector.h"

namespace ar3d::diamond {
namespace {

// Coordinates here are x = X/2 and y = Y/2 until the last step.

/// Step 1.4. Neighbouring lines, but for a free one at each bad boundary of the green order.
std::int64_t assign_x(const Graph& graph, const Items& green, std::vector<PlanePoint>& at) {
  const std::vector<bool> bad = bad_boundaries(graph, green);
  std::int32_t x = 0;
  for (std::uint32_t item = 0; item < green.count(); ++item) {
    x += bad[item];
    for (const Vertex v : green.of(item)) at[v].X = x++;
  }
  return std::count(bad.begin(), bad.end(), true);
}

/// y of the item's vertices relative to its first one.
void assign_relative_y(const Items& red, std::uint32_t item, Bump bump,
                       std::vector<PlanePoint>& at) {
  const auto v = red.of(item);
  std::int32_t y = 0;
  for (std::size_t i = 0; i < v.size(); ++i, ++y) {
    if (i == 1) y += bump.first;
    if (i > 0 && i + 1 == v.size()) y += bump.last;
    at[v[i]].Y = y;
  }
}

/// Step 1.6. Each red item stands rigidly on the least line above the earlier ones on which no
/// green closing edge to an earlier item has |dx| = |dy|, and not right above a bad boundary.
class RedStack {
 public:
  RedStack(const Items& red, const std::vector<GreenClosing>& closings,
           const std::vector<bool>& bad, std::vector<PlanePoint>& at)
      : red_(red), closings_(closings), bad_(bad), at_(at), late_(red.count(), closings.size()) {
    const Whereabouts where = whereabouts(red);
    for (std::uint32_t i = 0; i < closings.size(); ++i) {
      if (closings[i].contained_in != kNone) continue;
      auto [u, w, unused] = closings[i];
      if (where.position[u] < where.position[w]) std::swap(u, w);
      closings_[i] = {u, w, kNone};  // u is in the later item
      late_.add(where.item[u], i);
    }
  }

  std::int64_t run() {
    std::int64_t offsets = 0;
    std::int32_t base = 0;
    for (std::uint32_t item = 0; item < red_.count(); ++item) {
      const std::int32_t g = offset(item, base);
      offsets += g;
      for (const Vertex v : red_.of(item)) at_[v].Y += base + g;
      base = at_[red_.last(item)].Y + 1;
    }
    return offsets;
  }

 private:
  std::int32_t offset(std::uint32_t item, std::int32_t base) {
    forbidden_.clear();
    if (bad_[item]) forbidden_.push_back(0);
    late_.for_each(item, [&](std::uint32_t i) {
      const auto [u, w, unused] = closings_[i];
      forbidden_.push_back(at_[w].Y + x_distance(at_, u, w) - base - at_[u].Y);
    });
    std::vector<bool> is_forbidden(forbidden_.size() + 1,
                                   false);  // some value up to the size is free
    for (const std::int32_t g : forbidden_) {
      if (g >= 0 && static_cast<std::size_t>(g) < is_forbidden.size()) {
        is_forbidden[static_cast<std::size_t>(g)] = true;
      }
    }
    const auto free = std::find(is_forbidden.begin(), is_forbidden.end(), false);
    return static_cast<std::int32_t>(free - is_forbidden.begin());
  }

  const Items& red_;
  std::vector<GreenClosing> closings_;
  const std::vector<bool>& bad_;
  std::vector<PlanePoint>& at_;
  Buckets late_;
  std::vector<std::int32_t> forbidden_;
};

}  // namespace

GuaranteedPlacement place_guaranteed(const Graph& graph, Items green, Items red) {
  GuaranteedPlacement result;
  Placement& placement = result.placement;
  GapCount& gaps = result.gaps;
  auto& at = placement.at;
  reserve_long(at, graph.num_vertices());
  at.resize(graph.num_vertices());
  gaps.m_green = count_cycles(green);
  gaps.m_red = count_cycles(red);

  Whereabouts natural = whereabouts(red);
  const std::vector<GreenClosing> closings = close_green_cycles(green, natural);
  placement.green = arranged(green, order_items(graph, green));
  green = {};  // here and below: memory that is not needed any more
  gaps.green_gaps = assign_x(graph, placement.green, at);
  // Nothing below changes an x; nothing after settle_red_cycles changes distances inside a red
  // item.
  const RedCycles cycles = settle_red_cycles(red, closings, at, natural);
  natural = {};
  gaps.contained = cycles.contained;
  gaps.rho = cycles.rho;
  gaps.bumps = cycles.lines;
  const Arrangement order = order_items(graph, red);
  placement.red = arranged(red, order);
  red = {};
  for (std::uint32_t i = 0; i < placement.red.count(); ++i) {
    const auto [item, reversed] = order.places[i];
    const Bump bump = cycles.bumps[item];
    assign_relative_y(placement.red, i, reversed ? Bump{bump.last, bump.first} : bump, at);
  }
  const std::vector<bool> bad = bad_boundaries(graph, placement.red);
  gaps.red_gaps = std::count(bad.begin(), bad.end(), true);
  gaps.offsets = RedStack(placement.red, closings, bad, at).run();
  for (PlanePoint& p : at) p = {2 * p.X, 2 * p.Y};
  expect_heavy([&] { return keeps_invariants(graph, placement); },
               "the guaranteed placement is right");
  return result;
}

}  // namespace ar3d::diamond
