#include <fmt/format.h>

#include <vector>

#include "ar3d/verify/checks/checks.h"

namespace ar3d::verify {
namespace {

void check_lengths(const Drawing& drawing, EdgeId e, const std::vector<Point>& points,
                   Findings& findings) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i - 1] != points[i]) continue;
    findings.add(
        {ViolationKind::degenerate_segment,
         {},
         {e},
         {points[i]},
         fmt::format("{} repeats the point {}", describe_edge(drawing, e), to_string(points[i]))});
  }
}

}  // namespace

void check_bends(const Drawing& drawing, const Guarantee& guarantee, Findings& findings) {
  for_each_polyline(drawing, [&](EdgeId e, const std::vector<Point>& points) {
    if (findings.done()) return;
    check_lengths(drawing, e, points, findings);
    const std::size_t bends = points.size() - 2;
    if (bends <= guarantee.max_bends) return;
    findings.add({ViolationKind::bends,
                  {},
                  {e},
                  {},
                  fmt::format("{} has {} bends, at most {} are promised", describe_edge(drawing, e),
                              bends, guarantee.max_bends)});
  });
}

}  // namespace ar3d::verify
