// Numbers the directions of a drawing, up to the limits of the proof by counting; others get no
// number.
#include "ar3d/verify/counting/signed_directions.h"

#include <cstdlib>

#include "ar3d/verify/predicates/functional.h"

namespace ar3d::verify {

std::int32_t SignedDirections::Known::steps(Vector d) const {
  const std::int64_t step = component(direction, axis);
  const std::int64_t length = component(d, axis);
  if (step == 1) return static_cast<std::int32_t>(length);
  if (step == -1) return static_cast<std::int32_t>(-length);
  return static_cast<std::int32_t>(length / step);
}

void SignedDirections::add(Vector d) {
  const Vector direction = primitive(d);
  std::uint8_t axis = 3;
  for (std::uint8_t i = 0; i < 3; ++i) {
    const std::int64_t size = std::abs(component(direction, i));
    if (size >= kMaxComponent) return;
    if (size == 0) continue;
    if (axis == 3 || size < std::abs(component(direction, axis))) axis = i;
  }
  if (directions_.size() == kMaxIndices || find(direction).known) return;
  const auto id = static_cast<std::uint8_t>(2 * directions_.size());
  directions_.push_back(direction);
  classes_[sense(direction)].push_back({direction, id, axis});
  classes_[sense(-direction)].push_back({-direction, static_cast<std::uint8_t>(id + 1), axis});
}

}  // namespace ar3d::verify
