#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "ar3d/verify/checks/checks.h"

namespace ar3d::verify {

void check_distinct_vertices(const Drawing& drawing, Findings& findings) {
  struct Placed {
    Point at;
    Vertex v;
    auto operator<=>(const Placed&) const = default;
  };
  std::vector<Placed> vertices;
  vertices.reserve(drawing.num_vertices());
  for (std::size_t i = 0; i < drawing.num_vertices(); ++i) {
    const auto v = static_cast<Vertex>(i);
    vertices.push_back({drawing.vertex(v), v});
  }
  std::sort(vertices.begin(), vertices.end());
  for (std::size_t i = 1; i < vertices.size() && !findings.done(); ++i) {
    const auto& [at, v] = vertices[i];
    if (vertices[i - 1].at != at) continue;
    const Vertex u = vertices[i - 1].v;
    findings.add({ViolationKind::same_point,
                  {u, v},
                  {},
                  {at},
                  fmt::format("vertices {} and {} are both at {}", u, v, to_string(at))});
  }
}

}  // namespace ar3d::verify
