// Numbers the directions of a drawing, up to the limits of the proof by counting; others get no
// number.
#include "ar3d/verify/counting/signed_directions.h"

#include <cstdlib>

namespace ar3d::verify {

void SignedDirections::add(Vector d) {
  const Vector direction = primitive(d);
  std::int64_t step = kMaxComponent;
  Vector unit;
  for (const Vector axis : {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}}) {
    const std::int64_t product = direction.x * axis.x + direction.y * axis.y + direction.z * axis.z;
    const std::int64_t size = std::abs(product);
    if (size >= kMaxComponent) return;
    if (size == 0 || size >= step) continue;
    step = size;
    unit = product > 0 ? axis : -axis;
  }
  if (directions_.size() == kMaxIndices || find(direction).known) return;
  const auto id = static_cast<std::uint8_t>(2 * directions_.size());
  directions_.push_back(direction);
  classes_[sense(direction)].push_back({direction, unit, step, id});
  classes_[sense(-direction)].push_back(
      {-direction, -unit, step, static_cast<std::uint8_t>(id + 1)});
}

}  // namespace ar3d::verify
