#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "ar3d/model/drawing.h"
#include "ar3d/model/guarantee.h"
#include "ar3d/verify/predicates/widths.h"

namespace ar3d::precision {

/// What the predicates of a drawing's certificate are asked.
struct Decisions {
  Lattice lattice;
  Cosine cosine;
  std::vector<std::array<Point, 3>> angles;  ///< at the second point
  std::vector<std::array<Point, 4>> pairs;   ///< ends of two segments whose boxes meet
  verify::PredicateBits bits;                ///< that all decisions of the drawing need
};

/// At most so many of the drawing's angles, spread evenly, and of its pairs of segments: each with
/// those among the 200 before it, upwards, whose boxes meet its own.
Decisions decisions_of(const Drawing& drawing, const Guarantee& guarantee, std::size_t most);

}  // namespace ar3d::precision
