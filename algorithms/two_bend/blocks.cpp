// Step 2.1: bridges and blocks by Tarjan's lowpoints, and the smallest leaf block, Q, cut off. Q
// has too few vertices for a SINK with two MERGEs below it, so it gets a drawing of its own. Cost:
// O(n).
#include "ar3d/algorithms/two_bend/blocks.h"

#include <algorithm>

#include "ar3d/base/error.h"

namespace ar3d::two_bend {
namespace {

/// low[v]: least vertex reached from v's subtree by at most one back edge.
LongVector<Vertex> lowpoints(const LocalGraph& graph) {
  LongVector<Vertex> low(graph.size());
  for (Vertex v = graph.size(); v-- > 0;) {
    Vertex least = v;
    const NeighbourList& near = graph.neighbours[v];
    for (std::size_t k = 0; k < near.degree(); ++k) {
      const Vertex u = near.to[k];
      if (u > v && graph.parent[u] == v) {
        least = std::min(least, low[u]);
      } else if (u != graph.parent[v]) {
        least = std::min(least, u);
      }
    }
    low[v] = least;
  }
  return low;
}

void register_vertex(const LocalGraph& graph, BlockTree& blocks, Vertex v) {
  Block& block = blocks.blocks[blocks.id_of(v)];
  const NeighbourList& near = graph.neighbours[v];
  unsigned inside = 0;
  for (std::size_t k = 0; k < near.degree(); ++k) {
    if (!blocks.is_bridge(v, near.to[k])) ++inside;
  }
  block.bridges += static_cast<std::uint32_t>(near.degree()) - inside;
  if (inside < near.degree()) block.bridge_vertex = v;
  if (inside == 2 && block.free_count++ < 2) block.free[block.free_count - 1] = v;
  block.members[block.size++ % 2] = v;
}

}  // namespace

BlockTree find_blocks(const LocalGraph& graph) {
  BlockTree result{lowpoints(graph), {}};
  for (Vertex v = 0; v < graph.size(); ++v) {
    if (v == 0 || result.of[v] == v) {  // the edge to the parent is a bridge
      result.of[v] = static_cast<BlockId>(result.blocks.size());
      result.blocks.emplace_back();
    } else {
      result.of[v] = result.of[graph.parent[v]];
    }
  }
  if (result.blocks.size() == 1) release(result.of);
  for (Vertex v = 0; v < graph.size(); ++v) register_vertex(graph, result, v);
  return result;
}

bool is_q_block(const Block& block) { return block.size == 5 && block.free_count == 1; }

QBody read_q_body(const LocalGraph& graph, const BlockTree& blocks, Vertex joint) {
  QBody body{joint, {}, {}};
  std::size_t sides = 0;
  const NeighbourList& near = graph.neighbours[joint];
  for (std::size_t k = 0; k < near.degree(); ++k) {
    if (!blocks.is_bridge(joint, near.to[k])) body.side[sides++] = near.to[k];
  }
  std::size_t cores = 0;
  for (const Vertex v : graph.neighbours[body.side[0]].to) {
    if (v != joint && v != body.side[1]) body.core[cores++] = v;
  }
  expect(sides == 2 && cores == 2 && graph.adjacent(body.core[0], body.core[1]) &&
             graph.adjacent(body.side[1], body.core[0]) &&
             graph.adjacent(body.side[1], body.core[1]),
         "a Q block is K4 with one edge subdivided");
  return body;
}

LongVector<QBody> cut_q_bodies(LocalGraph& graph, BlockTree& blocks) {
  LongVector<QBody> bodies;
  for (Block& block : blocks.blocks) {
    if (!is_q_block(block) || block.bridges == 0) continue;
    const QBody body = read_q_body(graph, blocks, block.free[0]);
    const NeighbourList near = graph.neighbours[body.joint];
    std::size_t bridge = 0;
    while (!blocks.is_bridge(body.joint, near.to[bridge])) ++bridge;
    graph.neighbours[body.joint] = NeighbourList{{near.to[bridge], kNoVertex, kNoVertex}};
    graph.edges[body.joint][0] = graph.edges[body.joint][bridge];
    block = Block{1, 1, 0, {}, {body.joint, body.joint}, body.joint};
    bodies.push_back(body);
  }
  return bodies;
}

}  // namespace ar3d::two_bend
