#include <algorithm>
#include <cstdlib>

#include "ar3d/verify/crossings/crossings.h"
#include "ar3d/verify/crossings/crossings_in_planes.h"
#include "ar3d/verify/crossings/crossings_on_lines.h"

namespace ar3d::verify {
namespace {

/// Largest absolute value of a coordinate.
std::int64_t largest_coordinate(const Segments& segments) {
  std::int64_t largest = 0;
  const auto include = [&](Point p) {
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  };
  for (SegmentId s = 0; s < segments.size(); ++s) {
    include(segments.from(s));
    include(segments.to(s));
  }
  for (std::size_t v = 0; v < segments.drawing().num_vertices(); ++v) {
    include(segments.drawing().vertex(static_cast<Vertex>(v)));
  }
  return largest;
}

}  // namespace

void test_by_plane_sweep(const Segments& segments, const DirectionClasses& classes,
                         Contacts& contacts) {
  // Segments that meet are parallel, hence on one line, or not, hence in one plane of their
  // directions.
  const std::int64_t bound = largest_coordinate(segments);
  crossings_on_lines(segments, classes, bound, contacts);
  crossings_in_planes(segments, classes, bound, contacts);
}

}  // namespace ar3d::verify
