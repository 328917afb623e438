
#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "ar3d/verify/crossings/crossings.h"
#include "ar3d/verify/crossings/radix_sort.h"
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

/// Names every pair of collinear segments that meet and every vertex on a segment.
/// @param bound  no coordinate is larger in absolute value.
/// Per direction d: a line along d is known by two independent functionals that vanish along d; the
/// segments of this direction and all vertices are sorted by line and along it, and each is
/// compared with those that begin before it ends. O((S + k n) log(S + n) + meetings) time for k
/// directions; about 48 bytes for each segment of one direction and each vertex.
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

/// The planes that contain the directions i and j: first a functional that tells them apart, then
/// two that are coordinates in them. Of these one is constant along i and not along j, the other
/// the reverse: with N = i x j and N's component along the axis k not zero, (i x e_k) . j = -N_k
/// and (j x e_k) . i = N_k.
std::array<Vector, 3> planes_along(const DirectionClasses& classes, std::size_t i, std::size_t j) {
  const Vector a = classes.directions[i];
  const Vector b = classes.directions[j];
  const auto n = cross(a, b);  // components below 2 * 2^40, as the directions' are below 2^20
  const Vector normal = primitive({static_cast<std::int64_t>(n[0]), static_cast<std::int64_t>(n[1]),
                                   static_cast<std::int64_t>(n[2])});
  const std::size_t axis = leading_axis(normal);
  return {normal, times_unit(a, axis), times_unit(b, axis)};
}

/// A segment of one of the plane's two directions, in the coordinates of the plane: it stays at
/// `at` across its own direction and runs from low to high across the other.
template <class Key>
struct Track {
  Key at;
  Key low;
  Key high;
  SegmentId segment;
  bool continues;  ///< the edge's segment before this one ends where this one begins
  bool is_row;     ///< of the family's first direction
};

/// All pairs of `rows` and `columns` that meet within one plane.
template <class Key>
class PlaneSweep {
 public:
  explicit PlaneSweep(Contacts& contacts) : contacts_(contacts) {}

  std::vector<Track<Key>> rows;
  std::vector<Track<Key>> columns;

  void run() {
    constexpr std::size_t kFewPairs = 64;
    rows.size() * columns.size() <= kFewPairs ? compare_all() : sweep();
  }

 private:
  void compare_all() {
    for (const auto& row : rows) {
      for (const auto& column : columns) {
        if (row.low <= column.at && column.at <= row.high && column.low <= row.at &&
            row.at <= column.high) {
          examine(row, column);
        }
      }
    }
  }

  /// Neighbours on an edge have one bend in common and, not being parallel, nothing else.
  void examine(const Track<Key>& row, const Track<Key>& column) {
    const auto is_next = [](const Track<Key>& a, const Track<Key>& b) {
      return b.continues && b.segment == a.segment + 1;
    };
    if (is_next(row, column) || is_next(column, row)) return;
    contacts_.examine(row.segment, column.segment);
  }

  /// Column after column; active_ holds the rows that reach the current one, ordered across.
  void sweep() {
    active_.clear();
    ends_ = rows;
    std::sort(columns.begin(), columns.end(), [](auto& a, auto& b) { return a.at < b.at; });
    std::sort(rows.begin(), rows.end(), [](auto& a, auto& b) { return a.low < b.low; });
    std::sort(ends_.begin(), ends_.end(), [](auto& a, auto& b) { return a.high < b.high; });
    std::size_t begun = 0;
    std::size_t ended = 0;
    for (const auto& column : columns) {
      if (contacts_.done()) return;
      for (; begun < rows.size() && rows[begun].low <= column.at; ++begun) {
        active_.emplace(rows[begun].at, rows[begun].segment);
      }
      for (; ended < ends_.size() && ends_[ended].high < column.at; ++ended) {
        active_.erase({ends_[ended].at, ends_[ended].segment});
      }
      stab(column);
    }
  }

  void stab(const Track<Key>& column) {
    for (auto row = active_.lower_bound({column.low, 0});
         row != active_.end() && row->first <= column.high && !contacts_.done(); ++row) {
      contacts_.examine(row->second, column.segment);
    }
  }

  Contacts& contacts_;
  std::vector<Track<Key>> ends_;
  std::set<std::pair<Key, SegmentId>> active_;
};

/// A segment of one of a family's two directions: its plane, and where it is in the plane.
template <class Key>
struct InPlane {
  Key plane;
  Track<Key> track;
};

template <class Key>
class CrossingsInPlanes {
 public:
  CrossingsInPlanes(const Segments& segments, const DirectionClasses& classes, Contacts& contacts)
      : segments_(segments), classes_(classes), contacts_(contacts), plane_(contacts) {}

  /// @param planes  as of planes_along(classes, i, j).
  void run(std::size_t i, std::size_t j, const std::array<Vector, 3>& planes) {
    collect(i, j, planes);
    order_by_plane();
    for (std::size_t begin = 0; begin < order_.size() && !contacts_.done();) {
      std::size_t end = begin + 1;
      while (end < order_.size() && order_[end].key == order_[begin].key) ++end;
      if (end - begin > 1) cross_plane(begin, end);
      begin = end;
    }
  }

 private:
  /// Reads the segments in their order, so that only the members are read out of order later.
  void collect(std::size_t i, std::size_t j, const std::array<Vector, 3>& planes) {
    members_.clear();
    for (SegmentId s = 0; s < segments_.size(); ++s) {
      const auto direction = classes_.of[s];
      const bool is_row = direction == i;
      if (!is_row && direction != j) continue;
      const Vector across = planes[is_row ? 2 : 1];
      const Key begin = value<Key>(across, segments_.from(s));
      const Key end = value<Key>(across, segments_.to(s));
      const Key at = value<Key>(planes[is_row ? 1 : 2], segments_.from(s));
      members_.push_back(
          {value<Key>(planes[0], segments_.from(s)),
           {at, std::min(begin, end), std::max(begin, end), s, !segments_.is_first(s), is_row}});
    }
  }

  /// Afterwards equal keys in order_ mean one plane.
  void order_by_plane() {
    order_.resize(members_.size());
    for (std::size_t i = 0; i < order_.size(); ++i) order_[i] = {0, static_cast<SegmentId>(i)};
    if constexpr (std::is_same_v<Key, std::int64_t>) {
      const auto lowest = std::min_element(members_.begin(), members_.end(),
                                           [](auto& a, auto& b) { return a.plane < b.plane; });
      for (std::size_t i = 0; i < order_.size(); ++i) {
        order_[i].key = std::uint64_t(members_[i].plane) - std::uint64_t(lowest->plane);
      }
      sort_by_key(order_, buffer_);
    } else {
      std::sort(order_.begin(), order_.end(),
                [&](auto& a, auto& b) { return members_[a.item].plane < members_[b.item].plane; });
      for (std::size_t i = 1; i < order_.size(); ++i) {
        const bool same = members_[order_[i].item].plane == members_[order_[i - 1].item].plane;
        order_[i].key = order_[i - 1].key + (same ? 0 : 1);
      }
    }
  }

  void cross_plane(std::size_t begin, std::size_t end) {
    plane_.rows.clear();
    plane_.columns.clear();
    for (std::size_t i = begin; i < end; ++i) {
      const auto& track = members_[order_[i].item].track;
      __builtin_prefetch(&members_[order_[std::min(i + 16, order_.size() - 1)].item]);
      (track.is_row ? plane_.rows : plane_.columns).push_back(track);
    }
    if (!plane_.rows.empty() && !plane_.columns.empty()) plane_.run();
  }

  const Segments& segments_;
  const DirectionClasses& classes_;
  Contacts& contacts_;
  std::vector<InPlane<Key>> members_;
  std::vector<Keyed> order_;
  std::vector<Keyed> buffer_;
  PlaneSweep<Key> plane_;
};

/// Names every pair of segments of different directions that meet.
/// @param bound  no coordinate is larger in absolute value.
/// Two such segments lie in a common plane that contains both directions. So for each pair of
/// directions the segments are grouped by their plane, and within a plane the two directions serve
/// as axes: there the test is that of horizontal against vertical segments. O(k S log S + meetings)
/// time for k directions; 72 bytes for each segment of two directions, and a plane's segments.
void crossings_in_planes(const Segments& segments, const DirectionClasses& classes,
                         std::int64_t bound, Contacts& contacts) {
  CrossingsInPlanes<std::int64_t> narrow(segments, classes, contacts);
  // Coefficients below 2^41, coordinates at most 2^61: values are below 2^104.
  CrossingsInPlanes<Int128> wide(segments, classes, contacts);
  for (std::size_t i = 0; i < classes.directions.size(); ++i) {
    for (std::size_t j = i + 1; j < classes.directions.size() && !contacts.done(); ++j) {
      const std::array<Vector, 3> planes = planes_along(classes, i, j);
      const bool is_narrow =
          std::all_of(planes.begin(), planes.end(), [&](Vector f) { return fits_int64(f, bound); });
      is_narrow ? narrow.run(i, j, planes) : wide.run(i, j, planes);
    }
  }
}

bool is_small(Vector d) {
  const auto small = [](std::int64_t c) {
    return c > -kMaxDirectionComponent && c < kMaxDirectionComponent;
  };
  return small(d.x) && small(d.y) && small(d.z);
}

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

void test_by_plane_sweep(const Segments& segments, const DirectionClasses& classes,
                         Contacts& contacts) {
  // Segments that meet are parallel, hence on one line, or not, hence in one plane of their
  // directions.
  const std::int64_t bound = largest_coordinate(segments);
  crossings_on_lines(segments, classes, bound, contacts);
  crossings_in_planes(segments, classes, bound, contacts);
}

}  // namespace ar3d::verify
