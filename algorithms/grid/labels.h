#pragma once

#include <cstdint>
#include <vector>

#include "ar3d/algorithms/grid/colours.h"
#include "ar3d/algorithms/grid/order.h"
#include "ar3d/algorithms/grid/placed_graph.h"
#include "ar3d/model/graph.h"

namespace ar3d::grid {

/// The labels of all half-edges, one byte per edge. A label not decided yet is kNoColour.
class EdgeLabels {
 public:
  explicit EdgeLabels(EdgeId num_edges) : both_(num_edges, kNoColour | (kNoColour << 4)) {}

  /// The label of edge e at its end v, where `to` is the other end.
  Colour at(EdgeId e, Vertex v, Vertex to) const { return (both_[e] >> shift(v, to)) & 3u; }
  void set(EdgeId e, Vertex v, Vertex to, Colour label) {
    const unsigned s = shift(v, to);
    both_[e] = static_cast<std::uint8_t>((both_[e] & ~(3u << s)) | (label << s));
  }
  /// Asks for the memory of e's labels before they are needed.
  void ask_for(EdgeId e) const { __builtin_prefetch(&both_[e], 1); }
  std::size_t size() const { return both_.size(); }

 private:
  static unsigned shift(Vertex v, Vertex to) { return v < to ? 0 : 4; }
  std::vector<std::uint8_t> both_;
};

/// The labels that need no positions.
/// Invariant: labels at a vertex differ. An edge whose two labels are equal is a U-edge; the edge
/// fr of a cubic component may have two different labels (a defect). Otherwise only a clash vertex
/// v has edges whose label at v is open: two edges to earlier w, w' with the same label lambda
/// there. Its third half-edge has lambda + 1. No neighbour of an f is a clash vertex.
struct Labels {
  EdgeLabels of;
  std::uint64_t clashes = 0;  ///< clash vertices
};

/// Step 3.2: labels in processing order, lazily for f. What the core needs; vertices are places.
/// Cost: O(n + m).
Labels label_half_edges(const PlacedGraph& graph, const ProcessingOrder& order);

}  // namespace ar3d::grid
