#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "ar3d/algorithms/two_bend/blocks.h"

namespace ar3d::two_bend {

/// Tarjan's st-orders of the blocks of one component, with work space shared by all of them.
class StOrder {
 public:
  StOrder(const LocalGraph& graph, const BlockTree& blocks);

  /// The block of s from s to t: every other vertex has an earlier and a later neighbour inside the
  /// block. s and t are different vertices of one block with at least 3 vertices. Cost: O(size of
  /// the block).
  LongVector<Vertex> order(Vertex s, Vertex t);

 private:
  /// Holds what is known of the vertex with a number; other names in it are numbers.
  struct Numbered {
    Vertex vertex = 0;
    Vertex parent = 0;
    Vertex low = 0;          // later where its indices that no child has taken begin
    std::uint32_t size = 1;  // of its subtree, in consecutive indices of the list; later their end
  };
  void search(Vertex s, Vertex t);
  void visit(Vertex v, Vertex parent);
  void find_lows();
  LongVector<Vertex> place_in_preorder();

  const LocalGraph& graph_;
  const BlockTree& blocks_;
  std::vector<bool> seen_;         // per vertex; small enough to stay in the cache
  LongVector<Vertex> number_;      // per vertex seen, in preorder
  LongVector<Numbered> numbered_;  // per number
  std::vector<bool> plus_;         // per number: which side of it the next one takes
  /// Vertices that were unseen when a neighbour was visited, and that neighbour's number: the next
  /// one last.
  LongVector<std::pair<Vertex, Vertex>> turns_;
};

/// Repairs the end of an st-order ... p5 y w c t whose last vertex has three earlier neighbours
/// (Step 2.4): permutes the last four indices so that at least two neighbours of the last vertex
/// have it as their only later neighbour.
/// @return false (list unchanged) if no case applies: possible only for 6 and 8 vertices and for K4
/// and Q blocks.
bool repair_true_sink(const LocalGraph& graph, LongVector<Vertex>& list);

/// Number of neighbours u of the list's last vertex that come before it and have no other later
/// neighbour in the list.
unsigned count_closing_neighbours(const LocalGraph& graph, const LongVector<Vertex>& list);

/// The order in which a component is swept upwards. Invariant: exactly one vertex has no earlier
/// neighbour; a vertex of degree 3 without a later neighbour has two neighbours with exactly two
/// earlier and one later neighbour, and the first vertex, if it has degree 3, has two neighbours
/// with one earlier and two later neighbours.
struct TimeOrder {
  LongVector<Vertex> list;
  bool joint = false;  ///< cubic and bridgeless: both ends are such vertices, in one block
};

/// Steps 2.2 to 2.5: the root, the walk over the block tree, repairs of true
/// sinks. Q bodies on bridges are cut off already; the component is not K4, K3,3 or a lone Q block.
/// Cost: O(n).
TimeOrder find_time_order(const LocalGraph& graph, const BlockTree& blocks);

}  // namespace ar3d::two_bend
