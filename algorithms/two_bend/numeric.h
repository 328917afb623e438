#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "ar3d/base/error.h"

namespace ar3d::two_bend {

/// Largest horizontal coordinate of a component: differences d, q then give d^2 + q^2 <= 2^61.
inline constexpr std::int64_t kMaxHorizontal = std::int64_t{1} << 30;

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

}  // namespace ar3d::two_bend
