#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ar3d/algorithms/grid/order.h"
#include "ar3d/model/graph.h"

namespace ar3d::grid {

/// One of the three edge colours 0, 1, 2. Colour c stands for the direction e_{c+1} - e_{c+2} in
/// the four coordinates (x_0, x_1, x_2, x_3) of sum 0; the half-edge labelled c leaves its vertex
/// in this direction.
using Colour = unsigned;

inline constexpr Colour kColours = 3;
inline constexpr Colour kNoColour = 3;

inline constexpr Colour next(Colour c) { return c == 2 ? 0 : c + 1; }      // c + 1 mod 3
inline constexpr Colour previous(Colour c) { return c == 0 ? 2 : c - 1; }  // c - 1 mod 3

/// A set of colours; bit c stands for colour c.
using ColourSet = unsigned;
inline constexpr ColourSet kAllColours = 7;
inline constexpr ColourSet only(Colour c) { return 1u << c; }
inline constexpr bool contains(ColourSet set, Colour c) { return ((set >> c) & 1u) != 0; }
/// The smallest colour of a non-empty set.
inline constexpr Colour first_of(ColourSet set) {
  return (set & 1u) != 0 ? 0 : (set & 2u) != 0 ? 1 : 2;
}

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
  /// Prefetches e's labels.
  void prefetch(EdgeId e) const { __builtin_prefetch(&both_[e], 1); }

 private:
  static unsigned shift(Vertex v, Vertex to) { return v < to ? 0 : 4; }
  std::vector<std::uint8_t> both_;
};

/// The half-edges at a vertex when it is processed.
struct HalfEdgesAt {
  std::array<HalfEdge, 3> back{};      ///< to earlier vertices
  std::array<Colour, 3> back_label{};  ///< of these, at their other ends
  std::array<HalfEdge, 3> forward{};
  unsigned backs = 0;
  unsigned forwards = 0;
  const HalfEdge* to_f = nullptr;  ///< in a cubic component, the edge to f, if any

  void add_back(const HalfEdge& half, Colour label) {
    back_label[backs] = label;
    back[backs++] = half;
  }
  ColourSet offered() const {
    ColourSet set = 0;
    for (unsigned i = 0; i < backs; ++i) set |= only(back_label[i]);
    return set;
  }
  /// A free label for forward[i]: rather one that its end has not received from earlier vertices,
  /// and one that leaves the next neighbour a label that it has not received.
  Colour forward_label(unsigned i, ColourSet free,
                       const std::vector<std::uint8_t>& received) const {
    ColourSet wanted = free & ~static_cast<ColourSet>(received[forward[i].to]);
    if (wanted == 0) wanted = free;
    if (i + 1 == forwards) return first_of(wanted);
    const ColourSet good_there = free & ~static_cast<ColourSet>(received[forward[i + 1].to]);
    const ColourSet considerate = wanted & ~good_there;
    return first_of(considerate != 0 ? considerate : wanted);
  }
};

/// Step 3.2: the labels that need no positions, in processing order, lazily for f. What the core
/// needs; vertices are indices.
/// Invariant: labels at a vertex differ. An edge whose two labels are equal is a U-edge; the edge
/// fr of a cubic component may have two different labels (a defect). Otherwise only a clash vertex
/// v has edges whose label at v is open: two edges to earlier w, w' with the same label lambda
/// there. Its third half-edge has lambda + 1. No neighbour of an f is a clash vertex.
/// Cost: O(n + m).
EdgeLabels label_half_edges(const PlacedGraph& graph, const ProcessingOrder& order);

}  // namespace ar3d::grid
