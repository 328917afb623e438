// Segments of few directions: parallel ones that meet are on one line, any others in a common plane
// of their two directions, where one is a row and the other a column. Only wrong drawings get here,
// so all values are in 128 bits: coefficients are below 2^41 and coordinates at most 2^61.
#include <algorithm>
#include <array>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "ar3d/verify/crossings/crossings.h"
#include "ar3d/verify/predicates/functional.h"

namespace ar3d::verify {

namespace {

/// A segment or a vertex, and the line of one direction that it is on.
struct OnLine {
  std::array<Int128, 2> line;  ///< of two functionals that vanish along the direction
  std::int64_t low;            ///< along the line
  std::int64_t high;
  DrawnItem item;
};

/// The functionals are independent: the direction d has a component along `axis`, and they belong
/// to the other two axes.
std::vector<OnLine> items_on_lines(const Segments& segments, const DirectionClasses& classes,
                                   std::size_t direction) {
  const Vector d = classes.directions[direction];
  const std::size_t axis = leading_axis(d);
  const Vector first = times_unit(d, (axis + 1) % 3);
  const Vector second = times_unit(d, (axis + 2) % 3);
  std::vector<OnLine> items;
  const auto add = [&](Point p, Point q, DrawnItem item) {
    const auto [low, high] = std::minmax({component(p, axis), component(q, axis)});
    items.push_back({{value(first, p), value(second, p)}, low, high, item});
  };
  for (SegmentId s = 0; s < segments.size(); ++s) {
    if (classes.of[s] == direction) add(segments.from(s), segments.to(s), {s, false});
  }
  for (Vertex v = 0; v < segments.drawing().num_vertices(); ++v) {
    const Point p = segments.drawing().vertex(v);
    add(p, p, {v, true});
  }
  return items;
}

/// Names every pair of segments of one direction that meet and every vertex on one of them: sorted
/// by line and along it, each is compared with those that begin before it ends. O((S + n)
/// log(S + n) + meetings) time, 64 bytes for each segment of the direction and each vertex.
void crossings_on_lines(const Segments& segments, const DirectionClasses& classes,
                        std::size_t direction, Contacts& contacts) {
  std::vector<OnLine> items = items_on_lines(segments, classes, direction);
  std::sort(items.begin(), items.end(), [](const OnLine& a, const OnLine& b) {
    return std::tie(a.line, a.low) < std::tie(b.line, b.low);
  });
  for (std::size_t i = 0; i < items.size() && !contacts.done(); ++i) {
    for (std::size_t j = i + 1; j < items.size() && items[j].line == items[i].line &&
                                items[j].low <= items[i].high && !contacts.done();
         ++j) {
      examine_pair(items[i].item, items[j].item, contacts);
    }
  }
}

/// A segment of one of two directions, in the coordinates of the plane of both: it stays at `at`
/// across its own direction and runs from low to high across the other.
struct Track {
  Int128 plane;
  Int128 at;
  Int128 low;
  Int128 high;
  SegmentId segment;
  bool is_row;  ///< of the first direction

  /// Where a plane sweep over the columns comes upon it.
  Int128 place() const { return is_row ? low : at; }
};

/// The segments of the directions i and j. With their planes' normal N = i x j and its component
/// along the axis k not zero, two functionals are coordinates in the plane: one is constant along i
/// and not along j, the other the reverse, as (i x e_k) . j = -N_k and (j x e_k) . i = N_k.
std::vector<Track> tracks_of(const Segments& segments, const DirectionClasses& classes,
                             std::size_t i, std::size_t j) {
  const Vector normal = plane_normal(classes.directions[i], classes.directions[j]);
  const std::size_t axis = leading_axis(normal);
  std::vector<Track> tracks;
  for (SegmentId s = 0; s < segments.size(); ++s) {
    const bool is_row = classes.of[s] == i;
    if (!is_row && classes.of[s] != j) continue;
    const Vector own = times_unit(classes.directions[is_row ? i : j], axis);
    const Vector other = times_unit(classes.directions[is_row ? j : i], axis);
    const Point p = segments.from(s);
    const auto [low, high] = std::minmax({value(other, p), value(other, segments.to(s))});
    tracks.push_back({value(normal, p), value(own, p), low, high, s, is_row});
  }
  return tracks;
}

/// Names all rows and columns that meet, plane after plane: a column is compared with the rows that
/// it passes and that were begun before it, of which those that have ended are dropped.
/// O(S log S + meetings) time, 80 bytes for each track.
void sweep_planes(std::vector<Track> tracks, Contacts& contacts) {
  std::sort(tracks.begin(), tracks.end(), [](const Track& a, const Track& b) {
    return std::tuple(a.plane, a.place(), !a.is_row) < std::tuple(b.plane, b.place(), !b.is_row);
  });
  std::set<std::pair<Int128, const Track*>> begun;  // rows of the plane, across
  for (std::size_t t = 0; t < tracks.size() && !contacts.done(); ++t) {
    const Track& track = tracks[t];
    if (t > 0 && track.plane != tracks[t - 1].plane) begun.clear();
    if (track.is_row) {
      begun.emplace(track.at, &track);
      continue;
    }
    auto row = begun.lower_bound({track.low, nullptr});
    while (row != begun.end() && row->first <= track.high && !contacts.done()) {
      if (row->second->high < track.at) {
        row = begun.erase(row);
        continue;
      }
      contacts.examine(row->second->segment, track.segment);
      ++row;
    }
  }
}

bool is_small(Vector d) {
  const auto small = [](std::int64_t c) {
    return c > -kMaxDirectionComponent && c < kMaxDirectionComponent;
  };
  return small(d.x) && small(d.y) && small(d.z);
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
  const std::size_t k = classes.directions.size();
  for (std::size_t i = 0; i < k && !contacts.done(); ++i) {
    crossings_on_lines(segments, classes, i, contacts);
  }
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = i + 1; j < k && !contacts.done(); ++j) {
      sweep_planes(tracks_of(segments, classes, i, j), contacts);
    }
  }
}

}  // namespace ar3d::verify
