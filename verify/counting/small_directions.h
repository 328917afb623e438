#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "ar3d/model/lattice.h"

namespace ar3d::verify {

/// The directions with components from -2 to 2, which have numbers: those that a drawing's vertices
/// see again and again. A direction and its opposite are n and kSmallDirections - 1 - n.
inline constexpr std::size_t kSmallDirections = 125;

/// The number of d's direction; nothing if it is no small one. @pre d is not zero.
inline std::optional<std::uint8_t> small_direction(Vector d) {
  const std::array<std::int64_t, 3> components{d.x, d.y, d.z};
  std::int64_t unit = 0;
  for (const std::int64_t c : components) {
    const std::int64_t size = c < 0 ? -c : c;
    if (size != 0 && (unit == 0 || size < unit)) unit = size;
  }
  // A multiple of a primitive vector with components up to 2: the smallest one is the factor.
  std::size_t number = 0;
  for (const std::int64_t c : components) {
    const std::int64_t size = c < 0 ? -c : c;
    if (size != 0 && size != unit && size != 2 * unit) return std::nullopt;
    const std::size_t steps = size == 0 ? 0 : size == unit ? 1 : 2;
    number = 5 * number + (c < 0 ? 2 - steps : 2 + steps);
  }
  return static_cast<std::uint8_t>(number);
}

inline Vector of_small_direction(std::size_t number) {
  const auto component = [](std::size_t digit) { return static_cast<std::int64_t>(digit) - 2; };
  return {component(number / 25), component(number / 5 % 5), component(number % 5)};
}

constexpr std::size_t opposite(std::size_t number) { return kSmallDirections - 1 - number; }

}  // namespace ar3d::verify
