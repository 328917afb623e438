#pragma once

#include <optional>
#include <vector>

#include "ar3d/algorithms/two_bend_paper/contraction.h"

namespace ar3d::two_bend_paper {

/// A shortest cycle among the given nodes of a graph, hence without chord; consecutive nodes are
/// adjacent, the last one and the first too. The first that a search from every node in the order
/// of `nodes` finds. Cost: O(nodes * edges); a search goes no deeper than half of the best length.
class ShortestCycle {
 public:
  explicit ShortestCycle(const ContractedGraph& graph);
  /// @param inside  nodes that do not count.
  std::optional<std::vector<Node>> find(const std::vector<Node>& nodes,
                                        const std::vector<bool>& inside);

 private:
  struct Closing {
    Node left = 0;
    Node right = 0;
  };
  std::optional<Closing> search(Node root, const std::vector<bool>& inside);
  std::vector<Node> way_to_root(Node node) const;

  const ContractedGraph& graph_;
  std::uint32_t best_ = 0;            // length of the best cycle so far
  std::vector<std::uint32_t> depth_;  // in the search at hand
  std::vector<Node> parent_;
  std::vector<Node> reached_;  // by the search at hand, in order
};

}  // namespace ar3d::two_bend_paper
