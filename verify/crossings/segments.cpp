// The segments of a drawing, edge after edge, and how messages name them.
#include <fmt/format.h>

#include "ar3d/base/error.h"
#include "ar3d/verify/crossings/contacts.h"

namespace ar3d::verify {

Segments::Segments(const Drawing& drawing) : drawing_(&drawing) {
  for_each_polyline(drawing, [&](EdgeId e, const std::vector<Point>& polyline) {
    if (points_.size() + polyline.size() >= std::numeric_limits<SegmentId>::max()) {
      throw InputError(
          fmt::format("edge {}: a drawing of 2^32 - 1 points or more is not verified", e));
    }
    points_.push_back(polyline.front());
    for (std::size_t i = 1; i < polyline.size(); ++i) {
      if (polyline[i] == points_.back()) continue;
      points_.push_back(polyline[i]);
      edge_.push_back(e);
    }
  });
}

std::optional<Vertex> Segments::vertex_at(SegmentId s, Point p) const {
  if (is_first(s) && p == from(s)) return drawing_->edge(edge(s)).u;
  if (is_last(s) && p == to(s)) return drawing_->edge(edge(s)).v;
  return std::nullopt;
}

std::string describe_edge(const Drawing& drawing, EdgeId e) {
  return fmt::format("edge {} ({}-{})", e, drawing.edge(e).u, drawing.edge(e).v);
}

std::string Segments::describe(SegmentId s) const {
  return fmt::format("{}, segment {} to {}", describe_edge(*drawing_, edge(s)), to_string(from(s)),
                     to_string(to(s)));
}

}  // namespace ar3d::verify
