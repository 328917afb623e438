// Steps 1.3 to 1.6 in the order of the proof, with the count H of Lemma 1.5. Rotations, x, bumps
// and offsets come in an order in which no step undoes an earlier one, which the paper's shifting
// does not have. An offset is the least free value among at most (closing edges + 1) forbidden
// ones. O(n).
#include "ar3d/algorithms/diamond/guaranteed.h"

#include "ar3d/base/error.h"
#include "ar3d/base/parallel.h"

namespace ar3d::diamond {
namespace {

// Coordinates here are x = X/2 and y = Y/2 until the last step.

/// Calls set(at[v], position, item) for every vertex, in threads.
template <class Set>
void set_points(const Items& items, PlanePoints& at, const Set& set) {
  const std::vector<Vertex>& order = items.vertex;
  for_ranges_in_threads(threads_for(order.size()), order.size(),
                        [&](std::uint32_t, std::size_t begin, std::size_t end) {
                          for_each_position(items, begin, end,
                                            [&](std::uint32_t p, std::uint32_t item) {
                                              if (p + kAhead < order.size())
                                                __builtin_prefetch(&at[order[p + kAhead]], 1);
                                              set(at[order[p]], p, item);
                                            });
                        });
}

/// Step 1.4. Neighbouring lines, except for a free one at each bad boundary of the green order.
std::int64_t assign_x(const Graph& graph, const Items& green, PlanePoints& at) {
  const std::vector<bool> bad = bad_boundaries(graph, green);
  std::vector<std::int32_t> gaps(green.count());  // before the item
  std::int32_t gap = 0;
  for (std::uint32_t item = 0; item < green.count(); ++item) gaps[item] = gap += bad[item];
  set_points(green, at, [&](PlanePoint& point, std::uint32_t p, std::uint32_t item) {
    point = {static_cast<std::int32_t>(p) + gaps[item], 0};
  });
  return gap;
}

/// Step 1.6. Each red item stands rigidly on the least line above the earlier ones on which no
/// green closing edge to an earlier item has |dx| = |dy|, and not right above a bad boundary.
class RedStack {
 public:
  /// @param red      in the order of the stack.
  /// @param begin    of the natural items.
  RedStack(const Items& red, const Arrangement& order, const std::vector<std::uint32_t>& begin,
           const RedCycles& cycles, const Whereabouts& natural)
      : red_(red),
        order_(order),
        begin_(begin),
        cycles_(cycles),
        natural_(natural),
        number_(red.count()),
        base_(red.count()) {
    for (std::uint32_t i = 0; i < red.count(); ++i) number_[order[i].item] = i;
  }

  /// The sum of the offsets.
  std::int64_t stack(const std::vector<GreenClosing>& closings, const std::vector<bool>& bad,
                     const PlanePoints& at) {
    file(closings);
    std::int64_t offsets = 0;
    std::int32_t top = 0;
    for (std::uint32_t item = 0; item < red_.count(); ++item) {
      const std::int32_t g = offset(item, bad[item], top, at);
      offsets += g;
      base_[item] = top + g;
      top = y(item, red_.size(item) - 1) + 1;
    }
    return offsets;
  }

  /// y of an index of an item in the stack.
  std::int32_t y(std::uint32_t item, std::uint32_t index) const {
    const auto [natural, reversed] = order_[item];
    const auto [down, up] = cycles_.bumps[natural];
    std::int32_t y = base_[item] + static_cast<std::int32_t>(index);
    if (index == 0) return y;
    y += reversed ? up : down;
    return index + 1 == red_.size(item) ? y + (reversed ? down : up) : y;
  }

 private:
  /// Item in the stack, and index there.
  std::pair<std::uint32_t, std::uint32_t> where(Vertex v) const {
    const auto [position, natural] = natural_[v];
    const std::uint32_t item = number_[natural];
    const std::uint32_t size = red_.size(item);
    const std::uint32_t turned = cycles_.turned[natural];
    const std::uint32_t index = (position - begin_[natural] + size - turned) % size;
    return {item, order_[item].reversed ? size - 1 - index : index};
  }

  void file(const std::vector<GreenClosing>& closings) {
    late_.resize(red_.count());
    for (const auto& [u, w, contained_in] : closings) {
      if (contained_in != kNone) continue;
      const bool is_later = where(w) < where(u);
      late_[where(is_later ? u : w).first].push_back(is_later ? Edge{u, w} : Edge{w, u});
    }
  }

  std::int32_t offset(std::uint32_t item, bool bad, std::int32_t top, const PlanePoints& at) {
    forbidden_.clear();
    if (bad) forbidden_.push_back(0);
    for (const auto [u, w] : late_[item]) {
      const std::int32_t without = y(item, where(u).second);  // base_ is 0 so far
      const auto [other_item, index] = where(w);
      forbidden_.push_back(y(other_item, index) + x_distance(at, u, w) - top - without);
    }
    if (forbidden_.empty()) return 0;
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
  const Arrangement& order_;
  const std::vector<std::uint32_t>& begin_;
  const RedCycles& cycles_;
  const Whereabouts& natural_;
  std::vector<std::uint32_t> number_;    ///< in the stack, by natural item
  std::vector<std::int32_t> base_;       ///< y of the items' first vertices
  std::vector<std::vector<Edge>> late_;  ///< by item the green closing edges to earlier items
  std::vector<std::int32_t> forbidden_;
};

}  // namespace

std::pair<Placement, GapCount> place_guaranteed(const Graph& graph, Items green, Items red) {
  std::pair<Placement, GapCount> result;
  auto& [placement, gaps] = result;
  auto& at = placement.at;
  at.resize(graph.num_vertices());
  gaps.m_green = count_cycles(green);
  gaps.m_red = count_cycles(red);

  const Whereabouts natural = whereabouts(red);
  const std::vector<GreenClosing> closings = close_green_cycles(green, natural);
  const Arrangement green_order = order_items(graph, green);
  placement.green = arranged(std::move(green), green_order);
  gaps.green_gaps = assign_x(graph, placement.green, at);
  // Nothing below changes an x; nothing after settle_red_cycles changes distances inside a red
  // item.
  const RedCycles cycles = settle_red_cycles(red, closings, at, natural);
  gaps.contained = cycles.contained;
  gaps.rho = cycles.rho;
  gaps.bumps = cycles.lines;
  const Arrangement order = order_items(graph, red);
  const std::vector<std::uint32_t> natural_begin = red.begin;
  placement.red = arranged(std::move(red), order);
  const std::vector<bool> bad = bad_boundaries(graph, placement.red);
  gaps.red_gaps = std::count(bad.begin(), bad.end(), true);
  RedStack stack(placement.red, order, natural_begin, cycles, natural);
  gaps.offsets = stack.stack(closings, bad, at);
  const std::vector<std::uint32_t>& begin = placement.red.begin;
  set_points(placement.red, at, [&](PlanePoint& point, std::uint32_t p, std::uint32_t item) {
    point = {2 * point.X, 2 * stack.y(item, p - begin[item])};
  });
  expect_heavy([&] { return keeps_invariants(graph, result.first); },
               "the guaranteed placement is right");
  return result;
}

}  // namespace ar3d::diamond
