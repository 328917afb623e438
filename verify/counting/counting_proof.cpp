// Lemma V.1: a drawing without overlaps is free of crossings if and only if as
// many pairs of segments meet as must meet, in bends and vertices. So it is enough to count, which
// needs no names of segments and no list of meetings.
#include "ar3d/verify/counting/counting_proof.h"

#include <algorithm>
#include <cstdlib>

#include "ar3d/verify/checks.h"
#include "ar3d/verify/exact.h"

namespace ar3d::verify {
namespace {

constexpr std::int64_t kFar = std::int64_t{1} << 30;
constexpr std::uint64_t kMostWindows = 64;  // each costs a pass over all polylines

bool is_near(Point p) {
  const auto shifted = [](std::int64_t c) { return static_cast<std::uint64_t>(c) + kFar; };
  return ((shifted(p.x) | shifted(p.y) | shifted(p.z)) >> 31) == 0;
}

std::int64_t largest_coordinate(const Box& box) {
  std::int64_t largest = 0;
  for (const Point p : {box.low, box.high}) {
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  return largest;
}

constexpr std::uint64_t kSegmentBytes = sizeof(PlacedSegment) + sizeof(PlaneRecord);

/// A polyline has four segments or fewer where the limit matters.
bool has_room_for_all(const Drawing& drawing, const CountingSizes& sizes) {
  return sizes.memory == 0 || 4 * kSegmentBytes * drawing.num_edges() <= sizes.memory;
}

PlacedSegment placed(Point low, std::int32_t steps) {
  return {static_cast<std::int32_t>(low.x), static_cast<std::int32_t>(low.y),
          static_cast<std::int32_t>(low.z), steps};
}

}  // namespace

CountingProof::CountingProof(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee,
                             const CountingSizes& sizes)
    : graph_(graph),
      drawing_(drawing),
      guarantee_(guarantee),
      sizes_(sizes),
      keeps_segments_(has_room_for_all(drawing, sizes)) {
  possible_ =
      graph.num_vertices() == drawing.num_vertices() && graph.num_edges() == drawing.num_edges();
  if (possible_) stars_.resize(drawing.num_vertices());
}

bool CountingProof::take_edge(Edge ends, const std::vector<Point>& points) {
  if (!is_near(points[0])) return false;
  std::uint8_t before = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (!is_near(points[i]) || points[i] == points[i - 1]) return false;
    const auto found = directions_.find(points[i] - points[i - 1]);
    if (!found.known) return false;
    const bool reversed = found.id % 2 != 0;
    ++numbers_[found.id / 2];
    if (keeps_segments_) {
      segments_[found.id / 2].add(placed(points[reversed ? i : i - 1], found.steps));
    }
    if (i == 1) {
      if (!leave(ends.u, found.id)) return false;
    } else if (!take_neighbours(before ^ 1u, found.id)) {
      return false;
    }
    before = found.id;
  }
  return leave(ends.v, before ^ 1u);
}

/// False if it is the fifth.
bool CountingProof::leave(Vertex v, std::uint8_t id) {
  if (stars_[v] >> 24 != 0) return false;
  stars_[v] = stars_[v] << 8 | (id + 1u);
  return true;
}

bool CountingProof::right_angle(std::size_t id, std::size_t other) {
  Angle& angle = angles_[id][other];
  if (angle == Angle::unknown) {
    const auto order = compare_cosine(guarantee_.lattice, directions_.of_id(id),
                                      directions_.of_id(other), guarantee_.cosine);
    const bool right = guarantee_.angle_rule == AngleRule::exactly ? order == 0 : order <= 0;
    angle = right ? Angle::right : Angle::wrong;
  }
  return angle == Angle::right;
}

/// Two segments that leave their common end in these directions.
bool CountingProof::take_neighbours(std::size_t id, std::size_t other) {
  const bool is_parallel = id / 2 == other / 2;
  counts_.touching_neighbours += is_parallel;
  counts_.crossing_neighbours += !is_parallel;
  return right_angle(id, other);
}

bool CountingProof::take_star(std::uint32_t star) {
  for (; star != 0; star >>= 8) {
    for (std::uint32_t rest = star >> 8; rest != 0; rest >>= 8) {
      if (!take_neighbours((star & 255) - 1, (rest & 255) - 1)) return false;
    }
  }
  return true;
}

/// Angles and neighbours at the vertices. A vertex without edges becomes a segment of length zero:
/// it is counted as a meeting wherever it touches anything, and is nobody's neighbour.
bool CountingProof::take_vertices() {
  for (std::size_t i = 0; i < stars_.size(); ++i) {
    const Point p = drawing_.vertex(static_cast<Vertex>(i));
    if (guarantee_.vertices_in_plane && p.z != 0) return false;
    if (stars_[i] == 0) {
      if (!is_near(p)) return false;
      ++numbers_[0];
      if (keeps_segments_) segments_[0].add(placed(p, 0));
    } else if (!take_star(stars_[i])) {
      return false;
    }
  }
  return true;
}

bool CountingProof::allowed_directions() const {
  const auto& allowed = guarantee_.directions;
  if (allowed.empty()) return true;
  for (std::size_t i = 0; i < directions_.indices(); ++i) {
    const Vector d = directions_[i];
    if (std::none_of(allowed.begin(), allowed.end(), [&](Vector a) { return parallel(d, a); })) {
      return false;
    }
  }
  return true;
}

std::array<PlacedSegments, 2> CountingProof::window(const PlaneFamily& family, std::size_t i,
                                                    std::size_t j, std::uint64_t number,
                                                    std::uint64_t count) {
  std::array<PlacedSegments, 2> chosen;
  const auto take = [&](std::size_t direction, const PlacedSegment& segment) {
    const std::uint64_t place = family.plane_of(segment) * count >> 32;
    if (place == number) chosen[direction == i ? 0 : 1].add(segment);
  };
  for_each_polyline(drawing_, [&](EdgeId, const std::vector<Point>& points) {
    for (std::size_t k = 1; k < points.size(); ++k) {
      const auto found = directions_.find(points[k] - points[k - 1]);
      const std::size_t direction = found.id / 2;
      if (direction != i && direction != j) continue;
      take(direction, placed(points[found.id % 2 != 0 ? k : k - 1], found.steps));
    }
  });
  for (std::size_t v = 0; i == 0 && v < stars_.size(); ++v) {
    if (stars_[v] == 0) take(0, placed(drawing_.vertex(static_cast<Vertex>(v)), 0));
  }
  return chosen;
}

void CountingProof::count_family(const PlaneFamily& family, std::size_t i, std::size_t j,
                                 LinesToCount lines, PlaneMeetings& meetings) {
  if (keeps_segments_) {
    counts_.found += meetings.count(family, segments_[i], segments_[j], lines);
    return;
  }
  const std::uint64_t bytes = kSegmentBytes * (numbers_[i] + numbers_[j]);
  const std::uint64_t count = std::clamp<std::uint64_t>(bytes / sizes_.memory + 1, 1, kMostWindows);
  for (std::uint64_t number = 0; number < count; ++number) {
    const auto [rows, columns] = window(family, i, j, number, count);
    counts_.found += meetings.count(family, rows, columns, lines);
  }
}

/// Counts in all families. The lines of every direction are looked at in one of them.
bool CountingProof::take_families(std::int64_t largest) {
  PlaneMeetings meetings(sizes_);
  const std::size_t k = directions_.indices();
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = i + 1; j < k; ++j) {
      const PlaneFamily family(directions_, i, j);
      if (!family.fits(largest)) return false;
      const LinesToCount lines{i % 2 == 0 && (j == i + 1),
                               (i % 2 == 0 && j == i + 1) || (k % 2 != 0 && i == 0 && j == k - 1)};
      count_family(family, i, j, lines, meetings);
    }
  }
  return true;
}

bool CountingProof::holds(const DrawingSummary& summary) {
  if (!possible_ || !allowed_directions()) return false;
  Findings findings(0);
  check_graph(graph_, drawing_, findings);
  if (!findings.empty()) return false;
  // Two directions at least, so that there is a family that looks at the lines of each.
  for (const Vector d : {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}}) {
    if (directions_.indices() < 2) directions_.find(d);
  }
  return take_vertices() && take_families(largest_coordinate(summary.box)) && counts_.agree();
}

}  // namespace ar3d::verify
