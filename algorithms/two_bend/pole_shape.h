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

/// How a SINK of the view is drawn (Lemma 2.12), in the view's coordinates (cross, own, time).
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

/// The shape of a SINK in a safe layout, b = 1 for the near lean (Lemma 2.13 and Lemma 2.14).
/// @param far_b  b of the far lean. @param alone  no other ray passes the SINK's slab, so leans
/// need not be primitive.
/// @throws InternalError if a lean does not fit.
PoleShape safe_pole(const View& view, const ViewValues& values, const Pole& sink,
                    std::int64_t far_b, bool alone);

/// True if the lean (e, y, h), h = ceil sqrt(e^2 + y^2), may be followed by the direction (1, 2,
/// -1) in which the SINK is reached, each axis turned so that y > 0 (Lemma 2.12).
bool lean_turns(std::int64_t e, std::int64_t y);
/// lean_turns, and the lean is primitive.
bool lean_fits(std::int64_t e, std::int64_t y);

}  // namespace ar3d::two_bend
