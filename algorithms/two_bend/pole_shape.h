#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "ar3d/algorithms/two_bend/coordinates.h"
#include "ar3d/algorithms/two_bend/flow.h"

namespace ar3d::two_bend {

/// Rows and columns of all nodes as one view sees them: `own` are its rows, `cross` the other
/// view's.
struct ViewValues {
  const Values& own;
  const Values& cross;
};

/// One of the two ordinary edges of a SINK: a lean from its stem to a point P, then b times (sign,
/// -2, -1) to the SINK.
struct PoleLean {
  NodeId from = kNone;
  std::int64_t b = 0;
  std::int64_t height = 0;  ///< of the lean
};

/// How a SINK of the view is drawn (5.3), in the view's coordinates (cross, own, time).
struct PoleShape {
  std::int64_t cross = 0;          ///< of the SINK
  std::int64_t own = 0;            ///< of the SINK: the row of its special edge
  std::int64_t special_cross = 0;  ///< where the special edge's vertical piece stands
  int sign = 0;                    ///< of special_cross - cross
  PoleLean up;                     ///< from the side of larger rows
  PoleLean down;
};

/// Searches b = 1, 2, ... up to (gap - 1) / 2 for both leans; nothing if one finds none.
/// @param gap  distance that is free of owners on both sides of the special row.
std::optional<PoleShape> fit_pole(const View& view, const ViewValues& values, const Pole& sink,
                                  std::int64_t gap);

/// The shape of the safe round: b = 1 for the near lean, far_b for the far one; expects that both
/// fit.
PoleShape safe_pole(const View& view, const ViewValues& values, const Pole& sink, std::int64_t gap,
                    std::int64_t far_b);

/// True if a lean (e, y, ceil sqrt(e^2 + y^2)) is primitive and may be followed by the direction
/// (1, 2, -1) in which the SINK is reached (its own axis turned so that y > 0): 2 (3e + 6y - h)^2
/// >= ... with equality allowed.
bool lean_fits(std::int64_t e, std::int64_t y);

}  // namespace ar3d::two_bend
