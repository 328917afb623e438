#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <vector>

#include "ar3d/model/lattice.h"

namespace ar3d::verify {

/// Directions numbered in the order in which they are added, up to the limits of the proof by
/// counting. A direction and its opposite share an index; an id is 2 * index, plus 1 for the
/// opposite sense.
class SignedDirections {
 public:
  static constexpr std::size_t kMaxIndices = 16;
  static constexpr std::int64_t kMaxComponent = std::int64_t{1} << 20;

  struct Found {
    bool known = false;  ///< false if the direction has no number
    std::uint8_t id = 0;
    std::int32_t steps = 0;  ///< d = steps * of_id(id), steps > 0
  };

  /// Gives d's direction a number, if it has none and keeps the limits. @pre d is not zero.
  void add(Vector d) {
    const Vector direction = primitive(d);
    std::int64_t step = kMaxComponent;
    Vector unit;
    for (const Vector axis : {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}}) {
      const std::int64_t product =
          direction.x * axis.x + direction.y * axis.y + direction.z * axis.z;
      const std::int64_t size = std::abs(product);
      if (size >= kMaxComponent) return;
      if (size == 0 || size >= step) continue;
      step = size;
      unit = product > 0 ? axis : -axis;
    }
    if (directions_.size() == kMaxIndices || find(direction).known) return;
    const auto twos = static_cast<unsigned>(std::countr_zero(static_cast<std::uint64_t>(step)));
    const auto odd = static_cast<std::uint64_t>(step >> twos);
    std::uint64_t inverse = odd;  // in 3 bits; each of Newton's steps doubles them
    for (int i = 0; i < 5; ++i) inverse *= 2 - odd * inverse;
    const auto id = static_cast<std::uint8_t>(2 * directions_.size());
    directions_.push_back(direction);
    for (const bool reversed : {false, true}) {
      const std::int64_t sign = reversed ? -1 : 1;
      classes_[sense(sign * direction)].push_back(
          {sign * direction, sign * unit, twos, inverse, static_cast<std::uint8_t>(id + reversed)});
    }
  }
  /// The zero vector is not known. @pre d's components are below 2^31 in absolute value.
  Found find(Vector d) const {
    for (const Known& known : classes_[sense(d)]) {
      // A primitive vector steps along all its multiples; products are below 2^31 * 2^20.
      const Vector unit = known.unit;
      const std::int64_t length = d.x * unit.x + d.y * unit.y + d.z * unit.z;
      // If the length is a multiple of the step, this divides them; if not, d is another vector.
      const auto steps = static_cast<std::int64_t>(
          (static_cast<std::uint64_t>(length) >> known.twos) * known.inverse);
      if (steps <= 0 || steps >> 31 != 0 || steps * known.direction != d) continue;
      return {true, known.id, static_cast<std::int32_t>(steps)};
    }
    return {};
  }

  std::size_t indices() const { return directions_.size(); }
  /// The primitive vector of an index.
  Vector operator[](std::size_t index) const { return directions_[index]; }
  Vector of_id(std::size_t id) const {
    return id % 2 == 0 ? directions_[id / 2] : -directions_[id / 2];
  }

 private:
  struct Known {
    Vector direction;
    Vector unit;            ///< along an axis; its product with the direction is the step
    unsigned twos;          ///< factors 2 of the step
    std::uint64_t inverse;  ///< of its odd part, modulo 2^64
    std::uint8_t id;
  };

  static std::size_t sense(Vector d) {
    const auto sign = [](std::int64_t c) { return std::size_t{c > 0} + 2 * std::size_t{c < 0}; };
    return 9 * sign(d.x) + 3 * sign(d.y) + sign(d.z);
  }

  std::vector<Vector> directions_;
  std::array<std::vector<Known>, 27> classes_;  ///< by the signs of the components
};

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
