// What a page says of a drawing beside its geometry, as JSON.
#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "ar3d/base/error.h"
#include "ar3d/formats/drawings/drawing_html.h"
#include "ar3d/formats/drawings/edge_roles.h"

namespace ar3d {
namespace {

using Json = nlohmann::ordered_json;

/// Exact in JSON whatever reads it: a text of digits.
Json exact(Point p) { return {std::to_string(p.x), std::to_string(p.y), std::to_string(p.z)}; }

Json roles_json(const EdgeRoles& roles) {
  Json list = Json::array();
  for (const auto& [name, colour] : roles.roles) {
    list.push_back({{"name", name}, {"colour", colour}});
  }
  return {{"title", roles.title}, {"list", list}};
}

Json bound_json(const Guarantee* guarantee, std::uint64_t n) {
  if (guarantee == nullptr || n == 0) return nullptr;
  const auto& axes = guarantee->bound.axes;
  return {{"extents", {axes[0].value(n), axes[1].value(n), axes[2].value(n)}},
          {"text", guarantee->bound.formula()}};
}

Json verdict_json(const PageVerdict& verdict) {
  Json list = Json::array();
  for (const PageViolation& violation : verdict.violations) {
    Json points = Json::array();
    for (const Point p : violation.points) points.push_back(exact(p));
    list.push_back({{"kind", violation.kind},
                    {"message", violation.message},
                    {"vertices", violation.vertices},
                    {"edges", violation.edges},
                    {"points", points}});
  }
  return {{"kind", verdict.kind}, {"text", verdict.text}, {"violations", list}};
}

/// Nothing in the text ends a script element that holds it.
std::string data_text(const Json& value) {
  return boost::algorithm::replace_all_copy(
      value.dump(-1, ' ', true, Json::error_handler_t::replace), "<", "\\u003c");
}

}  // namespace

void require_page_points(std::uint64_t points, const std::string& title) {
  if (points <= kMaxPagePoints) return;
  throw InputError(
      fmt::format("{}: {} vertices and bends on the page so far, html holds at most {}", title,
                  points, kMaxPagePoints));
}

PageEntry page_facts(const std::string& title, const Drawing& drawing, const EdgeRoles& roles,
                     const Guarantee* guarantee, const PageVerdict& verdict) {
  const std::uint64_t n = drawing.num_vertices();
  const std::uint64_t bends = count_bends(drawing);
  require_page_points(n + bends, title);
  const Box box = bounding_box(drawing);
  const auto extents = box.extents();
  const std::int64_t longest = *std::max_element(extents.begin(), extents.end());
  if (longest > kMaxPageExtent) {
    throw InputError(fmt::format("{}: an extent of {}, html holds at most {} (2^52)", title,
                                 longest, kMaxPageExtent));
  }
  const auto [order, weights] = growth_order(drawing);
  PageEntry entry;
  entry.title = title;
  entry.points = n + bends;
  entry.about = data_text({{"title", title},
                           {"algorithm", drawing.algorithm()},
                           {"n", n},
                           {"m", drawing.num_edges()},
                           {"bends", bends},
                           {"low", exact(box.low)},
                           {"extents", extents},
                           {"gram", drawing.lattice().gram},
                           {"gram_denominator", drawing.lattice().gram_denominator},
                           {"roles", roles_json(roles)},
                           {"order", {{"title", order}, {"weights", weights}}},
                           {"names", drawing.names ? Json(*drawing.names) : Json()},
                           {"bound", bound_json(guarantee, n)},
                           {"verdict", verdict_json(verdict)}});
  entry.low = box.low;
  return entry;
}

PageEntry page_entry(const std::string& title, std::uint64_t n, const std::string& error) {
  return {title, data_text({{"title", title}, {"n", n}, {"error", error}})};
}

}  // namespace ar3d
