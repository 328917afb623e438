// Steps 1.3 and 1.5, Lemma 1.4. The paper shifts a cycle when its closing edge has |dX| = |dY|,
// and claims that nothing else changes; it does (docs/theorem1.md, "What differs"). Here a cycle
// is rotated before coordinates are final, or the ends of a red one move out by at most three
// lines. O(n).
#include <algorithm>

#include "ar3d/algorithms/diamond/guaranteed.h"
#include "ar3d/base/error.h"

namespace ar3d::diamond {
namespace {

std::uint32_t distance(std::uint32_t a, std::uint32_t b) { return a > b ? a - b : b - a; }

/// Step 1.3. Closes a green cycle at an edge between two red items if it has one. Else the cycle is
/// contained in one red item, and it is closed at an edge whose distance there is not k - 1, its
/// distance in x. One exists: at the cycle's first vertex in the red item, the two edges have
/// different distances.
GreenClosing close_green_cycle(Items& green, std::uint32_t cycle, const Whereabouts& red) {
  const auto v = green.of(cycle);
  const auto k = static_cast<std::uint32_t>(v.size());
  std::uint32_t external = kNone;
  std::uint32_t inner = kNone;
  for (std::uint32_t i = 0; i < k && external == kNone; ++i) {
    const Vertex a = v[i];
    const Vertex b = v[i + 1 == k ? 0 : i + 1];
    if (red[a].item != red[b].item) external = i;
    if (distance(red[a].position, red[b].position) != k - 1) inner = i;
  }
  expect(external != kNone || inner != kNone, "a contained green cycle has an edge to close at");
  green.close_at(cycle, external != kNone ? external : inner);
  return {green.first(cycle), green.last(cycle),
          external != kNone ? kNone : red[green.first(cycle)].item};
}

/// Step 1.5 for red cycles without a contained green cycle: closes at an edge with |dx| != k - 1.
/// One exists, since a closed walk of k steps of length k - 1 does not visit k distinct integers.
/// @return by how many vertices its first one moves on.
std::uint32_t close_red_cycle(Items& red, std::uint32_t cycle, const PlanePoints& at) {
  const auto v = red.of(cycle);
  const std::size_t k = v.size();
  std::size_t i = k - 1;  // the natural closing edge first
  while (x_distance(at, v[i], v[(i + 1) % k]) == static_cast<std::int32_t>(k) - 1) {
    i = (i + 1) % k;
    expect(i != k - 1, "a red cycle has an edge to close at");
  }
  red.close_at(cycle, static_cast<std::uint32_t>(i));
  return static_cast<std::uint32_t>((i + 1) % k);
}

/// Step 1.5 for a red cycle R that contains a green cycle. Its rotation stays, since the green
/// closings rely on it; instead its two ends move out until all four kinds of edges there keep |dx|
/// != |dy|. The smallest total works with at most 3: moving only the last vertex, the edge before it
/// excludes one value, an inner closing at it another, and the closing edge none but 0.
/// @param inner  closing edges inside R; only those at R's ends matter.
std::pair<std::uint8_t, std::uint8_t> find_bump(const Items& red, std::uint32_t cycle,
                                                const PlanePoints& at,
                                                const std::vector<GreenClosing>& inner,
                                                const Whereabouts& natural) {
  const auto v = red.of(cycle);
  const std::size_t k = v.size();
  const auto works = [&](unsigned down, unsigned up) {
    const auto y = [&](Vertex u) {
      const auto p = static_cast<std::int32_t>(natural[u].position - red.begin[cycle]);
      return u == v.front()  ? p - static_cast<std::int32_t>(down)
             : u == v.back() ? p + static_cast<std::int32_t>(up)
                             : p;
    };
    const auto apart = [&](Vertex u, Vertex w) {
      return x_distance(at, u, w) != std::abs(y(u) - y(w));
    };
    return apart(v.front(), v.back()) && apart(v[0], v[1]) && apart(v[k - 2], v[k - 1]) &&
           std::ranges::all_of(inner, [&](const GreenClosing& c) { return apart(c.u, c.w); });
  };
  for (unsigned total = 0; total <= 3; ++total) {
    for (unsigned up = 0; up <= total; ++up) {
      if (works(total - up, up)) return {total - up, up};
    }
  }
  throw InternalError("internal error: no bump of at most 3 lines works");
}

}  // namespace

std::vector<GreenClosing> close_green_cycles(Items& green, const Whereabouts& natural_red) {
  std::vector<GreenClosing> closings;
  for (std::uint32_t item = 0; item < green.count(); ++item) {
    if (green.is_cycle(item)) closings.push_back(close_green_cycle(green, item, natural_red));
  }
  return closings;
}

RedCycles settle_red_cycles(Items& red, const std::vector<GreenClosing>& closings,
                            const PlanePoints& at, const Whereabouts& natural_red) {
  RedCycles result;
  result.bumps.resize(red.count());
  result.turned.resize(red.count());
  std::vector<std::vector<GreenClosing>> inside(red.count());
  for (const GreenClosing& closing : closings) {
    if (closing.contained_in == kNone) continue;
    inside[closing.contained_in].push_back(closing);
    ++result.contained;
  }
  for (std::uint32_t item = 0; item < red.count(); ++item) {
    if (!red.is_cycle(item)) continue;
    if (inside[item].empty()) {
      result.turned[item] = close_red_cycle(red, item, at);
      continue;
    }
    const auto [down, up] = result.bumps[item] =
        find_bump(red, item, at, inside[item], natural_red);
    ++result.rho;
    result.lines += down + up;
  }
  return result;
}

}  // namespace ar3d::diamond
