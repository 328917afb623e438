// Step R.3, the cheapest route of an edge and the best place of a vertex, exactly, against fixed
// costs of points: from the fields of one end (fields.h) the last segment is walked back from the
// other, and the rest is traced; a vertex has the fields of all its neighbours. Dropped: A* over
// points, directions and bends, which the tests keep as the oracle, and an enumeration of words of
// directions, whose number grows threefold with each bend. Cost: nearly that of the fields.
#include "ar3d/algorithms/routed/search.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>

#include "ar3d/base/parallel.h"

namespace ar3d::routed {
namespace {

constexpr int kMostWidenings = 3;
constexpr int kMostEnds = 8;  // that are tried if routes meet themselves

}  // namespace

/// No route between two points has fewer steps.
int RouteSearch::steps_between(Spot a, Spot b) const {
  const int x = std::abs(a.x - b.x);
  const int y = std::abs(a.y - b.y);
  const int z = std::abs(a.z - b.z);
  const int longest = std::max({x, y, z});
  return points_.is_body() ? longest : std::max(longest, (x + y + z) / 2);
}

/// The cheapest end of a route: its last segment is walked back from v.
int RouteSearch::best_end(const End& v, int limit, std::span<const LastTurn> excluded,
                          RandomStream& random, LastTurn& best) const {
  std::uint32_t ties = 0;
  const auto offer = [&](int cost, const LastTurn& turn) {
    if (cost > limit || (cost == limit && ties == 0) ||
        std::find(excluded.begin(), excluded.end(), turn) != excluded.end()) {
      return;
    }
    ties = cost < limit ? 1 : ties + 1;
    limit = cost;
    if (ties == 1 || random.below(ties) == 0) best = turn;
  };
  const CostFields& fields = fields_[0];
  const Spot at = v.at - fields.low();
  for (int d = 0; d < points_.num_directions(); ++d) {
    if (!has(v.arms, PointClass::opposite(d))) continue;
    int cost = CostBox::kStep;
    int left = 1;
    for (Spot p = at - points_.step(d); cost <= limit; p = p - points_.step(d), ++left) {
      if (p == fields.from()) {
        if (fields.field(0, d)) offer(cost, {-1, d, d, left});
        break;
      }
      const std::size_t i = fields.index(p);
      if (fields.cost(i) >= kInfinite) break;
      for (int layer = 0; layer < fields.num_layers(); ++layer) {
        for (int e = 0; e < points_.num_directions(); ++e) {
          const Cost* field = fields.field(layer, e);
          if (field && has(points_.turns(e), d)) offer(cost + field[i], {layer, e, d, left});
        }
      }
      cost += fields.cost(i);
    }
  }
  return limit;
}

/// The route to p that arrives there in direction d after so many bends: follows least costs back to
/// their source; where several steps lead there, one at random.
Route RouteSearch::trace(const CostFields& fields, Spot p, int layer, int d,
                         RandomStream& random) const {
  std::array<std::pair<int, int>, kMostSegments> back;  // direction, length
  std::size_t segments = 1;
  back[0] = {d, 0};
  while (layer >= 0) {
    const std::size_t i = fields.index(p);
    const int before = fields.field(layer, d)[i] - fields.cost(i);
    p = p - points_.step(d);
    ++back[segments - 1].second;
    if (layer == 0 && p == fields.from()) break;
    const std::size_t j = fields.index(p);
    int next_layer = layer;
    int next = -1;
    std::uint32_t ways = 0;
    const auto offer = [&](int to_layer, int e) {
      const Cost* field = fields.field(to_layer, e);
      if (!field || field[j] != before) return;
      if (++ways > 1 && random.below(ways) != 0) return;
      next_layer = to_layer;
      next = e;
    };
    offer(layer, d);
    for (int e = 0; e < points_.num_directions() && layer > 0; ++e) {
      if (has(points_.turns(e), d)) offer(layer - 1, e);
    }
    if (next_layer != layer) back[segments++] = {next, 0};
    layer = next_layer;
    d = next;
  }
  Route found;
  for (std::size_t s = segments; s-- > 0;) found.add(back[s].first, back[s].second);
  return found;
}

bool RouteSearch::meets_itself(const CostFields& fields, const Route& route) {
  passed_.assign(1, fields.index(fields.from()));
  Spot p = fields.from();
  for (std::size_t s = 0; s < route.segments; ++s) {
    for (int t = 0; t < route.length[s]; ++t) {
      p = p + points_.step(route.direction[s]);
      passed_.push_back(fields.index(p));
    }
  }
  std::sort(passed_.begin(), passed_.end());
  return std::adjacent_find(passed_.begin(), passed_.end()) != passed_.end();
}

int RouteSearch::find_in_window(const End& v, int limit, RandomStream& random, Route& found) {
  std::vector<LastTurn> excluded;
  for (int go = 0; go < kMostEnds; ++go) {
    LastTurn last;
    const int cost = best_end(v, limit, excluded, random, last);
    if (last.left == 0) return limit;
    found = {};
    if (last.layer >= 0) {
      const Spot p = v.at - fields_[0].low() - last.left * points_.step(last.into);
      found = trace(fields_[0], p, last.layer, last.direction, random);
    }
    found.add(last.into, last.left);
    if (!meets_itself(fields_[0], found)) return cost;
    excluded.push_back(last);
    found = {};
  }
  return limit;
}

int RouteSearch::find(const CostBox& box, const End& u, const End& v, int limit, bool is_wide,
                      RandomStream& random, Route& found) {
  found.segments = 0;
  limit = std::min<int>(limit, kInfinite);
  const int least = steps_between(u.at, v.at);
  int slack = 3 + least / 6;
  for (int go = 0; go < (is_wide ? kMostWidenings : 2); ++go) {
    const int steps = std::min((limit - 1) / CostBox::kStep, least + slack);
    if (steps < least) return limit;
    const bool is_part = fields_[0].open(box, u, v.at, 0, steps, bends_);
    Route route;
    const int cost = find_in_window(v, limit, random, route);
    if (route) {
      found = route;
      limit = cost;
    }
    if (!is_part || limit <= CostBox::kStep * (steps + 1) || (found && !is_wide)) break;
    slack *= 4;
  }
  return limit;
}

/// The cheapest choice of different arms of a frame; below the limit.
int RouteSearch::cheapest_arms(std::size_t i, std::size_t neighbours, std::size_t frame, int limit,
                               std::array<std::uint8_t, 4>& arms) const {
  const Directions all = points_.frames()[frame];
  std::array<std::uint8_t, 4> tried{};
  const auto choose = [&](const auto& self, std::size_t k, Directions free, int so_far) -> void {
    if (so_far >= limit) return;
    if (k == neighbours) {
      limit = so_far;
      arms = tried;
      return;
    }
    for (int d = 0; d < points_.num_directions(); ++d) {
      if (!has(free, d) || arrivals_[k][static_cast<std::size_t>(d)][i] == kInfinite) continue;
      tried[k] = static_cast<std::uint8_t>(d);
      self(self, k + 1, without(free, d), so_far + arrivals_[k][static_cast<std::size_t>(d)][i]);
    }
  };
  choose(choose, 0, all, 0);
  return limit;
}

/// Least costs of arriving at the places, by arm, and the least of all added to the bounds.
void RouteSearch::note_arrivals(std::size_t neighbour, Directions arms) {
  std::vector<Cost> least(bounds_.size(), kInfinite);
  for (int d = 0; d < points_.num_directions(); ++d) {
    if (!has(arms, d)) continue;
    std::vector<Cost>& costs = arrivals_[neighbour][static_cast<std::size_t>(d)];
    costs.resize(bounds_.size());
    fields_[neighbour].write_arrivals(PointClass::opposite(d), place_rows_, costs);
    for (std::size_t i = 0; i < least.size(); ++i) least[i] = std::min(least[i], costs[i]);
  }
  for (std::size_t i = 0; i < least.size(); ++i) bounds_[i] += least[i];
}

/// The cheapest route that arrives at a point of the window in direction d.
Route RouteSearch::route_to(const CostFields& fields, Spot at, int d, RandomStream& random) {
  const std::size_t i = fields.index(at);
  int best = -1;
  for (int layer = 0; layer < fields.num_layers(); ++layer) {
    const Cost* field = fields.field(layer, d);
    if (field && (best < 0 || field[i] < fields.field(best, d)[i])) best = layer;
  }
  const Route found = trace(fields, at, best, d, random);
  return meets_itself(fields, found) ? Route{} : found;
}

/// The points at most `radius` away, in rows; those without a vertex are marked by what they cost.
void RouteSearch::list_places(const CostBox& box, Spot now, int radius) {
  const Limits& limits = box.limits();
  const int z0 = std::max(limits.low.z, now.z - radius);
  const int z1 = std::min(limits.high.z, now.z + radius);
  const int vectors = ((z1 - z0) / 2 + CostFields::kVector) / CostFields::kVector;
  place_lanes_ = static_cast<std::size_t>(vectors) * CostFields::kVector;
  place_rows_.clear();
  place_costs_.clear();
  for (int x = std::max(limits.low.x, now.x - radius); x <= std::min(limits.high.x, now.x + radius);
       ++x) {
    for (int y = std::max(limits.low.y, now.y - radius);
         y <= std::min(limits.high.y, now.y + radius); ++y) {
      if (points_.is_body() && ((x ^ y) & 1) != 0) continue;
      Spot p = {x, y, z0};
      if (!points_.contains(p)) ++p.z;
      place_rows_.push_back(p);
      for (std::size_t k = 0; k < place_lanes_; ++k, p.z += 2) {
        int cost = -1;
        if (p == now) {
          cost = 0;
        } else if (p.z <= z1) {
          const int i = box.index(p);
          if (!box.has_vertex(i)) cost = box.cost(i);
        }
        place_costs_.push_back(cost);
      }
    }
  }
}

int RouteSearch::find_place(const CostBox& box, Spot now, std::span<const End> neighbours,
                            std::span<const std::size_t> frames, int radius, int limit,
                            RandomStream& random, Trial& found) {
  list_places(box, now, radius);
  int least_of_all = 0;
  const auto least = [&](const End& end) {
    return std::max(1, steps_between(end.at, now) - radius);
  };
  for (const End& end : neighbours) least_of_all += CostBox::kStep * least(end);
  bounds_.assign(place_costs_.size(), 0);
  Directions arms_of_all = 0;
  for (const std::size_t frame : frames) {
    arms_of_all = static_cast<Directions>(arms_of_all | points_.frames()[frame]);
  }
  const int spare = (limit - 1 - least_of_all) / CostBox::kStep;
  if (spare < 0) return limit;
  for_each_in_threads(threads_, neighbours.size(), [&](std::uint32_t, std::size_t k) {
    const int from_here = least(neighbours[k]);
    const int steps = from_here + std::min(3 + radius + from_here / 6, spare);
    fields_[k].open(box, neighbours[k], now, radius, steps, bends_ + 1);
  });
  for (std::size_t k = 0; k < neighbours.size(); ++k) note_arrivals(k, arms_of_all);
  std::uint32_t ties = 0;
  const int edges = static_cast<int>(neighbours.size());
  std::array<std::uint8_t, 4> best{};
  for (std::size_t i = 0; i < bounds_.size(); ++i) {
    if (place_costs_[i] < 0) continue;
    Spot at = place_rows_[i / place_lanes_];
    at.z += 2 * static_cast<int>(i % place_lanes_);
    // What routes pay that pass the point, not those that end here, less what the vertex pays.
    const int extra = edges * place_costs_[i] - box.cost_of_vertex(box.index(at));
    if (bounds_[i] - extra > limit || (bounds_[i] - extra == limit && ties == 0)) continue;
    for (const std::size_t frame : frames) {
      std::array<std::uint8_t, 4> arms{};
      const int most = limit + (ties > 0 ? 1 : 0);
      const int cost = cheapest_arms(i, neighbours.size(), frame, most + extra, arms) - extra;
      if (cost >= most) continue;
      ties = cost < limit ? 1 : ties + 1;
      limit = cost;
      if (ties > 1 && random.below(ties) != 0) continue;
      std::tie(found.at, found.frame) = std::tie(at, frame);
      best = arms;
    }
  }
  for (std::size_t k = 0; k < neighbours.size() && ties > 0; ++k) {
    found.routes[k] =
        route_to(fields_[k], found.at - fields_[k].low(), PointClass::opposite(best[k]), random);
  }
  return limit;
}

}  // namespace ar3d::routed
