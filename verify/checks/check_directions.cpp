#include <fmt/format.h>

#include <algorithm>

#include "ar3d/verify/checks/checks.h"
#include "ar3d/verify/checks/exact.h"

namespace ar3d::verify {

void check_directions(const Segments& segments, const Guarantee& guarantee, Findings& findings) {
  const auto& allowed = guarantee.directions;
  if (allowed.empty()) return;
  for (SegmentId s = 0; s < segments.size() && !findings.done(); ++s) {
    const Vector d = segments.direction(s);
    if (std::any_of(allowed.begin(), allowed.end(), [&](Vector a) { return parallel(d, a); }))
      continue;
    findings.add({ViolationKind::direction,
                  {},
                  {segments.edge(s)},
                  {segments.from(s), segments.to(s)},
                  fmt::format("{} is parallel to {}, not an allowed direction",
                              segments.describe(s), to_string(primitive(d)))});
  }
}

}  // namespace ar3d::verify
