// Lemma 1.3. Greedy: of three waiting items one fits behind the last vertex, since that has only
// two neighbours in the other colour. The at most two left over are put where they fit. The paper
// leaves gaps between all items instead, which costs a line for each. O(n).
#include <optional>

#include "ar3d/algorithms/diamond/guaranteed.h"

namespace ar3d::diamond {
namespace {

class Ordering {
 public:
  Ordering(const Graph& graph, const Items& items) : graph_(graph), items_(items) {}

  /// Greedy: some item among the next three fits, because an item does not fit only if all its ends
  /// are neighbours of the last vertex in the other colour, which has two of them.
  Arrangement run() {
    for (std::uint32_t item = 0; item < items_.count(); ++item) {
      waiting_.push_back(item);
      if (waiting_.size() == 3) take_fitting();
    }
    while (take_fitting()) continue;
    for (const std::uint32_t item : waiting_) place_leftover(item);
    return std::move(order_);
  }

 private:
  Vertex start(ItemInOrder p) const {
    return p.reversed ? items_.last(p.item) : items_.first(p.item);
  }
  Vertex end(ItemInOrder p) const {
    return p.reversed ? items_.first(p.item) : items_.last(p.item);
  }

  /// Can the item, in that direction, stand before index `gap`?
  bool fits(ItemInOrder p, std::size_t gap) const {
    if (gap > 0 && adjacent(graph_, end(order_[gap - 1]), start(p))) return false;
    return gap == order_.size() || !adjacent(graph_, end(p), start(order_[gap]));
  }

  std::optional<ItemInOrder> fitting_direction(std::uint32_t item, std::size_t gap) const {
    for (const bool reversed : {false, true}) {
      if (fits({item, reversed}, gap)) return ItemInOrder{item, reversed};
    }
    return std::nullopt;
  }

  bool take_fitting() {
    for (std::size_t i = 0; i < waiting_.size(); ++i) {
      if (const auto oriented = fitting_direction(waiting_[i], order_.size())) {
        order_.push_back(*oriented);
        waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(i));
        return true;
      }
    }
    return false;
  }

  /// At most two items are left over. Appends if the item fits there by now, else inserts it where
  /// it fits, else appends it behind a bad boundary.
  void place_leftover(std::uint32_t item) {
    for (std::size_t i = 0; i <= order_.size(); ++i) {
      const std::size_t gap = i == 0 ? order_.size() : i - 1;
      if (const auto oriented = fitting_direction(item, gap)) {
        order_.insert(order_.begin() + static_cast<std::ptrdiff_t>(gap), *oriented);
        return;
      }
    }
    order_.push_back({item, false});
  }

  const Graph& graph_;
  const Items& items_;
  Arrangement order_;
  std::vector<std::uint32_t> waiting_;  // at most 3, in natural order
};

}  // namespace

Arrangement order_items(const Graph& graph, const Items& items) {
  return Ordering(graph, items).run();
}

std::vector<bool> bad_boundaries(const Graph& graph, const Items& items) {
  std::vector<bool> bad(items.count(), false);
  for (std::uint32_t i = 1; i < items.count(); ++i) {
    bad[i] = adjacent(graph, items.last(i - 1), items.first(i));
  }
  return bad;
}

}  // namespace ar3d::diamond
