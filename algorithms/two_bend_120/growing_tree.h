#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace ar3d::two_bend_120 {

/// A forest of names below a limit, in which children are added and ancestors compared. Each node
/// has a link to one ancestor far up, by the skew binary numbers of Myers (1983), so that a walk to
/// the root takes O(log depth) steps.
class GrowingTree {
 public:
  using Name = std::uint32_t;
  explicit GrowingTree(std::size_t limit) : nodes_(limit) {}

  void add_root(Name v) { nodes_[v] = {v, v, 0}; }
  void add(Name v, Name parent) {
    const Ancestry& above = nodes_[parent];
    const Ancestry& far = nodes_[above.link];
    const bool joins = above.depth - far.depth == far.depth - nodes_[far.link].depth;
    nodes_[v] = {parent, joins ? far.link : parent, above.depth + 1};
  }
  Name parent(Name v) const { return nodes_[v].parent; }

  /// For x != y of one tree: the ancestors of both just below their nearest common ancestor, or
  /// that itself where it is x or y. O(log depth).
  std::pair<Name, Name> branches(Name x, Name y) const {
    if (depth(x) < depth(y)) {
      const auto [first, second] = branches(y, x);
      return {second, first};
    }
    if (depth(x) > depth(y)) {
      x = ancestor(x, depth(y) + 1);
      if (parent(x) == y) return {x, y};
      x = parent(x);
    }
    while (parent(x) != parent(y)) {
      const bool far = nodes_[x].link != nodes_[y].link;
      x = far ? nodes_[x].link : parent(x);
      y = far ? nodes_[y].link : parent(y);
    }
    return {x, y};
  }

 private:
  struct Ancestry {
    Name parent = 0;
    Name link = 0;
    std::uint32_t depth = 0;
  };
  std::uint32_t depth(Name v) const { return nodes_[v].depth; }
  Name ancestor(Name v, std::uint32_t wanted) const {
    while (depth(v) > wanted) v = depth(nodes_[v].link) < wanted ? parent(v) : nodes_[v].link;
    return v;
  }
  std::vector<Ancestry> nodes_;
};

}  // namespace ar3d::two_bend_120
