// Step 3.12. Plane numbers of colour 2 in one pass over its edges; then the ends y of the defects,
// in the order in which they depend on one another. What depends on itself is returned as a
// circle, for Step 3.13. O(log n) expected per edge.
#include <algorithm>
#include <array>

#include "ar3d/algorithms/grid/flat.h"
#include "ar3d/algorithms/grid/number_search.h"
#include "ar3d/base/error.h"
#include "ar3d/base/random.h"

namespace ar3d::grid {
namespace {

constexpr std::uint64_t kColourSeed = 0x677269642d330002;
constexpr std::int64_t kBack = 64;  // a search begins this far before the last number found

class ThirdColour {
 public:
  ThirdColour(std::span<const Ports> ports, const OrderPart& part,
              std::span<const ColourDefect> defects, std::span<const HeightSlot> slots,
              std::span<PlaneNumbers> x)
      : ports_(ports),
        part_(part),
        defects_(defects),
        slots_(slots),
        x_(x),
        taken_(part.size()),
        sums_(part.size()),
        random_(kColourSeed),
        search_(sums_, random_, reach()),
        limit_(height_limit(part.size())),
        highest_(-part.size() / 2),
        lowest_(highest_) {}

  /// A defect of a circle; none if all is well.
  std::vector<std::size_t> run() {
    for (std::size_t d = 0; d < defects_.size(); ++d) by_y_.emplace_back(defects_[d].y, d);
    std::ranges::sort(by_y_);
    for (Index v = part_.begin; v < part_.end; ++v) {
      prefetch_ahead(v);
      if (x_[v][2] == kUnsetNumber && find_defect(v) == kNone) number(v);
    }
    for (std::size_t d = 0; d < defects_.size(); ++d) {
      if (!number_defect(d)) return {d};
    }
    return {};
  }

  std::int64_t blocks() const { return search_.blocks(); }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  std::int64_t reach() const { return 10 * part_.size() + 36; }

  /// Memory that number() reads for the vertices that come next, on its way.
  [[gnu::always_inline]] void prefetch_ahead(Index v) const {
    const auto prefetch = [&](Index w) __attribute__((always_inline)) {
      for (const Index to : ports_[w].to) {
        if (to != kNoIndex) __builtin_prefetch(&x_[to]);
      }
    };
    const Index near = v + kAhead;
    if (near < part_.end && x_[near][2] == kUnsetNumber) {
      const Index partner = ports_[near].to[2];
      if (partner != kNoIndex) prefetch(partner);
    }
    const Index far = v + 2 * kAhead;
    if (far < part_.end) {
      prefetch(far);
      const Index partner = ports_[far].to[2];
      if (partner != kNoIndex) __builtin_prefetch(&ports_[partner]);
    }
  }

  /// The defect whose y is v.
  std::size_t find_defect(Index v) const {
    const auto at =
        std::ranges::lower_bound(by_y_, v, {}, [](const auto& pair) { return pair.first; });
    return at != by_y_.end() && at->first == v ? at->second : kNone;
  }

  void number(Index v) {
    const Index partner = ports_[v].to[2];
    std::array<SumRule, 2> rules{rule_of(v), {}};
    if (partner != kNoIndex) rules[1] = rule_of(partner);
    const std::int64_t low = highest_ - kBack;
    const auto found = search_.find_up(taken_, {rules.data(), partner != kNoIndex ? 2u : 1u},
                                       {low, low + reach()});
    settle(v, found.value());
    if (partner != kNoIndex) settle(partner, *found);
    take(*found);
  }

  /// Chains of such ends are followed to their first x with a number.
  bool number_defect(std::size_t d) {
    std::vector<std::size_t> waiting;
    while (x_[defects_[d].y][2] == kUnsetNumber) {
      waiting.push_back(d);
      if (x_[defects_[d].x][2] != kUnsetNumber) break;
      d = find_defect(defects_[d].x);
      if (waiting.size() > defects_.size()) return false;
    }
    for (; !waiting.empty(); waiting.pop_back()) settle_defect(waiting.back());
    return true;
  }

  void settle_defect(std::size_t d) {
    const ColourDefect& defect = defects_[d];
    const std::int64_t other = x_[defect.x][2];
    const std::int64_t apart = slots_[d].below_x + 1;
    const SumRule rule = rule_of(defect.y);
    std::optional<std::int64_t> found;
    if (defect.label_x == 0) {
      const std::int64_t high = std::max(-limit_, std::min(other - apart, lowest_ + kBack));
      found = search_.find_down(taken_, {&rule, 1}, {high - reach(), high});
    } else {
      const std::int64_t low = std::min(limit_, std::max(other + apart, highest_ - kBack));
      found = search_.find_up(taken_, {&rule, 1}, {low, low + reach()});
    }
    settle(defect.y, found.value());
    take(*found);
  }

  void take(std::int64_t number) {
    taken_.insert(number);
    highest_ = std::max(highest_, number);
    lowest_ = std::min(lowest_, number);
  }

  void settle(Index v, std::int64_t number) {
    x_[v][2] = narrow(number);
    expect(sums_.insert(sum_of(x_[v])), "sums are distinct (I1)");
  }

  SumRule rule_of(Index v) const {
    SumRule rule;
    rule.known = std::int64_t{x_[v][0]} + x_[v][1];
    for (const Colour c : {0u, 1u}) {
      const Index w = ports_[v].to[c];
      if (w != kNoIndex && x_[w][2] != kUnsetNumber) rule.join(sum_of(x_[w]));
    }
    return rule;
  }

  const std::span<const Ports> ports_;
  const OrderPart part_;
  const std::span<const ColourDefect> defects_;
  const std::span<const HeightSlot> slots_;
  const std::span<PlaneNumbers> x_;
  NumberSet taken_;
  NumberSet sums_;
  RandomStream random_;
  NumberSearch search_;
  const std::int64_t limit_;
  std::int64_t highest_;
  std::int64_t lowest_;
  std::vector<std::pair<Index, std::size_t>> by_y_;
};

}  // namespace

std::vector<std::size_t> number_third_colour(std::span<const Ports> ports, const OrderPart& part,
                                             std::span<const ColourDefect> defects,
                                             std::span<const HeightSlot> slots,
                                             std::span<PlaneNumbers> x, std::int64_t& blocks) {
  ThirdColour third(ports, part, defects, slots, x);
  std::vector<std::size_t> circle = third.run();
  blocks += third.blocks();
  return circle;
}

}  // namespace ar3d::grid
