// Decides whether coordinates fit a width, by the theorem's bound for all graphs of a size or by
// looking at one drawing.
#include "ar3d/verify/coordinate_width.h"

#include <fmt/format.h>

#include "ar3d/base/error.h"
#include "ar3d/base/nearest_name.h"
#include "ar3d/base/printable.h"
#include "ar3d/verify/predicates/functional.h"

namespace ar3d {
namespace {

constexpr std::uint64_t kMostVertices = std::numeric_limits<std::uint32_t>::max();
constexpr std::array<const char*, 3> kAxes = {"x", "y", "z"};

std::int64_t largest(int bits) {
  return bits == 64 ? std::numeric_limits<std::int64_t>::max()
                    : (std::int64_t{1} << (bits - 1)) - 1;
}

/// Exact: a bound that allows the next integer allows too much; 2^63 - 1 instead of it for 64 bits.
bool proves(const SizeBound& bound, std::uint64_t n, int bits) {
  const std::int64_t beyond = bits == 64 ? largest(64) : largest(bits) + 1;
  return std::none_of(bound.axes.begin(), bound.axes.end(),
                      [&](const AxisBound& axis) { return axis.holds(beyond, n); });
}

/// Names the coordinate that does not fit, if one does not. @param number  of the vertex, or bend.
void require_fits(const std::string& what, std::uint64_t number, Point p, Point low, int bits) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int64_t offset = verify::component(p, i) - verify::component(low, i);
    if (offset <= largest(bits)) continue;
    throw InputError(fmt::format("{} {} at {}: {} is {} above the least one, int{} holds {}", what,
                                 number, to_string(p), kAxes[i], offset, bits, largest(bits)));
  }
}

}  // namespace

CoordinateWidth parse_coordinate_width(std::string_view text) {
  for (const bool proved : {false, true}) {
    for (const int bits : {16, 32, 64}) {
      if (text == fmt::format("{}=int{}", proved ? "proved" : "checked", bits)) {
        return {bits, proved};
      }
    }
  }
  throw InputError(
      fmt::format("coordinates '{}' are none of auto, checked=int16, checked=int32, checked=int64, "
                  "proved=int16, proved=int32 and proved=int64{}",
                  printable(std::string(text)),
                  did_you_mean(text, {"auto", "checked=int16", "checked=int32", "checked=int64",
                                      "proved=int16", "proved=int32", "proved=int64"})));
}

std::uint64_t proved_n(const SizeBound& bound, int bits) {
  const bool is_bound = std::any_of(bound.axes.begin(), bound.axes.end(),
                                    [](const AxisBound& axis) { return axis.value(1'000) > 0; });
  if (!is_bound) return 0;
  std::uint64_t low = 0, high = kMostVertices + 1;  // bounds do not fall as n grows
  while (high - low > 1) {
    const std::uint64_t middle = low + (high - low) / 2;
    (proves(bound, middle, bits) ? low : high) = middle;
  }
  return low;
}

void require_width(const CoordinateWidth& width, const SizeBound& bound, const Drawing& drawing) {
  if (drawing.real) throw InputError("coordinates in a real type fit no width of integers");
  if (width.proved) {
    const std::uint64_t most = proved_n(bound, width.bits);
    if (drawing.num_vertices() > most) {
      throw InputError(fmt::format("{} vertices: the bound proves int{} for at most {}",
                                   drawing.num_vertices(), width.bits, most));
    }
    return;
  }
  const Box box = bounding_box(drawing);
  const auto extents = box.extents();
  if (*std::max_element(extents.begin(), extents.end()) <= largest(width.bits)) return;
  const Point low = box.low;
  for (std::size_t v = 0; v < drawing.num_vertices(); ++v) {
    require_fits("vertex", v, drawing.vertex(static_cast<Vertex>(v)), low, width.bits);
  }
  for_each_polyline(drawing, [&](EdgeId e, const std::vector<Point>& points) {
    if (points.size() == 2) return;
    const std::string what = fmt::format("edge {}, bend", e);
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      require_fits(what, i, points[i], low, width.bits);
    }
  });
}

}  // namespace ar3d
