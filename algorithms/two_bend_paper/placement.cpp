// The free choices of Steps P.2 to P.8 in double, before a real type comes into play (Repair P.1):
// feet, shares, slides and sides are dyadic numbers, tried in a fixed order until one has the
// quality or clearance that the step demands. Only feet that have a ray are kept, since nothing
// else can be in the way. Cost: O(N log N) per candidate for N rays.
#include <algorithm>
#include <cmath>

#include "ar3d/algorithms/two_bend_paper/general_position.h"
#include "ar3d/algorithms/two_bend_paper/growth.h"
#include "ar3d/base/error.h"

namespace ar3d::two_bend_paper {
namespace {

constexpr double kGap = 2;         // between components
constexpr double kWidthOfK4 = 10;  // of its table

double cross(Foot a, Foot b) { return a.x * b.y - a.y * b.x; }
double dot(Foot a, Foot b) { return a.x * b.x + a.y * b.y; }
Foot minus(Foot a, Foot b) { return {a.x - b.x, a.y - b.y}; }
double length(Foot a) { return std::sqrt(dot(a, a)); }

double distance_to_segment(Foot p, Foot a, Foot b) {
  const Foot d = minus(b, a);
  const double t = std::clamp(dot(minus(p, a), d) / dot(d, d), 0.0, 1.0);
  return length(minus(p, {a.x + t * d.x, a.y + t * d.y}));
}

/// t and u, the farthest two of three feet (the first pair of several), then w.
std::array<std::uint8_t, 3> farthest_first(const std::array<Foot, 3>& feet) {
  std::array<std::uint8_t, 3> best{0, 1, 2};
  for (const std::array<std::uint8_t, 3> order :
       {std::array<std::uint8_t, 3>{0, 2, 1}, std::array<std::uint8_t, 3>{1, 2, 0}}) {
    const auto distance = [&](const std::array<std::uint8_t, 3>& o) {
      return length(minus(feet[o[0]], feet[o[1]]));
    };
    if (distance(order) > distance(best)) best = order;
  }
  return best;
}

class StepPlacer {
 public:
  explicit StepPlacer(const ContractedGraph& graph) : feet_(graph.num_nodes()) {}

  /// Places one component and moves it to the right of everything before it.
  void place(Component& component) {
    low_ = high_ = 0;
    is_empty_ = true;
    turns_ = 0;
    for (Step& step : component.steps) place_step(step);
    if (component.k4) high_ = kWidthOfK4;
    const double shift = next_left_ - std::floor(low_);
    for (Step& step : component.steps) {
      step.foot.x += shift;
      for (Side& side : step.sides) side.middle.x += shift;
    }
    component.left = next_left_;
    next_left_ = std::ceil(high_ + shift) + kGap;
  }

 private:
  std::vector<Foot> active_feet(unsigned turns) const {
    std::vector<Foot> feet;
    feet.reserve(active_.size());
    for (const Node node : active_) feet.push_back(turned(feet_[node], turns));
    return feet;
  }

  void widen(double low, double high) {
    low_ = is_empty_ ? low : std::min(low_, low);
    high_ = is_empty_ ? high : std::max(high_, high);
    is_empty_ = false;
  }

  void place_step(Step& step) {
    switch (step.kind) {
      case StepKind::line:
        return place_line(step);
      case StepKind::pass:
        return replace_ray(step, feet_[step.below[0].to]);
      case StepKind::merge:
        return place_merge(step);
      case StepKind::triskelion:
        return place_triskelion(step);
      case StepKind::cycle:
        return place_cycle(step);
    }
    throw InternalError("internal error: no such step");
  }

  /// The rays below end; that of the step's node begins, if it has one.
  void replace_ray(const Step& step, Foot foot) {
    for (const HalfEdge below : step.below) drop(below.to);
    feet_[step.node] = foot;
    if (step.has_ray) active_.push_back(step.node);
  }

  void drop(Node node) { active_.erase(std::find(active_.begin(), active_.end(), node)); }

  void place_line(Step& step) {
    const unsigned turns = turns_++;
    const std::vector<Foot> feet = active_feet(4 - turns % 4);
    const Foot corner = right_of(feet);
    for (unsigned round = 0; round < kRounds; ++round) {
      const double unit = std::ldexp(1.0, -static_cast<int>(round));
      const std::int64_t most = std::int64_t{64} << std::min(round, kFinestGrowth);
      for (std::int64_t j = 0; j < most; ++j) {
        const Foot at{corner.x, corner.y + static_cast<double>(alternating(j)) * unit};
        if (step.has_ray && !is_good(at, feet, round)) continue;
        step.foot = turned(at, turns);
        widen(step.foot.x, step.foot.x);
        return replace_ray(step, step.foot);
      }
    }
    throw InternalError("internal error: a vertex without neighbours finds its place");
  }

  /// 1/2, then 1/2 -+ odd multiples of 2^-(3 + round) between 0.2 and 0.8.
  template <class Found>
  static bool try_shares(unsigned round, const Found& found) {
    if (found(0.5)) return true;
    const double unit = std::ldexp(1.0, -3 - static_cast<int>(round));
    for (double offset = unit; offset <= 0.3; offset += 2 * unit) {
      if (found(0.5 - offset) || found(0.5 + offset)) return true;
    }
    return false;
  }

  void place_merge(Step& step) {
    const Foot p = feet_[step.below[0].to], q = feet_[step.below[1].to];
    for (const HalfEdge below : step.below) drop(below.to);
    const std::vector<Foot> others = active_feet(0);
    Foot foot;
    const auto found = [&](double share, unsigned round) {
      step.share = share;
      foot = {p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)};
      return !step.has_ray || is_good(foot, others, round);
    };
    for (unsigned round = 0; round < std::min(kRounds, 16u); ++round) {
      if (!try_shares(round, [&](double share) { return found(share, round); })) continue;
      feet_[step.node] = foot;
      if (step.has_ray) active_.push_back(step.node);
      return;
    }
    throw InternalError("internal error: a vertex over two rays finds its place");
  }

  void place_triskelion(Step& step) {
    std::array<Foot, 3> below;
    for (std::size_t i = 0; i < 3; ++i) below[i] = feet_[step.below[i].to];
    for (const HalfEdge incidence : step.below) drop(incidence.to);
    step.order = farthest_first(below);
    const Foot t = below[step.order[0]], u = below[step.order[1]], w = below[step.order[2]];
    const double base = length(minus(u, t));
    const Foot e{(u.x - t.x) / base, (u.y - t.y) / base};
    const double height = std::abs(cross(e, minus(w, t))), s = dot(e, minus(w, t));
    step.w_is_left = cross(e, minus(w, t)) > 0;
    const auto others = active_feet(0);
    const auto n = static_cast<double>(others.size() + 3);
    const auto clearance = [&](double at) {
      const Foot middle{t.x + at * e.x, t.y + at * e.y};
      double least = std::min({at, base - at, height});
      for (const Foot foot : others) {
        least = std::min(least, distance_to_segment(foot, middle, w));
      }
      return least;
    };
    for (unsigned round = 0; round < kRounds; ++round) {
      const double unit = std::ldexp(1.0, -5 - static_cast<int>(std::min(round, kFinestGrowth)));
      const auto most = static_cast<std::int64_t>(1.5 / unit) + 1;  // |slide| <= 3/4
      for (std::int64_t j = 0; j < most; ++j) {
        step.slide = static_cast<double>(alternating(j)) * unit;
        const double at = s + step.slide * height;
        if (at <= s / 2 || at >= (base + s) / 2) continue;
        const double room = clearance(at);
        if (room < height / (8 * n) * std::ldexp(1.0, -static_cast<int>(round))) continue;
        if (room <= 0) continue;
        step.radius = std::exp2(std::floor(std::log2(room / 4)));
        return;
      }
    }
    throw InternalError("internal error: a vertex over three rays finds its place");
  }

  void place_cycle(Step& step) {
    const unsigned turns = turns_++;
    std::vector<bool> needs_position;
    needs_position.reserve(step.cycle.size());
    for (const CycleVertex& vertex : step.cycle) needs_position.push_back(vertex.third.has_value());
    step.sides = cycle_polygon(active_feet(4 - turns % 4), needs_position);
    for (std::size_t i = 0; i < step.cycle.size(); ++i) {
      Side& side = step.sides[i];
      side.middle = turned(side.middle, turns);
      side.along = turned(side.along, turns);
      const double reach = std::abs(side.along.x) * side.half;
      widen(side.middle.x - reach, side.middle.x + reach);
      const CycleVertex& vertex = step.cycle[i];
      if (vertex.is_below) drop(vertex.third->to);
      feet_[vertex.node] = side.middle;
    }
    for (const CycleVertex& vertex : step.cycle) {
      if (vertex.has_ray()) active_.push_back(vertex.node);
    }
  }

  std::vector<Foot> feet_;    // by node, before the component is moved
  std::vector<Node> active_;  // nodes with a ray, in order of time
  unsigned turns_ = 0;        // quarter turns of the next line or cycle
  double low_ = 0;            // of the component's x
  double high_ = 0;
  bool is_empty_ = true;
  double next_left_ = 0;
};

}  // namespace

void place(const ContractedGraph& graph, std::vector<Component>& components) {
  StepPlacer placer(graph);
  for (Component& component : components) placer.place(component);
}

}  // namespace ar3d::two_bend_paper
