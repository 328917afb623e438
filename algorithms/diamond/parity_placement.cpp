// Step 1.8. Any parity class for each vertex instead of even coordinates: X by the green order,
// then the least Y of the right parity for each vertex in red order. At most six values are
// forbidden for a vertex, so the walk never fails; (C1) and (C2) are kept by rules filed under the
// later vertex. O(n). Idea: not in the paper; without a proved box of its own.

#include <tuple>

#include "ar3d/algorithms/diamond/parity.h"
#include "ar3d/base/error.h"
#include "ar3d/base/parallel.h"

namespace ar3d::diamond {
namespace {

/// Y of a vertex without rules that has no Y yet; with rules it is less by one more than the number
/// of its last rule.
constexpr std::int32_t kNotYet = -1;

/// Pairs of vertices at which a difference of Y is forbidden: the later one of them in the red
/// order must not take it. They are what the two vertices before it in that order do not show:
/// closing edges (C1) and one edge of some odd cycles (C2). The lists of rules begin in the
/// vertices' Y.
class ForbiddenDifferences {
 public:
  explicit ForbiddenDifferences(PlanePoints& at) : at_(at) {}
  void add(Vertex u, Vertex v, std::int32_t difference) {
    for (const auto& [vertex, other] : {std::pair{u, v}, std::pair{v, u}}) {
      rules_.emplace_back(other, difference, at_[vertex].Y);
      at_[vertex].Y = kNotYet - static_cast<std::int32_t>(rules_.size());
    }
  }
  /// @param list  Y of the vertex before it got one.
  bool forbid(std::int32_t list, std::int32_t y) const {
    while (list != kNotYet) {
      const auto& [vertex, difference, next] = rules_[static_cast<std::size_t>(kNotYet - list) - 1];
      const std::int32_t other = at_[vertex].Y;
      if (other >= 0 && y - other == difference) return true;
      list = next;
    }
    return false;
  }

 private:
  PlanePoints& at_;
  /// The other vertex, the difference and the vertex's list without this rule.
  std::vector<std::tuple<Vertex, std::int32_t, std::int32_t>> rules_;
};

class ParityPlacer {
 public:
  ParityPlacer(const Graph& graph, Placement& placement)
      : graph_(graph),
        green_(placement.green),
        red_(placement.red),
        at_(placement.at),
        rules_(at_) {}

  /// X is set, Y is kNotYet. False if Y passes 16n/3.
  bool place_y() {
    for_each_cycle(red_, [&](std::uint32_t item) { rule_red_cycle(item); });
    for_each_cycle(green_, [&](std::uint32_t item) { rule_green_cycle(item); });
    return assign_y();
  }

  std::int64_t hits() const { return hits_; }

 private:
  std::int32_t x_distance(Vertex u, Vertex v) const { return std::abs(at_[u].X - at_[v].X); }

  /// Prefetches the ends of items, since there may be many short ones.
  template <class Rule>
  void for_each_cycle(const Items& items, const Rule& rule) const {
    constexpr std::uint32_t kFew = kAhead / 2;
    for (std::uint32_t item = 0; item < items.count(); ++item) {
      if (item + kFew < items.count()) {
        __builtin_prefetch(&at_[items.first(item + kFew)], 1);
        __builtin_prefetch(&at_[items.last(item + kFew)], 1);
      }
      if (items.is_cycle(item)) rule(item);
    }
  }

  /// (C1) for the closing edge. (C2): an odd cycle has a path edge with |dX| >= 2, and then (C1)
  /// makes it fit for a Z, or its first edge has |dX| = 1, odd |dY| != 1 by (C1), and fits unless
  /// |dY| = 3.
  void rule_green_cycle(std::uint32_t item) {
    const auto v = green_.of(item);
    const auto k = static_cast<std::int32_t>(v.size());
    const std::int32_t width = x_distance(v.front(), v.back());
    rules_.add(v.front(), v.back(), width);
    if (k % 2 == 1 && width == k - 1) rules_.add(v[0], v[1], 3);
  }

  /// (C1) for the closing edge. (C2): of an odd cycle some path edge needs |dX| >= 2, and |dY| != 1
  /// if |dX| = 3. If only the closing edge has |dX| >= 2, the others are neighbours along X, and
  /// any other rotation has such a path edge.
  void rule_red_cycle(std::uint32_t item) {
    const std::uint32_t k = red_.size(item);
    if (k % 2 == 1) {
      if (far_path_edge(item) == kNone) red_.close_at(item, 0);
      const std::uint32_t i = far_path_edge(item);
      expect(i != kNone, "an odd red cycle has a path edge of |dX| >= 2");
      const auto v = red_.of(item);
      if (x_distance(v[i], v[i + 1]) == 3) rules_.add(v[i + 1], v[i], 1);
    }
    rules_.add(red_.last(item), red_.first(item), x_distance(red_.first(item), red_.last(item)));
  }

  /// A path edge with |dX| >= 2, rather not 3.
  std::uint32_t far_path_edge(std::uint32_t item) const {
    const auto v = red_.of(item);
    std::uint32_t found = kNone;
    for (std::uint32_t i = 0; i + 1 < v.size(); ++i) {
      const std::int32_t far = x_distance(v[i], v[i + 1]);
      if (far == 2 || far > 3) return i;
      if (far == 3) found = i;
    }
    return found;
  }

  /// Each vertex in red order takes the least Y of its parity above the one before that is not
  /// forbidden.
  bool assign_y() {
    const auto limit = static_cast<std::int32_t>(std::uint64_t{16} * at_.size() / 3);
    std::int32_t y = -1;
    for (std::uint32_t item = 0; item < red_.count(); ++item) {
      for (std::uint32_t i = red_.begin[item]; i < red_.begin[item + 1]; ++i) {
        if (i + kAhead < at_.size()) __builtin_prefetch(&at_[red_.vertex[i + kAhead]], 1);
        PlanePoint& p = at_[red_.vertex[i]];
        y += (p.X - y) % 2 == 0 ? 2 : 1;
        while (clashes(i, i > red_.begin[item], y) || rules_.forbid(p.Y, y)) {
          y += 2;
          ++hits_;
        }
        p.Y = y;
      }
      if (y > limit) return false;
    }
    return true;
  }

  /// (C1) for path edges to earlier vertices. The red one leads to the vertex just before. A green
  /// one has |dX| <= 2, so it matters only for |dY| <= 2, that is for the two vertices before at
  /// most.
  bool clashes(std::uint32_t i, bool continues_item, std::int32_t y) const {
    const Vertex v = red_.vertex[i];
    for (std::uint32_t back = 1; back <= 2 && back <= i; ++back) {
      const Vertex w = red_.vertex[i - back];
      if (y - at_[w].Y != x_distance(v, w)) continue;
      if ((back == 1 && continues_item) || adjacent(graph_, v, w)) return true;
    }
    return false;
  }

  const Graph& graph_;
  const Items& green_;
  Items& red_;
  PlanePoints& at_;
  ForbiddenDifferences rules_;
  std::int64_t hits_ = 0;
};

std::optional<std::pair<Placement, std::int64_t>> finish(const Graph& graph, Placement placement) {
  ParityPlacer placer(graph, placement);
  if (!placer.place_y()) return std::nullopt;
  expect_heavy([&] { return keeps_invariants(graph, placement); },
               "the compact placement is right");
  return std::pair{std::move(placement), placer.hits()};
}

/// @param x_of  X by rank in the green order.
template <class XOf>
std::optional<std::pair<Placement, std::int64_t>> place_by_rank(const Graph& graph, Items green,
                                                                Items red, XOf x_of) {
  Placement placement{std::move(green), std::move(red), {}};
  const auto& order = placement.green.vertex;
  PlanePoints& at = placement.at;
  at.resize(order.size());
  const auto threads = threads_for(order.size());
  for_ranges_in_threads(
      threads, order.size(), [&](std::uint32_t, std::size_t begin, std::size_t end) {
        for_each_ahead(order, at, begin, end, [&](std::size_t i, PlanePoint& point) {
          point = {x_of(static_cast<std::int32_t>(i)), kNotYet};
        });
      });
  return finish(graph, std::move(placement));
}

}  // namespace

std::optional<std::pair<Placement, std::int64_t>> place_alternating(const Graph& graph, Items green,
                                                                    Items red) {
  return place_by_rank(graph, std::move(green), std::move(red),
                       [](std::int32_t rank) { return rank; });
}

std::optional<std::pair<Placement, std::int64_t>> place_in_pairs(const Graph& graph, Items green,
                                                                 Items red) {
  return place_by_rank(graph, std::move(green), std::move(red),
                       [](std::int32_t rank) { return rank / 2 * 3 + rank % 2 * 2; });
}

std::optional<std::pair<Placement, std::int64_t>> place_by_parity(
    const Graph& graph, Items green, Items red, const std::vector<std::uint8_t>& parity) {
  Placement placement{std::move(green), std::move(red), {}};
  placement.at.resize(parity.size());
  std::int32_t x = -1;
  for (const Vertex v : placement.green.vertex) {
    x += (parity[v] - x) % 2 == 0 ? 2 : 1;
    placement.at[v] = {x, kNotYet};
  }
  return finish(graph, std::move(placement));
}

}  // namespace ar3d::diamond
