#include "ar3d/verify/crossings/crossings_on_lines.h"

#include <algorithm>
#include <tuple>
#include <vector>

#include "ar3d/verify/metrics/functional.h"

namespace ar3d::verify {
namespace {

/// A family of parallel lines: which line a point is on, and where.
struct LineFamily {
  Vector first;      // both functionals vanish along the direction and are independent, as the
  Vector second;     // direction has a component along `axis` and they belong to the other two axes
  std::size_t axis;  // positions along a line
};

LineFamily lines_along(Vector d) {
  const std::size_t axis = leading_axis(d);
  return {times_unit(d, (axis + 1) % 3), times_unit(d, (axis + 2) % 3), axis};
}

template <class Key>
struct OnLine {
  Key first;
  Key second;
  std::int64_t low;
  std::int64_t high;
  std::uint32_t id;
  bool is_vertex;

  bool same_line(const OnLine& other) const {
    return first == other.first && second == other.second;
  }
  bool operator<(const OnLine& other) const {
    return std::tie(first, second, low) < std::tie(other.first, other.second, other.low);
  }
};

template <class Key>
std::vector<OnLine<Key>> items_on(const LineFamily& lines, const Segments& segments,
                                  const DirectionClasses& classes, std::size_t direction) {
  std::vector<OnLine<Key>> items;
  const auto add = [&](Point p, Point q, std::uint32_t id, bool is_vertex) {
    const std::int64_t begin = component(p, lines.axis);
    const std::int64_t end = component(q, lines.axis);
    items.push_back({value<Key>(lines.first, p), value<Key>(lines.second, p), std::min(begin, end),
                     std::max(begin, end), id, is_vertex});
  };
  const Drawing& drawing = segments.drawing();
  const auto members = std::count(classes.of.begin(), classes.of.end(), direction);
  items.reserve(static_cast<std::size_t>(members) + drawing.num_vertices());
  for (SegmentId s = 0; s < segments.size(); ++s) {
    if (classes.of[s] == direction) add(segments.from(s), segments.to(s), s, false);
  }
  for (std::size_t v = 0; v < drawing.num_vertices(); ++v) {
    const Point p = drawing.vertex(static_cast<Vertex>(v));
    add(p, p, static_cast<Vertex>(v), true);
  }
  return items;
}

template <class Key>
void examine(const OnLine<Key>& a, const OnLine<Key>& b, Contacts& contacts) {
  if (a.is_vertex && b.is_vertex) return;
  if (a.is_vertex) {
    contacts.examine_vertex(a.id, b.id);
  } else if (b.is_vertex) {
    contacts.examine_vertex(b.id, a.id);
  } else {
    contacts.examine(a.id, b.id);
  }
}

template <class Key>
void crossings_along(const LineFamily& lines, const Segments& segments,
                     const DirectionClasses& classes, std::size_t direction, Contacts& contacts) {
  auto items = items_on<Key>(lines, segments, classes, direction);
  std::sort(items.begin(), items.end());
  for (std::size_t i = 0; i < items.size() && !contacts.done(); ++i) {
    for (std::size_t j = i + 1; j < items.size() && items[j].same_line(items[i]) &&
                                items[j].low <= items[i].high && !contacts.done();
         ++j) {
      examine(items[i], items[j], contacts);
    }
  }
}

}  // namespace

void crossings_on_lines(const Segments& segments, const DirectionClasses& classes,
                        std::int64_t bound, Contacts& contacts) {
  for (std::size_t i = 0; i < classes.directions.size() && !contacts.done(); ++i) {
    const LineFamily lines = lines_along(classes.directions[i]);
    if (fits_int64(lines.first, bound) && fits_int64(lines.second, bound)) {
      crossings_along<std::int64_t>(lines, segments, classes, i, contacts);
    } else {
      // Coefficients below 2^20, coordinates at most 2^61: values are below 2^83.
      crossings_along<Int128>(lines, segments, classes, i, contacts);
    }
  }
}

}  // namespace ar3d::verify
