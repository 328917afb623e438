// Step F.4, the heart of the proof: the orders a and b without a solver. In a, swept downwards, a U
// goes between its prongs, and a D to its stem. All vertices whose ways up pass one D lie together,
// in an order that is known except for its direction, which is that of the D in b. In b the same
// holds upside down. So each fork's direction is that of another one of the other kind, or known;
// such a chain ends, or goes around between two edges that cut the graph and agrees with itself or not.
// Cost: O(n log n), for the ancestors.
#include <optional>
#include <utility>

#include "ar3d/algorithms/two_bend_120/growing_tree.h"
#include "ar3d/algorithms/two_bend_120/numbering.h"

namespace ar3d::two_bend_120 {
namespace {

/// One of the two orders without directions. It is swept from its root, T for a and S for b. A
/// *splitter* (U for a, D for b) was swept after its two prongs, a *follower* after its stem.
/// Each follower and the root owns a list: of itself, its item n + v, and of those v that it
/// dominates directly, their items v: all ways from them to the root pass the owner.
class NestedOrder {
 public:
  /// @param outer  the neighbours of the root in their order.
  NestedOrder(const std::vector<Fork>& forks, bool for_a, std::array<Vertex, 3> outer)
      : forks_(forks),
        for_a_(for_a),
        size_(static_cast<Vertex>(forks_.size())),
        root_(for_a ? size_ - 1 : 0),
        dominators_(size_),
        insertions_(std::size_t{2} * size_),
        inserted_(std::size_t{2} * size_),
        links_(std::size_t{2} * size_),
        ends_(size_, {kNone, kNone}),
        reversed_(size_) {
    start(outer);
    for (Vertex i = 4; i + 1 < size_; ++i) sweep(for_a ? size_ - 1 - i : i);
  }

  /// For a splitter: the owner of the list in which it and its prongs are.
  Vertex dominator(Vertex v) const { return dominators_.parent(v); }
  /// For a splitter: whether the second prong comes before the first one in that list.
  bool prongs_reversed(Vertex v) const { return reversed_[v]; }

  /// Whether v comes before w in sequence(backwards): two splitters, not joined. O(log n).
  bool comes_before(Vertex v, Vertex w, const std::vector<bool>& backwards) const {
    const auto [x, y] = dominators_.branches(v, w);
    return before(x, y) != backwards[dominators_.parent(x)];
  }

  /// The vertices, the list of a follower v backwards if backwards[v]; of a splitter and the
  /// follower whose stem it is, the D.
  std::vector<Vertex> sequence(const std::vector<bool>& backwards) const {
    std::vector<Vertex> result;
    std::vector<std::pair<Item, bool>> open;  // an item to come, and whether its list is backwards
    const auto enter = [&](Vertex owner) {
      const bool back = backwards[owner];
      open.emplace_back(ends_[owner][back ? 1 : 0], back);
    };
    enter(root_);
    while (!open.empty()) {
      const auto [item, back] = open.back();
      open.pop_back();
      const Item next = links_[item][back ? 0 : 1];
      if (next != kNone) open.emplace_back(next, back);
      const Vertex v = item < size_ ? item : item - size_;
      if (item >= size_ || (splits(v) && !joined(v))) {
        result.push_back(for_a_ || !joined(v) ? v : forks_[v].stem);
      } else {
        enter(splits(v) ? forks_[v].stem : v);
      }
    }
    return result;
  }

 private:
  using Item = std::uint32_t;
  static constexpr Item kNone = kNoVertex;

  bool splits(Vertex v) const { return forks_[v].opens_up == for_a_; }
  /// True if v and its stem are a D and the U above it: at S and T all forks are alike.
  bool joined(Vertex v) const { return splits(v) != splits(forks_[v].stem); }

  void start(std::array<Vertex, 3> outer);
  void sweep(Vertex v);
  void split(Vertex v);
  void own_list(Vertex v);
  void insert(Vertex owner, Item item, Item beside, bool after);
  bool before(Item x, Item y) const;

  const std::vector<Fork>& forks_;
  bool for_a_;
  Vertex size_;
  Vertex root_;
  GrowingTree dominators_;
  GrowingTree insertions_;  // of items: each below the one beside which it was inserted
  std::vector<std::pair<std::uint32_t, bool>> inserted_;  // per item: when, and whether after
  std::vector<std::array<Item, 2>> links_;  // per item: the ones before and after it in its list
  std::vector<std::array<Item, 2>> ends_;   // per owner: the first and last item of its list
  std::vector<bool> reversed_;              // per splitter
  std::uint32_t time_ = 0;
};

void NestedOrder::start(std::array<Vertex, 3> outer) {
  dominators_.add_root(root_);
  insertions_.add_root(outer[1]);
  links_[outer[1]] = {kNone, kNone};
  ends_[root_] = {outer[1], outer[1]};
  insert(root_, outer[0], outer[1], false);
  insert(root_, outer[2], outer[1], true);
  for (const Vertex v : outer) {
    dominators_.add(v, root_);
    own_list(v);
  }
}

void NestedOrder::own_list(Vertex v) {
  const Item own = size_ + v;
  insertions_.add_root(own);
  links_[own] = {kNone, kNone};
  ends_[v] = {own, own};
}

void NestedOrder::sweep(Vertex v) {
  if (splits(v)) return split(v);
  const Vertex stem = forks_[v].stem;
  dominators_.add(v, stem);
  if (!splits(stem)) insert(stem, v, size_ + stem, v == forks_[stem].prongs[1]);
  own_list(v);
}

/// Inserts v between the two items of one list that hold its prongs.
void NestedOrder::split(Vertex v) {
  const auto prongs = forks_[v].prongs;
  auto [first, second] = dominators_.branches(prongs[0], prongs[1]);
  Vertex owner = dominators_.parent(first);
  Item one = first, other = second;
  if (owner == second) {
    other = size_ + second;
  } else if (dominators_.parent(second) == first) {
    owner = first;
    one = size_ + first;
  }
  dominators_.add(v, owner);
  reversed_[v] = !before(one, other);
  insert(owner, v, reversed_[v] ? other : one, true);
}

void NestedOrder::insert(Vertex owner, Item item, Item beside, bool after) {
  insertions_.add(item, beside);
  inserted_[item] = {++time_, after};
  const Item far = links_[beside][after ? 1 : 0];
  links_[item][after ? 0 : 1] = beside;
  links_[item][after ? 1 : 0] = far;
  links_[beside][after ? 1 : 0] = item;
  if (far == kNone) {
    ends_[owner][after ? 1 : 0] = item;
  } else {
    links_[far][after ? 0 : 1] = item;
  }
}

/// True if x stands before y in their list: all that was ever inserted beside an item, on one side
/// of it, stands there, the later the nearer.
bool NestedOrder::before(Item x, Item y) const {
  const auto [left, right] = insertions_.branches(x, y);
  const auto [left_time, is_left_after] = inserted_[left];
  const auto [right_time, is_right_after] = inserted_[right];
  if (insertions_.parent(right) == left) return is_right_after;
  if (insertions_.parent(left) == right) return !is_left_after;
  if (is_left_after != is_right_after) return is_right_after;
  return is_left_after == (left_time > right_time);
}

/// For every inner vertex: whether its first prong has the larger value, in a for a U and in b for
/// a D. A chain of vertices whose directions hang together is followed to one that is known, or
/// around. @return nothing if one that goes around does not agree with itself.
std::optional<std::vector<bool>> directions(const std::vector<Fork>& forks, const NestedOrder& a,
                                            const NestedOrder& b) {
  const auto order_of = [&](Vertex v) -> const NestedOrder& { return forks[v].opens_up ? a : b; };
  std::vector<bool> backwards(forks.size()), known(forks.size()), met(forks.size());
  known.front() = known.back() = true;
  std::vector<Vertex> chain;
  for (Vertex begin = 0; begin < forks.size(); ++begin) {
    Vertex v = begin;
    for (; !known[v] && !met[v]; v = order_of(v).dominator(v)) {
      chain.push_back(v);
      met[v] = true;
    }
    if (!known[v]) {  // v is free, if the others of its circle leave it as it is
      bool turns = false;
      for (auto w = chain.rbegin(); w != chain.rend(); ++w) {
        turns = turns != order_of(*w).prongs_reversed(*w);
        if (*w == v) break;
      }
      if (turns) return std::nullopt;
    }
    for (; !chain.empty(); chain.pop_back()) {
      const Vertex w = chain.back();
      backwards[w] = backwards[order_of(w).dominator(w)] != order_of(w).prongs_reversed(w);
      known[w] = true;
    }
  }
  return backwards;
}

/// The splitter of the three that comes second.
Vertex median(const NestedOrder& order, const std::vector<bool>& backwards,
              const std::array<Vertex, 3>& three) {
  const auto [u, v, w] = three;
  const bool is_uv = order.comes_before(u, v, backwards);
  const bool is_vw = order.comes_before(v, w, backwards);
  if (is_uv == is_vw) return v;
  return is_uv == order.comes_before(u, w, backwards) ? w : u;
}

}  // namespace

std::optional<Orders> find_orders(const std::vector<Fork>& forks) {
  const auto neighbours = [](Vertex first, std::size_t middle) {
    std::array<Vertex, 3> near{};
    for (Vertex i = 0; i < 3; ++i) near[(i + 4 - middle) % 3] = first + i;
    return near;
  };
  std::array<std::optional<NestedOrder>, 3> a, b;
  for (std::size_t trial = 0; trial < 9; ++trial) {  // Lemma F.6: one of them does
    const std::size_t i = trial / 3, j = trial % 3;
    const auto above = neighbours(static_cast<Vertex>(forks.size()) - 4, i);
    const auto below = neighbours(1, j);
    if (!a[i]) a[i].emplace(forks, true, above);
    if (!b[j]) b[j].emplace(forks, false, below);
    const auto backwards = directions(forks, *a[i], *b[j]);
    if (!backwards) continue;
    if (median(*b[j], *backwards, above) == above[1]) continue;
    if (median(*a[i], *backwards, below) == below[1]) continue;
    return Orders{a[i]->sequence(*backwards), b[j]->sequence(*backwards)};
  }
  return std::nullopt;
}

}  // namespace ar3d::two_bend_120
