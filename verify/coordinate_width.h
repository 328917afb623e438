#pragma once

#include <string_view>

#include "ar3d/model/drawing.h"
#include "ar3d/model/guarantee.h"

namespace ar3d {

/// Signed integers that a drawing's coordinates are to fit, counted from the least corner of its
/// box: extents up to 2^(bits - 1) - 1.
struct CoordinateWidth {
  int bits = 64;        ///< 16, 32 or 64
  bool proved = false;  ///< the theorem's bound has to cover it, not only this drawing

  friend bool operator==(const CoordinateWidth&, const CoordinateWidth&) = default;
};

/// "checked=int16", "proved=int32", …: @throws InputError naming the text if it is none of these
/// with 16, 32 or 64 bits.
CoordinateWidth parse_coordinate_width(std::string_view text);

/// The largest n such that the bound proves extents of that width for all graphs with up to n
/// vertices; 2^32 - 1 if it does for all. 0 also where no box is promised.
std::uint64_t proved_n(const SizeBound& bound, int bits);

/// @throws InputError if the bound does not prove the width for the drawing's n (proved), or naming
/// the first vertex, else the first bend in order of edges, that does not fit (checked). O(n + m).
void require_width(const CoordinateWidth& width, const SizeBound& bound, const Drawing& drawing);

}  // namespace ar3d
