#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>

#include "ar3d/algorithms/two_bend/coordinates.h"
#include "ar3d/algorithms/two_bend/flow.h"
#include "ar3d/base/error.h"

namespace ar3d::two_bend {

/// The least h >= 0 with h^2 >= value; 0 <= value <= 2^62.
inline std::int64_t ceil_sqrt(std::int64_t value) {
  auto h = static_cast<std::int64_t>(std::sqrt(static_cast<double>(value)));
  while (h > 0 && (h - 1) * (h - 1) >= value) --h;
  while (h * h < value) ++h;
  return h;
}

/// Least height of a lean (d, q, h) that may follow a vertical segment (Lemma 2.2): h^2 >= d^2 +
/// q^2.
inline std::int64_t lean_height(std::int64_t d, std::int64_t q) { return ceil_sqrt(d * d + q * q); }

/// An arm of length `arm` and a lean (run, q, height) that together cover `run + arm` along the
/// arm's line.
struct ArmLean {
  std::int64_t arm = 0;
  std::int64_t run = 0;
  std::int64_t height = 0;
  std::int64_t total_height() const { return arm + height; }
};

/// The condition of the lemma of arms and leans: arm and run cover `along`, the lean (run, across,
/// height) is primitive, and its bends keep Lemma 2.2 (to the vertical) and
/// Lemma 2.3 (to the arm).
inline bool is_sound(const ArmLean& shape, std::int64_t along, std::int64_t across) {
  const auto [arm, run, height] = shape;
  return arm >= 1 && run >= 1 && arm + run == along && std::gcd(run, across) == 1 &&
         height * height >= run * run + across * across &&
         2 * run * run + 2 * run * height >= across * across;
}

/// The lowest arm and lean over `along` >= 2 and across `q` >= 1 whose lean is primitive
/// (Lemma 2.10): the largest run below `along` coprime to q; the height keeps Lemmas 2.2 and 2.3.
inline ArmLean arm_and_lean(std::int64_t along, std::int64_t q) {
  expect(along >= 2 && q >= 1 && along <= kMaxHorizontal && q <= kMaxHorizontal,
         "an arm and a lean have room for both");
  std::int64_t run = along - 1;
  while (std::gcd(run, q) != 1) --run;  // ends at 1
  std::int64_t height = lean_height(run, q);
  const std::int64_t missing = q * q - 2 * run * run;
  if (missing > 0) height = std::max(height, (missing + 2 * run - 1) / (2 * run));
  const ArmLean shape{along - run, run, height};
  expect_heavy([&] { return is_sound(shape, along, q); },
               "a lean is primitive and its bends are fine");
  return shape;
}

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

/// Holds how a SINK of the view is drawn (Lemma 2.12), in the view's coordinates (cross, own,
/// time).
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
