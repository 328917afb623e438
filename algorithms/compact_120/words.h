#pragma once

// The words of the edges: p (long), s1, q (long), s2, r (long), s3, from tail to head; s1, s2 and
// s3 have length 1. Edges to the left are mirror images of edges to the right.

#include <array>
#include <vector>

#include "ar3d/algorithms/compact_120/letters.h"
#include "ar3d/algorithms/strips/lines.h"

namespace ar3d::compact_120 {

using strips::Piece;

/// The direction e_gain - e_lose.
struct UnitStep {
  std::uint8_t gain = 0;
  std::uint8_t lose = 1;
  friend bool operator==(const UnitStep&, const UnitStep&) = default;
};
inline void step(Quad& x, UnitStep d, std::int32_t length) {
  x[d.gain] += length;
  x[d.lose] -= length;
}
inline UnitStep mirrored(UnitStep d) {
  constexpr std::array<std::uint8_t, 4> kIndex = {0, 2, 1, 3};
  return {kIndex[d.lose], kIndex[d.gain]};
}

/// p, s1, q, s2, r, s3.
using Word = std::array<UnitStep, 6>;

/// Holds what determines the word of an edge.
struct Shape {
  bool right = true;  ///< from tail to head
  Arrival at = Arrival::on_12;
  unsigned variant = 0;  ///< below variants(at); 0 is the one of the size bound's proof
};

inline unsigned variants(Arrival at) { return at == Arrival::on_12 ? 2 : 1; }

/// The word of an edge to the right; it arrives at N on 12 or 20, at T on 12 or 01.
const Word& right_word(Arrival at, unsigned variant);

/// The word of any edge.
Word word_of(const Shape& shape);

/// An edge between two vertices, seen such that it runs to the right: the edge itself, or its
/// mirror image. Long lengths are forced by the two ends; the word fits if all are at least 1.
class Route {
 public:
  /// @param tail, head  the vertices' own points. O(1).
  Route(const Shape& shape, const Quad& tail, const Quad& head);

  const std::array<std::int32_t, 3>& lengths() const { return lengths_; }
  bool fits() const { return lengths_[0] >= 1 && lengths_[1] >= 1 && lengths_[2] >= 1; }
  /// At least the largest x0 + x2 of a bend: that of the first long segment's end, and 1.
  std::int32_t top() const { return tail_[0] + tail_[2] + lengths_[0] + 1; }
  /// The contested segment of the edge, its middle one (q).
  Piece middle() const;
  /// Appends the five bends from tail to head.
  void append_bends(std::vector<Point>& out) const;

 private:
  const Word* word_;  ///< never null
  bool right_;
  Quad tail_;  ///< of the edge to the right
  std::array<std::int32_t, 3> lengths_{};
};

}  // namespace ar3d::compact_120
