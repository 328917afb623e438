// Step P.4, a shortest cycle of what is not drawn yet: it has no chord, as the paper's proof of
// Theorem 2 demands, because a chord would make a shorter one. Breadth-first from every vertex,
// none deeper than half of the best length; a cycle of length 4 ends the search, since no triangle
// is left. Cost: O(nodes * edges) at worst.
#include "ar3d/algorithms/two_bend_paper/cycles.h"

#include <algorithm>
#include <limits>

namespace ar3d::two_bend_paper {
namespace {

constexpr std::uint32_t kUnreached = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint32_t kShortest = 4;  // there are no triangles

}  // namespace

ShortestCycle::ShortestCycle(const ContractedGraph& graph)
    : graph_(graph), depth_(graph.num_nodes(), kUnreached), parent_(graph.num_nodes()) {}

// Breadth first. The least depth(a) + depth(b) + 1 over all roots is the girth, and where it is
// reached the two ways to the root have nothing else in common: else there was a shorter cycle.
std::optional<ShortestCycle::Closing> ShortestCycle::search(Node root,
                                                            const std::vector<bool>& inside) {
  for (const Node node : reached_) depth_[node] = kUnreached;
  reached_.assign(1, root);
  depth_[root] = 0;
  parent_[root] = root;
  std::optional<Closing> closing;
  for (std::size_t i = 0; i < reached_.size(); ++i) {
    const Node a = reached_[i];
    if (best_ != 0 && 2 * depth_[a] + 1 >= best_) break;
    for (const Incidence incidence : graph_.stars[a]) {
      const Node b = incidence.to;
      if (inside[b] || b == parent_[a]) continue;
      if (depth_[b] == kUnreached) {
        depth_[b] = depth_[a] + 1;
        parent_[b] = a;
        reached_.push_back(b);
      } else if (best_ == 0 || depth_[a] + depth_[b] + 1 < best_) {
        best_ = depth_[a] + depth_[b] + 1;
        closing = {a, b};
      }
    }
  }
  return closing;
}

std::vector<Node> ShortestCycle::way_to_root(Node node) const {
  std::vector<Node> way{node};
  while (parent_[node] != node) way.push_back(node = parent_[node]);
  return way;
}

std::optional<std::vector<Node>> ShortestCycle::find(const std::vector<Node>& nodes,
                                                     const std::vector<bool>& inside) {
  best_ = 0;
  std::optional<std::vector<Node>> cycle;
  for (const Node root : nodes) {
    if (inside[root]) continue;
    const std::optional<Closing> closing = search(root, inside);
    if (!closing) continue;
    cycle = way_to_root(closing->left);
    std::reverse(cycle->begin(), cycle->end());  // root first
    const std::vector<Node> back = way_to_root(closing->right);
    cycle->insert(cycle->end(), back.begin(), back.end() - 1);
    if (best_ <= kShortest) break;
  }
  return cycle;
}

}  // namespace ar3d::two_bend_paper
