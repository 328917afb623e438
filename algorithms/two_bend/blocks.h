#pragma once

#include <array>
#include <cstdint>

#include "ar3d/algorithms/two_bend/local_graph.h"

namespace ar3d::two_bend {

using BlockId = std::uint32_t;

/// A 2-edge-connected class; with degrees at most 3 it is a single vertex or biconnected.
struct Block {
  std::uint32_t size = 0;
  std::uint32_t bridges = 0;
  std::uint32_t free_count = 0;     ///< vertices with exactly two edges inside the block
  std::array<Vertex, 2> free{};     ///< up to two of them
  std::array<Vertex, 2> members{};  ///< up to two members, the last of the search
  Vertex bridge_vertex = 0;         ///< a member at a bridge, if bridges > 0
};

/// The blocks of a component and the bridges between them.
struct BlockTree {
  LongVector<BlockId> of;  ///< one entry per vertex; of no use if there is one block
  LongVector<Block> blocks;

  BlockId id_of(Vertex v) const { return blocks.size() > 1 ? of[v] : 0; }
  /// For adjacent u, v.
  bool is_bridge(Vertex u, Vertex v) const { return id_of(u) != id_of(v); }
  const Block& block_of(Vertex v) const { return blocks[id_of(v)]; }
};

/// Bridges by lowpoints over the search tree that the component's numbering already is; O(n).
BlockTree find_blocks(const LocalGraph& graph);

/// K4 with one edge subdivided: the smallest leaf block of a cubic graph ("Q"). joint is the
/// subdividing vertex, side its two neighbours, core the two that remain (core[0] core[1] is an
/// edge).
struct QBody {
  Vertex joint = 0;
  std::array<Vertex, 2> side{};
  std::array<Vertex, 2> core{};
};

/// The Q that hangs with vertex `joint` in its block, which must be one (see is_q_block).
QBody read_q_body(const LocalGraph& graph, const BlockTree& blocks, Vertex joint);

/// True if the block has five vertices, one of them with two edges inside and the others with three
/// (Step 2.1).
bool is_q_block(const Block& block);

/// Replaces every Q that hangs on a bridge by its joint, now a vertex of degree 1: cuts the other
/// four off (they keep their lists but nothing points to them) and makes the joint a block of its
/// own (Step 2.1).
/// @return the cut bodies; the cut vertices are the other four of each.
LongVector<QBody> cut_q_bodies(LocalGraph& graph, BlockTree& blocks);

}  // namespace ar3d::two_bend
