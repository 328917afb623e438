// Roles are read from the coordinates, not remembered by the algorithms: a drawing from a file has
// them, too.
#include "ar3d/formats/drawings/edge_roles.h"

namespace ar3d {
namespace {

constexpr Rgb kBlue = {0, 114, 178};
constexpr Rgb kVermilion = {213, 94, 0};
constexpr Rgb kGreen = {0, 158, 115};
constexpr Rgb kPurple = {204, 121, 167};
constexpr Rgb kOrange = {230, 159, 0};
constexpr Rgb kSky = {86, 180, 233};

using Polyline = std::vector<Point>;

/// Fills in the role of every edge: the number that `role` gives, the last one where it gives none.
template <class Role>
EdgeRoles with_roles(EdgeRoles kinds, const Drawing& drawing, Role&& role) {
  kinds.edges.resize(drawing.num_edges());
  const std::size_t other = kinds.roles.size() - 1;
  for_each_polyline(drawing, [&](EdgeId e, const Polyline& points) {
    kinds.edges[e] = static_cast<std::uint8_t>(std::min<std::size_t>(role(points), other));
  });
  return kinds;
}

/// Above or below the plane of the vertices, which has that normal; a bend in the middle decides.
EdgeRoles halves(const Drawing& drawing, Vector normal) {
  const auto above_or_below = [normal](const Polyline& points) -> std::size_t {
    const Vector d = points[points.size() / 2] - points[0];
    const double height = static_cast<double>(normal.x) * static_cast<double>(d.x) +
                          static_cast<double>(normal.y) * static_cast<double>(d.y) +
                          static_cast<double>(normal.z) * static_cast<double>(d.z);
    return height > 0 ? 0 : height < 0 ? 1 : 2;
  };
  return with_roles({"half of the drawing",
                     {{"green: above the vertices' plane", kGreen},
                      {"orange: below the vertices' plane", kVermilion},
                      {"neither", kPurple}},
                     {}},
                    drawing, above_or_below);
}

/// The label c of an end that leaves by delta_c: e_1 - e_2, e_2 - e_0 or e_0 - e_1 in four
/// coordinates, which the output takes to these directions; 3 if it is none.
std::size_t grid_label(Vector d) {
  constexpr std::array<Vector, 3> kLabels = {{{1, -1, 0}, {-1, 0, 1}, {0, 1, -1}}};
  const Vector unit = primitive(d);
  return static_cast<std::size_t>(std::find(kLabels.begin(), kLabels.end(), unit) -
                                  kLabels.begin());
}

EdgeRoles grid_labels(const Drawing& drawing) {
  const auto label = [](const Polyline& points) -> std::size_t {
    const std::size_t at_u = grid_label(points[1] - points[0]);
    const std::size_t at_v = grid_label(points[points.size() - 2] - points.back());
    if (at_u > 2 || at_v > 2) return 4;
    return at_u == at_v ? at_u : 3;
  };
  return with_roles({"labels at the two ends",
                     {{"U-edge, label 0 at both ends", kBlue},
                      {"U-edge, label 1 at both ends", kOrange},
                      {"U-edge, label 2 at both ends", kGreen},
                      {"defect: two labels", kPurple},
                      {"not along labels", kVermilion}},
                     {}},
                    drawing, label);
}

EdgeRoles end_types(const Drawing& drawing) {
  const auto type = [](const Polyline& points) -> std::size_t {
    const auto vertical = [](Vector d) { return d.x == 0 && d.y == 0; };
    return std::size_t{vertical(points[1] - points[0])} +
           std::size_t{vertical(points[points.size() - 2] - points.back())};
  };
  return with_roles({"how the edge meets its two ends",
                     {{"AA: two arms", kBlue},
                      {"AV or VA: an arm and a vertical end", kOrange},
                      {"VV: two vertical ends", kGreen}},
                     {}},
                    drawing, type);
}

}  // namespace

EdgeRoles edge_roles(const Drawing& drawing) {
  const std::string& algorithm = drawing.algorithm();
  if (algorithm == "diamond" || algorithm == "compact") return halves(drawing, {0, 0, 1});
  if (algorithm == "compact-120") return halves(drawing, {5, 5, -3});
  if (algorithm == "grid") return grid_labels(drawing);
  if (algorithm == "two-bend") return end_types(drawing);
  return {"", {{"edge", kSky}}, std::vector<std::uint8_t>(drawing.num_edges(), 0)};
}

GrowthOrder growth_order(const Drawing& drawing) {
  const std::string& algorithm = drawing.algorithm();
  if (algorithm == "diamond") return {"the green order, X = (x + y) / 2", {1, 1, 0}};
  if (algorithm == "compact") return {"columns of the strip, U = (x + y) / 2", {1, 1, 0}};
  if (algorithm == "compact-120") return {"columns of the strip, t = (x + y - z) / 2", {1, 1, -1}};
  if (algorithm == "two-bend") return {"the time order, z", {0, 0, 1}};
  if (algorithm == "two-bend-109") return {"the order of the parts, z", {0, 0, 1}};
  if (algorithm == "grid-paper") return {"the heights of the layers, (x - y + z) / 2", {1, -1, 1}};
  if (algorithm == "grid") return {"the sum S = (x + y + z) / 6 of the plane numbers", {1, 1, 1}};
  return {"the vertices' numbers", {0, 0, 0}};
}

}  // namespace ar3d
