// Lemma V.1 for drawings whose long segments are vertical and whose other directions are many: the
// same counting, by columns (Steps V.9 to V.11 of docs/verify.md) instead of by planes. Angles at
// vertices are looked up by the numbers of small directions; a bend with another direction is
// decided by itself. Slabs took 3.1 to 5.5 times as long (random cubic graphs, 10^4 to 10^6).
#include "ar3d/verify/checks/checks.h"
#include "ar3d/verify/counting/counting_proof.h"
#include "ar3d/verify/predicates/exact.h"

namespace ar3d::verify {
namespace {

constexpr std::uint32_t kOther = kSmallDirections + 1;
constexpr std::int64_t kFarInColumn = std::int64_t{1} << 30;

bool is_near_enough(Point p) {
  const auto near = [](std::int64_t c) { return c > -kFarInColumn && c < kFarInColumn; };
  return near(p.x) && near(p.y) && in_range(p);
}

}  // namespace

ColumnProof::ColumnProof(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee,
                         std::size_t patience)
    : graph_(graph),
      drawing_(drawing),
      guarantee_(guarantee),
      patience_(patience),
      compare_cosine_(guarantee.lattice, guarantee.cosine) {
  possible_ = guarantee.directions.empty() && graph.num_vertices() == drawing.num_vertices() &&
              graph.num_edges() == drawing.num_edges();
  if (!possible_) return;
  stars_.resize(drawing.num_vertices());
  slanted_.reserve(drawing.num_edges());
  verticals_.reserve(drawing.num_edges());
}

/// A small direction stands for all its multiples: its angles need no wide numbers.
ColumnProof::Heading ColumnProof::heading(Vector d) {
  const auto number = small_direction(d);
  return {number ? of_small_direction(*number) : d, number};
}

ColumnProof::Heading ColumnProof::Heading::reversed() const {
  if (!number) return {-d, std::nullopt};
  return {-d, static_cast<std::uint8_t>(opposite(*number))};
}

bool ColumnProof::take_edge(Edge ends, const std::vector<Point>& points) {
  if (!is_near_enough(points[0])) return false;
  Heading before;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (!is_near_enough(points[i]) || points[i] == points[i - 1]) return false;
    if (!store(points[i - 1], points[i])) return false;
    const Heading ahead = heading(points[i] - points[i - 1]);
    if (!(i == 1 ? leave(ends.u, ahead) : take_neighbours(before.reversed(), ahead))) return false;
    before = ahead;
  }
  return leave(ends.v, before.reversed());
}

/// False if there are too many for their numbers.
bool ColumnProof::store(Point from, Point to) {
  if (from.z > to.z) std::swap(from, to);
  const auto narrow = [](std::int64_t c) { return static_cast<std::int32_t>(c); };
  const Vector d = to - from;
  if (d.x == 0 && d.y == 0) {
    verticals_.push_back({narrow(from.x), narrow(from.y), from.z, to.z});
  } else {
    slanted_.push_back({narrow(from.x), narrow(from.y), from.z, narrow(d.x), narrow(d.y), d.z});
  }
  return verticals_.size() < UINT32_MAX && slanted_.size() < UINT32_MAX;
}

/// False if it is the fifth.
bool ColumnProof::leave(Vertex v, const Heading& heading) {
  if (stars_[v] >> 24 != 0) return false;
  stars_[v] = stars_[v] << 8 | (heading.number ? *heading.number + 1u : kOther);
  if (!heading.number) others_.emplace_back(v, heading.d);
  return true;
}

bool ColumnProof::angle_is_kept(const Heading& a, const Heading& b) {
  if (!a.number || !b.number) return keeps_angle(guarantee_, compare_cosine_(a.d, b.d));
  std::int8_t& seen = angles_[*a.number][*b.number];
  if (seen == 0) seen = keeps_angle(guarantee_, compare_cosine_(a.d, b.d)) ? 1 : -1;
  return seen > 0;
}

/// Two segments that leave their common end in these directions.
bool ColumnProof::take_neighbours(const Heading& a, const Heading& b) {
  bool is_parallel = false;
  if (a.number && b.number) {
    is_parallel = *a.number == *b.number || *a.number == opposite(*b.number);
  } else if (!a.number && !b.number) {
    is_parallel = parallel(a.d, b.d);
  }
  counts_.touching_neighbours += is_parallel;
  counts_.crossing_neighbours += !is_parallel;
  return angle_is_kept(a, b);
}

/// @param next_other  where the vertex's directions in others_ begin, if it has any; moved on.
bool ColumnProof::take_star(Vertex v, std::size_t& next_other) {
  std::array<Heading, 4> leaving;
  std::size_t size = 0;
  for (std::uint32_t star = stars_[v]; star != 0; star >>= 8) {
    const std::uint32_t byte = star & 255;
    if (byte == kOther) {
      leaving[size] = {others_[next_other++].second, std::nullopt};
    } else {
      leaving[size] = {of_small_direction(byte - 1), static_cast<std::uint8_t>(byte - 1)};
    }
    for (std::size_t i = 0; i < size; ++i) {
      if (!take_neighbours(leaving[i], leaving[size])) return false;
    }
    ++size;
  }
  return true;
}

/// Angles and neighbours at the vertices. A vertex without edges becomes a vertical segment of
/// length zero.
bool ColumnProof::take_vertices() {
  std::sort(others_.begin(), others_.end());
  std::size_t next_other = 0;
  for (std::size_t i = 0; i < stars_.size(); ++i) {
    const auto v = static_cast<Vertex>(i);
    const Point p = drawing_.vertex(v);
    if (guarantee_.vertices_in_plane && p.z != 0) return false;
    const bool keeps = stars_[i] != 0 ? take_star(v, next_other) : is_near_enough(p) && store(p, p);
    if (!keeps) return false;
  }
  return true;
}

bool ColumnProof::count_meetings() {
  const Columns columns(verticals_);
  verticals_ = std::vector<VerticalSegment>();  // its memory; {} would keep it
  const auto touching = columns.touching();
  counts_.found.overlap = !touching;
  if (!touching) return false;
  counts_.found.touching += *touching;
  for (const SlantedSegment& s : slanted_) counts_.found.crossing += columns.met_by(s);
  const auto among_slanted = meetings_of_slanted(slanted_, patience_);
  if (!among_slanted) return false;
  counts_.found += *among_slanted;
  return true;
}

bool ColumnProof::holds() {
  if (!possible_) return false;
  Findings findings(0);
  check_graph(graph_, drawing_, findings);
  return findings.empty() && take_vertices() && count_meetings() && counts_.agree();
}

}  // namespace ar3d::verify
