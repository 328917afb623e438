#include "ar3d/verify/checks/directions.h"

#include <algorithm>

#include "ar3d/verify/checks/exact.h"

namespace ar3d::verify {
namespace {

bool is_small(Vector d) {
  const auto small = [](std::int64_t c) {
    return c > -kMaxDirectionComponent && c < kMaxDirectionComponent;
  };
  return small(d.x) && small(d.y) && small(d.z);
}

}  // namespace

std::optional<DirectionClasses> few_directions(const Segments& segments) {
  DirectionClasses classes;
  auto& known = classes.directions;
  classes.of.reserve(segments.size());
  for (SegmentId s = 0; s < segments.size(); ++s) {
    const Vector d = segments.direction(s);
    const auto found =
        std::find_if(known.begin(), known.end(), [&](Vector k) { return parallel(d, k); });
    classes.of.push_back(static_cast<std::uint8_t>(found - known.begin()));
    if (found != known.end()) continue;
    known.push_back(primitive(d));
    if (known.size() > kMaxDirections || !is_small(known.back())) return std::nullopt;
  }
  return classes;
}

}  // namespace ar3d::verify
