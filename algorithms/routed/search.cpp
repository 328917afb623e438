// Step R.3, the cheapest route of an edge against fixed costs of points: all words, with lengths
// that the ends leave open chosen among short ones, all where one is open, and a few random longer
// ones. Costs of the first and last segments are tables, so that a candidate walks its middle only,
// and ends where it passes the best so far. The plain search over all points, directions and bends
// is its oracle in the tests. Cost: O(groups of words), and the points of the candidates walked.
#include "ar3d/algorithms/routed/search.h"

#include <algorithm>

namespace ar3d::routed {
namespace {

constexpr std::size_t kTableBits = 14;

/// The number k > 0 with k step = d, or 0.
int multiple(Spot step, Spot d) {
  const int part = step.x != 0 ? step.x : step.y != 0 ? step.y : step.z;
  const int k = (step.x != 0 ? d.x : step.y != 0 ? d.y : d.z) / part;
  return k > 0 && k * step == d ? k : 0;
}

}  // namespace

RouteSearch::RouteSearch(const Words& words)
    : words_(words),
      points_(words.points()),
      products_(words.bases().size()),
      passed_(std::size_t{1} << kTableBits) {}

int RouteSearch::find(const CostBox& box, const End& u, const End& v, int limit,
                      const Lengths& lengths, RandomStream& random, Route& found) {
  box_ = &box;
  from_ = u.at;
  across_ = v.at - u.at;
  arms_u_ = u.arms;
  arms_v_ = v.arms;
  best_ = limit;
  found.segments = 0;
  found_ = &found;
  longest_ = box.limits().longest();
  fill_arms(u, v);
  try_short_words(u, v);
  try_planar_words(u, v);
  choose_lengths(lengths, random);
  for (std::size_t b = 0; b < products_.size(); ++b) {
    for (std::size_t i = 0; i < 3; ++i) {
      products_[b][i] = dot(words_.bases()[b].rows[i], across_);
    }
  }
  try_groups(words_.groups(u.frame, v.frame), random);
  return best_;
}

void RouteSearch::fill_arm(std::vector<int>& costs, Spot from, int d) {
  int i = box_->index(from);
  int side = CostBox::parity(from);
  int total = 0;
  for (int l = 1;; ++l) {
    from = from + points_.step(d);
    if (!box_->contains(from)) return;
    i += box_->stride(side, d);
    side ^= box_->flip(d);
    const int cost = box_->cost(i);
    if (cost == CostBox::kBlocked) return;
    total += cost;
    if (total + CostBox::kStep * l >= best_) return;
    costs.push_back(total);
  }
}

void RouteSearch::fill_arms(const End& u, const End& v) {
  for (int d = 0; d < points_.num_directions(); ++d) {
    const auto at = static_cast<std::size_t>(d);
    out_of_u_[at].assign(1, 0);
    into_v_[at].assign(1, 0);
    const int back = PointClass::opposite(d);
    if (has(u.arms, d)) fill_arm(out_of_u_[at], u.at, d);
    if (has(v.arms, back)) fill_arm(into_v_[at], v.at, back);
  }
}

/// 1 ... near, and so many of the lengths from there to half the box; all if those are no more.
void RouteSearch::choose(Choices& choices, int near, int others, RandomStream& random,
                         bool prefers_short) const {
  choices.count = 0;
  const auto add = [&](int l) {
    choices.largest = std::max(choices.largest, l);
    choices.length[static_cast<std::size_t>(choices.count++)] = l;
  };
  choices.largest = 0;
  near = std::min(near, longest_);
  for (int l = 1; l <= near; ++l) add(l);
  const int longer = longest_ / 2 - near;
  if (longer <= others) {
    for (int l = near + 1; l <= near + longer; ++l) add(l);
    return;
  }
  for (int i = 0; i < others; ++i) {
    const auto range = static_cast<std::uint32_t>(longer);
    std::uint32_t more = random.below(range);
    if (prefers_short) more = std::min(more, random.below(range));
    add(near + 1 + static_cast<int>(more));
  }
}

void RouteSearch::choose_lengths(const Lengths& lengths, RandomStream& random) {
  for (Choices& choices : of_three_) {
    choose(choices, lengths.near_of_three, lengths.random, random, true);
  }
  for (Choices& choices : of_two_) {
    choose(choices, lengths.near_of_two, 4 * lengths.random, random, false);
  }
}

void RouteSearch::try_short_words(const End& u, const End& v) {
  for (int d = 0; d < points_.num_directions(); ++d) {
    if (!has(u.arms, d)) continue;
    const auto first = static_cast<std::uint8_t>(d);
    const int straight = multiple(points_.step(d), across_);
    if (straight > 0 && has(v.arms, PointClass::opposite(d))) {
      length_[0] = straight;
      consider(1, &first, straight);
    }
    for (int e = 0; e < points_.num_directions(); ++e) {
      if (!has(points_.turns(d), e) || !has(v.arms, PointClass::opposite(e)) ||
          dot(cross(points_.step(d), points_.step(e)), across_) != 0) {
        continue;
      }
      for (int l = 1; l < longest_; ++l) {
        const int k = multiple(points_.step(e), across_ - l * points_.step(d));
        if (k == 0) continue;
        length_[0] = l;
        length_[1] = k;
        const std::uint8_t both[] = {first, static_cast<std::uint8_t>(e)};
        consider(2, both, l + k);
        break;
      }
    }
  }
}

/// Words of three and four segments in one plane, which have no three independent ones: all lengths,
/// where the other end lies in the plane.
void RouteSearch::try_planar_words(const End& u, const End& v) {
  const auto ends = [&](int d) { return has(v.arms, PointClass::opposite(d)); };
  std::array<std::uint8_t, 4> word{};
  const auto last_two = [&](std::size_t segments, Spot rest, int steps) {
    const Spot e = points_.step(word[segments - 2]);
    const Spot f = points_.step(word[segments - 1]);
    const Spot normal = cross(e, f);
    const int l = multiple(normal, cross(rest, f));
    const int k = multiple(normal, cross(e, rest));
    if (l == 0 || k == 0 || CostBox::kStep * (steps + l + k) >= best_) return;
    length_[segments - 2] = l;
    length_[segments - 1] = k;
    consider(segments, word.data(), steps + l + k);
  };
  const auto is_cheap = [&](int steps) {
    return steps <= longest_ && CostBox::kStep * steps < best_;
  };
  for (int d = 0; d < points_.num_directions(); ++d) {
    for (int e = 0; e < points_.num_directions() && has(u.arms, d); ++e) {
      const Spot normal = cross(points_.step(d), points_.step(e));
      if (!has(points_.turns(d), e) || dot(normal, across_) != 0) continue;
      for (int f = 0; f < points_.num_directions(); ++f) {
        if (!has(points_.turns(e), f) || dot(normal, points_.step(f)) != 0) continue;
        for (int g = -1; g < points_.num_directions(); ++g) {
          if (g >= 0 && (!has(points_.turns(f), g) || dot(normal, points_.step(g)) != 0)) continue;
          if (!ends(g < 0 ? f : g)) continue;
          word = {static_cast<std::uint8_t>(d), static_cast<std::uint8_t>(e),
                  static_cast<std::uint8_t>(f), static_cast<std::uint8_t>(std::max(g, 0))};
          for (int a = 1; is_cheap(a); ++a) {
            length_[0] = a;
            const Spot rest = across_ - a * points_.step(d);
            if (g < 0) last_two(3, rest, a);
            for (int b = 1; g >= 0 && is_cheap(b); ++b) {
              length_[1] = b;
              last_two(4, rest - b * points_.step(e), a + b);
            }
          }
        }
      }
    }
  }
}

void RouteSearch::try_groups(std::span<const WordGroup> groups, RandomStream& random) {
  for (std::size_t begin = 0, end = 0; begin < groups.size(); begin = end) {
    while (end < groups.size() && groups[end].segments == groups[begin].segments) ++end;
    const std::size_t first = begin + random.below(static_cast<std::uint32_t>(end - begin));
    const auto try_range = [&](std::size_t from, std::size_t to) {
      for (std::size_t g = from; g < to; ++g) {
        if (!is_hopeless(groups[g])) try_group(groups[g]);
      }
    };
    try_range(first, end);  // equally cheap routes of other words win in other searches
    try_range(begin, first);
  }
}

/// True if no lengths within the choices are positive and short enough.
bool RouteSearch::is_hopeless(const WordGroup& group) const {
  const std::array<int, 3>& rest = products_[group.basis];
  int most = longest_;
  if (group.num_chosen == 2) most = std::max(of_two_[0].largest, of_two_[1].largest);
  if (group.num_chosen == 3) {
    most = std::max({of_three_[0].largest, of_three_[1].largest, of_three_[2].largest});
  }
  int r0 = rest[0];
  int r1 = rest[1];
  int r2 = rest[2];
  int steps = r0 + r1 + r2;
  for (std::size_t k = 0; k < group.num_chosen; ++k) {
    const int t0 = group.taken[0][k], t1 = group.taken[1][k], t2 = group.taken[2][k];
    r0 -= t0 > 0 ? t0 : most * t0;
    r1 -= t1 > 0 ? t1 : most * t1;
    r2 -= t2 > 0 ? t2 : most * t2;
    const int longer = (1 << group.log_determinant) - t0 - t1 - t2;
    steps += longer > 0 ? longer : most * longer;
  }
  return r0 <= 0 || r1 <= 0 || r2 <= 0 ||
         CostBox::kStep * (steps >> group.log_determinant) >= best_;
}

void RouteSearch::try_group(const WordGroup& group) {
  const std::array<int, 3>& product = products_[group.basis];
  const auto less = [&](const std::array<int, 3>& rest, std::size_t k, int l) {
    return std::array<int, 3>{rest[0] - l * group.taken[0][k], rest[1] - l * group.taken[1][k],
                              rest[2] - l * group.taken[2][k]};
  };
  const auto each = [&](const Choices& choices, std::size_t k, const auto& next) {
    for (int i = 0; i < choices.count; ++i) {
      const int l = choices.length[static_cast<std::size_t>(i)];
      chosen_[k] = l;
      next(l);
    }
  };
  if (group.num_chosen == 0) {
    solve(group, product, 0);
  } else if (group.num_chosen == 1) {
    for (int l = 1; l <= longest_ && CostBox::kStep * l < best_; ++l) {
      chosen_[0] = l;
      solve(group, less(product, 0, l), l);
    }
  } else if (group.num_chosen == 2) {
    each(of_two_[0], 0, [&](int a) {
      const auto rest = less(product, 0, a);
      each(of_two_[1], 1, [&](int b) { solve(group, less(rest, 1, b), a + b); });
    });
  } else {
    each(of_three_[0], 0, [&](int a) {
      const auto first = less(product, 0, a);
      each(of_three_[1], 1, [&](int b) {
        const auto second = less(first, 1, b);
        each(of_three_[2], 2, [&](int c) { solve(group, less(second, 2, c), a + b + c); });
      });
    });
  }
}

/// The three lengths that are left, if they are positive integers, in every order of the group.
void RouteSearch::solve(const WordGroup& group, std::array<int, 3> rest, int chosen_steps) {
  if (rest[0] <= 0 || rest[1] <= 0 || rest[2] <= 0) return;
  const int shift = group.log_determinant;
  if (((rest[0] | rest[1] | rest[2]) & ((1 << shift) - 1)) != 0) return;
  const int l0 = rest[0] >> shift, l1 = rest[1] >> shift, l2 = rest[2] >> shift;
  const int steps = chosen_steps + l0 + l1 + l2;
  if (CostBox::kStep * steps >= best_) return;
  const DirectionWord* word = words_.word(group.first);
  for (const DirectionWord* end = word + group.count; word < end; ++word) {
    length_[word->solved[0]] = l0;
    length_[word->solved[1]] = l1;
    length_[word->solved[2]] = l2;
    for (std::size_t k = 0; k < group.num_chosen; ++k) length_[word->chosen[k]] = chosen_[k];
    consider(group.segments, word->direction.data(), steps);
  }
}

/// Takes the route of length_ if it is cheaper than the best one, inside, and meets itself nowhere.
void RouteSearch::consider(std::size_t segments, const std::uint8_t* direction, int steps) {
  const auto& first = out_of_u_[direction[0]];
  const auto& last = into_v_[direction[segments - 1]];
  const auto leaving = static_cast<std::size_t>(length_[0]);
  const auto arriving = static_cast<std::size_t>(length_[segments - 1]);
  int cost = CostBox::kStep * steps;
  if (segments == 1) {
    if (leaving > first.size()) return;  // its last point is v
    cost += first[leaving - 1];
  } else {
    if (leaving >= first.size() || arriving >= last.size()) return;
    cost += first[leaving] + last[arriving];
    if (segments == 2)
      cost -= box_->cost(box_->index(from_ + length_[0] * points_.step(direction[0])));
  }
  if (cost >= best_) return;
  if (segments > 2) cost = middle_cost(segments, direction, cost);
  if (cost >= best_ || meets_itself(segments, direction)) return;
  best_ = cost;
  found_->segments = static_cast<std::uint8_t>(segments);
  for (std::size_t s = 0; s < segments; ++s) {
    found_->direction[s] = direction[s];
    found_->length[s] = static_cast<std::int16_t>(length_[s]);
  }
}

/// Adds the points between the first bend and the last; best_ or more if they cost that or leave the
/// box.
int RouteSearch::middle_cost(std::size_t segments, const std::uint8_t* direction, int cost) const {
  Spot corner = from_ + length_[0] * points_.step(direction[0]);
  int i = box_->index(corner);
  int side = CostBox::parity(corner);
  for (std::size_t s = 1; s + 1 < segments; ++s) {
    corner = corner + length_[s] * points_.step(direction[s]);
    if (!box_->contains(corner)) return best_;
  }
  for (std::size_t s = 1; s + 1 < segments; ++s) {
    const int d = direction[s];
    const int strides[] = {box_->stride(0, d), box_->stride(1, d)};
    const int flip = box_->flip(d);
    // The last bend stands in the table of the last segment.
    const int last = length_[s] - (s + 2 == segments ? 1 : 0);
    for (int t = 0; t < last; ++t) {
      i += strides[side];
      side ^= flip;
      const int point = box_->cost(i);
      if (point == CostBox::kBlocked) return best_;
      cost += point;
      if (cost >= best_) return best_;
    }
  }
  return cost;
}

bool RouteSearch::meets_itself(std::size_t segments, const std::uint8_t* direction) {
  if (++stamp_ == 0) {  // after 2^32 candidates
    passed_.assign(passed_.size(), {});
    stamp_ = 1;
  }
  const auto is_new = [&](int i) {
    std::size_t at = static_cast<std::uint32_t>(i) * 2654435761u >> (32 - kTableBits);
    for (; passed_[at].second == stamp_; at = (at + 1) % passed_.size()) {
      if (passed_[at].first == i) return false;
    }
    passed_[at] = {i, stamp_};
    return true;
  };
  int i = box_->index(from_);
  int side = CostBox::parity(from_);
  int steps = 0;
  for (std::size_t s = 0; s < segments; ++s) steps += length_[s];
  if (static_cast<std::size_t>(steps) * 2 > passed_.size()) return true;  // no room: not taken
  is_new(i);
  for (std::size_t s = 0; s < segments; ++s) {
    for (int t = 0; t < length_[s]; ++t) {
      i += box_->stride(side, direction[s]);
      side ^= box_->flip(direction[s]);
      if (!is_new(i)) return true;
    }
  }
  return false;
}

}  // namespace ar3d::routed
