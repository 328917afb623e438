#include "ar3d/verify/sweep_planes.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <vector>

#include "ar3d/verify/functional.h"

namespace ar3d::verify {
namespace {

/// The planes that contain two directions, and coordinates in such a plane.
struct PlaneFamily {
  std::array<std::size_t, 2> directions;
  Vector normal;  ///< tells the planes apart
  /// across[i] is constant along direction i and not along the other: with N = d0 x d1 and N's
  /// component along the axis k not zero, (d0 x e_k) . d1 = -N_k and (d1 x e_k) . d0 = N_k.
  std::array<Vector, 2> across;
};

PlaneFamily planes_along(const DirectionClasses& classes, std::size_t i, std::size_t j) {
  const Vector a = classes.directions[i];
  const Vector b = classes.directions[j];
  const auto n = cross(a, b);  // components below 2 * 2^40, as the directions' are below 2^20
  const Vector normal = primitive({static_cast<std::int64_t>(n[0]), static_cast<std::int64_t>(n[1]),
                                   static_cast<std::int64_t>(n[2])});
  const std::size_t axis = leading_axis(normal);
  return {{i, j}, normal, {times_unit(a, axis), times_unit(b, axis)}};
}

/// A segment of one of the plane's two directions, in the coordinates of the plane: it stays at
/// `at` across its own direction and runs from low to high across the other.
template <class Key>
struct Track {
  Key at;
  Key low;
  Key high;
  SegmentId segment;
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
          contacts_.examine(row.segment, column.segment);
        }
      }
    }
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

template <class Key>
struct InPlane {
  Key plane;
  SegmentId segment;
  bool operator<(const InPlane& other) const {
    return std::pair(plane, segment) < std::pair(other.plane, other.segment);
  }
};

template <class Key>
class FamilySweep {
 public:
  FamilySweep(const Segments& segments, const DirectionClasses& classes, const PlaneFamily& family,
              Contacts& contacts)
      : segments_(segments),
        classes_(classes),
        family_(family),
        contacts_(contacts),
        plane_(contacts) {}

  void run() {
    collect();
    for (std::size_t begin = 0; begin < members_.size() && !contacts_.done();) {
      std::size_t end = begin + 1;
      while (end < members_.size() && members_[end].plane == members_[begin].plane) ++end;
      if (end - begin > 1) sweep_plane(begin, end);
      begin = end;
    }
  }

 private:
  bool is_row(SegmentId s) const { return classes_.of[s] == family_.directions[0]; }

  void collect() {
    const auto belongs = [&](std::uint8_t c) {
      return c == family_.directions[0] || c == family_.directions[1];
    };
    const auto& of = classes_.of;
    members_.reserve(static_cast<std::size_t>(std::count_if(of.begin(), of.end(), belongs)));
    for (SegmentId s = 0; s < segments_.size(); ++s) {
      if (belongs(of[s])) {
        members_.push_back({value<Key>(family_.normal, segments_.from(s)), s});
      }
    }
    std::sort(members_.begin(), members_.end());
  }

  void sweep_plane(std::size_t begin, std::size_t end) {
    plane_.rows.clear();
    plane_.columns.clear();
    for (std::size_t i = begin; i < end; ++i) {
      const SegmentId s = members_[i].segment;
      is_row(s) ? plane_.rows.push_back(track(s, 0)) : plane_.columns.push_back(track(s, 1));
    }
    if (!plane_.rows.empty() && !plane_.columns.empty()) plane_.run();
  }

  Track<Key> track(SegmentId s, std::size_t own) const {
    const Key begin = value<Key>(family_.across[1 - own], segments_.from(s));
    const Key end = value<Key>(family_.across[1 - own], segments_.to(s));
    return {value<Key>(family_.across[own], segments_.from(s)), std::min(begin, end),
            std::max(begin, end), s};
  }

  const Segments& segments_;
  const DirectionClasses& classes_;
  const PlaneFamily& family_;
  Contacts& contacts_;
  std::vector<InPlane<Key>> members_;
  PlaneSweep<Key> plane_;
};

}  // namespace

void sweep_planes(const Segments& segments, const DirectionClasses& classes, std::int64_t bound,
                  Contacts& contacts) {
  for (std::size_t i = 0; i < classes.directions.size(); ++i) {
    for (std::size_t j = i + 1; j < classes.directions.size() && !contacts.done(); ++j) {
      const PlaneFamily family = planes_along(classes, i, j);
      if (fits_int64(family.normal, bound) && fits_int64(family.across[0], bound) &&
          fits_int64(family.across[1], bound)) {
        FamilySweep<std::int64_t>(segments, classes, family, contacts).run();
      } else {
        // Coefficients below 2^41, coordinates at most 2^61: values are below 2^104.
        FamilySweep<Int128>(segments, classes, family, contacts).run();
      }
    }
  }
}

}  // namespace ar3d::verify
