// Lemmas V.1 and V.3: a drawing is free of crossings if and only if as many pairs of segments that
// are not parallel meet as must meet, in bends and vertices. So it is enough to count, which needs
// no names of segments and no list of meetings. Dropped: naming all pairs (near_pairs.h), which is
// the oracle, and looking through the segments of each line, a tenth of the certificate.
#include "ar3d/verify/counting/counting_proof.h"

#include <atomic>

#include "ar3d/base/parallel.h"
#include "ar3d/verify/checks/checks.h"
#include "ar3d/verify/predicates/functional.h"

namespace ar3d::verify {
namespace {

constexpr std::int64_t kFar = std::int64_t{1} << 30;
constexpr std::uint64_t kMostWindows = 64;

bool is_near(Point p) {
  const auto shifted = [](std::int64_t c) { return static_cast<std::uint64_t>(c) + kFar; };
  return ((shifted(p.x) | shifted(p.y) | shifted(p.z)) >> 31) == 0;
}

/// 20 bytes for each of six segments of a polyline and more.
bool has_room_for_all(const Drawing& drawing, const CountingSizes& sizes) {
  constexpr std::uint64_t kEdgeBytes = 128;
  return sizes.memory == 0 || kEdgeBytes * drawing.num_edges() <= sizes.memory;
}

/// The direction of the points of Lemma V.3 where all segments have direction `index`.
constexpr std::size_t across(std::size_t index) { return index == 0 ? 1 : 0; }

/// Calls visit(direction, number of neighbours seen before it) for the points of Lemma V.3 at a
/// vertex whose edges leave in the directions of `star`.
template <class Visit>
void for_each_point(std::uint32_t star, Visit&& visit) {
  if (star == 0) {
    visit(std::size_t{0}, 0);
    visit(std::size_t{1}, 1);
    return;
  }
  const std::uint32_t first = (star & 255) - 1, others = star >> 8;
  if (others == 0) visit(across(first / 2), 1);
  if (others == (first ^ 1) + 1) visit(across(first / 2), 2);
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
      keeps_segments_(has_room_for_all(drawing, sizes)),
      shares_(std::max(sizes.threads, 1u)) {
  possible_ =
      graph.num_vertices() == drawing.num_vertices() && graph.num_edges() == drawing.num_edges();
  for (const Vector d : guarantee.directions) directions_.add(d);
  promised_ids_ = 2 * directions_.indices();
  for (const Vector d : {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}}) {
    if (directions_.indices() < 2) directions_.add(d);
  }
  for (Share& share : shares_) share.possible = possible_;
  if (possible_) stars_.resize(drawing.num_vertices());
}

bool CountingProof::take_edge(Share& share, Edge ends, const std::vector<Point>& points) {
  if (!is_near(points[0])) return false;
  std::uint8_t before = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (!is_near(points[i])) return false;
    const auto found = directions_.find(points[i] - points[i - 1]);
    if (!found.known || found.id >= promised_ids_) return false;  // nor is one of length zero
    const bool reversed = found.id % 2 != 0;
    ++share.numbers[found.id / 2];
    if (keeps_segments_) {
      share.segments[found.id / 2].add(placed(points[reversed ? i : i - 1], found.steps));
    }
    if (i == 1) {
      if (!leave(share, ends.u, found.id)) return false;
    } else if (!take_neighbours(share, before ^ 1u, found.id)) {
      return false;
    } else if (found.id == before) {
      take_point(share, across(found.id / 2), points[i - 1], 2);
    }
    before = found.id;
  }
  return leave(share, ends.v, before ^ 1u);
}

/// The vertices have no order in memory: what is written to them waits until it is in the cache.
bool CountingProof::leave(Share& share, Vertex v, std::uint8_t id) {
  __builtin_prefetch(&stars_[v], 1);
  share.leaving[share.left++] = {v, id};
  return share.left < share.leaving.size() || leave_all(share);
}

bool CountingProof::leave_all(Share& share) {
  bool possible = true;
  for (std::size_t i = 0; i < share.left; ++i) {
    possible &= take_leaving(share.leaving[i].first, share.leaving[i].second);
  }
  share.left = 0;
  return possible;
}

/// False if it is the fifth.
bool CountingProof::take_leaving(Vertex v, std::uint8_t id) {
  if (shares_.size() == 1) {
    if (stars_[v] >> 24 != 0) return false;
    stars_[v] = stars_[v] << 8 | (id + 1u);
    return true;
  }
  const std::atomic_ref<std::uint32_t> star(stars_[v]);
  std::uint32_t old = star.load(std::memory_order_relaxed);
  do {
    if (old >> 24 != 0) return false;
  } while (!star.compare_exchange_weak(old, old << 8 | (id + 1u), std::memory_order_relaxed));
  return true;
}

bool CountingProof::angle_is_kept(Share& share, std::size_t id, std::size_t other) const {
  std::int8_t& seen = share.angles[id][other];
  if (seen == 0) {
    const auto order = compare_cosine(guarantee_.lattice, directions_.of_id(id),
                                      directions_.of_id(other), guarantee_.cosine);
    seen = keeps_angle(guarantee_, order) ? 1 : -1;
  }
  return seen > 0;
}

/// Two segments that leave their common end in these directions; in the same one they overlap.
bool CountingProof::take_neighbours(Share& share, std::size_t id, std::size_t other) const {
  share.crossing_neighbours += id / 2 != other / 2;
  return id != other && angle_is_kept(share, id, other);
}

/// A point of Lemma V.3, and the number of others that end there.
void CountingProof::take_point(Share& share, std::size_t direction, Point p,
                               std::size_t neighbours) const {
  share.crossing_neighbours += neighbours;
  ++share.numbers[direction];
  if (keeps_segments_) share.segments[direction].add(placed(p, 0));
}

bool CountingProof::take_star(Share& share, std::uint32_t star) const {
  for (; star != 0; star >>= 8) {
    for (std::uint32_t rest = star >> 8; rest != 0; rest >>= 8) {
      if (!take_neighbours(share, (star & 255) - 1, (rest & 255) - 1)) return false;
    }
  }
  return true;
}

/// Angles, neighbours and points at the vertices begin, ..., end - 1.
bool CountingProof::take_vertices(Share& share, Vertex begin, Vertex end) {
  for (Vertex v = begin; v < end; ++v) {
    const Point p = drawing_.vertex(v);
    if (guarantee_.vertices_in_plane && p.z != 0) return false;
    if (stars_[v] == 0 && !is_near(p)) return false;
    if (!take_star(share, stars_[v])) return false;
    for_each_point(stars_[v], [&](std::size_t direction, std::size_t neighbours) {
      take_point(share, direction, p, neighbours);
    });
  }
  return true;
}

void CountingProof::take_all_vertices() {
  for_ranges_in_threads(
      sizes_.threads, stars_.size(), [&](std::uint32_t thread, std::size_t begin, std::size_t end) {
        Share& share = shares_[thread];
        if (!share.possible) return;
        share.possible = take_vertices(share, static_cast<Vertex>(begin), static_cast<Vertex>(end));
      });
}

/// Could all edges and vertices be taken? Then their neighbours are counted.
bool CountingProof::collect_shares() {
  for (const Share& share : shares_) {
    counts_.crossing_neighbours += share.crossing_neighbours;
  }
  return std::all_of(shares_.begin(), shares_.end(), [](const Share& s) { return s.possible; });
}

std::uint64_t CountingProof::number(std::size_t direction) const {
  std::uint64_t sum = 0;
  for (const Share& share : shares_) sum += share.numbers[direction];
  return sum;
}

/// Returns how many windows a family of so many records is counted in, so that the threads' records
/// at a time hold the limit; without one, 5/8 of the memory of the segments.
std::uint32_t CountingProof::windows(std::uint64_t records) const {
  constexpr std::uint64_t kFew = std::uint64_t{1} << 18;
  std::uint64_t room = sizes_.memory / sizeof(PlaneRecord);
  if (keeps_segments_) {
    std::uint64_t segments = 0;
    for (std::size_t i = 0; i < SignedDirections::kMaxIndices; ++i) segments += number(i);
    room = std::max(kFew, 5 * segments / 8);
  }
  const std::uint64_t room_of_thread = std::max<std::uint64_t>(room / shares_.size(), 1);
  return static_cast<std::uint32_t>(
      std::clamp<std::uint64_t>((records + room_of_thread - 1) / room_of_thread, 1, kMostWindows));
}

bool CountingProof::plan_tasks(std::int64_t largest, std::vector<Task>& tasks) const {
  for (std::size_t i = 0; i < directions_.indices(); ++i) {
    for (std::size_t j = i + 1; j < directions_.indices(); ++j) {
      const std::uint64_t rows = number(i), columns = number(j);
      if (rows == 0 || columns == 0) continue;
      const PlaneFamily family(directions_, i, j);
      if (!family.fits(largest)) return false;
      const std::uint32_t count = windows(rows + columns);
      for (std::uint32_t w = 0; w < count; ++w) tasks.push_back({family, {i, j}, {w, count}});
    }
  }
  return true;
}

void CountingProof::add_stored(const Task& task, const PlaneMeetings::Intake& intake) const {
  for (const Share& share : shares_) {
    for (std::size_t side = 0; side < 2; ++side) {
      share.segments[task.directions[side]].for_each_part(
          [&](std::span<const PlacedSegment> part) { intake.add(part, side); });
    }
  }
}

void CountingProof::add_computed(const Task& task, const PlaneMeetings::Intake& intake) const {
  const std::size_t first = task.directions[0];
  const std::size_t second = task.directions[1];
  std::array<std::array<PlacedSegment, 64>, 2> waiting;  // of either side, `count` of them
  std::array<std::size_t, 2> count{};
  const auto pass_on = [&](std::size_t side) {
    intake.add(std::span(waiting[side]).first(std::exchange(count[side], 0)), side);
  };
  const auto add = [&](std::size_t direction, PlacedSegment segment) {
    if (direction != first && direction != second) return;
    const std::size_t side = direction == second;
    waiting[side][count[side]++] = segment;
    if (count[side] == waiting[side].size()) pass_on(side);
  };
  for_each_polyline(drawing_, [&](EdgeId, const std::vector<Point>& points) {
    std::size_t before = kIds;
    for (std::size_t k = 1; k < points.size(); ++k) {
      const auto found = directions_.find(points[k] - points[k - 1]);
      add(found.id / 2, placed(points[found.id % 2 != 0 ? k : k - 1], found.steps));
      if (found.id == before) add(across(before / 2), placed(points[k - 1], 0));
      before = found.id;
    }
  });
  for (Vertex v = 0; std::min(first, second) < 2 && v < stars_.size(); ++v) {
    for_each_point(stars_[v], [&](std::size_t direction, std::size_t) {
      add(direction, placed(drawing_.vertex(v), 0));
    });
  }
  for (const std::size_t side : {0u, 1u}) pass_on(side);
}

std::uint64_t CountingProof::count(const Task& task, PlaneMeetings& meetings) const {
  const std::uint64_t records = number(task.directions[0]) + number(task.directions[1]);
  const auto intake = meetings.begin(task.family, task.window, records / task.window.count);
  keeps_segments_ ? add_stored(task, intake) : add_computed(task, intake);
  return meetings.finish();
}

bool CountingProof::take_families(std::int64_t largest) {
  std::vector<Task> tasks;
  if (!plan_tasks(largest, tasks)) return false;
  const std::size_t threads = shares_.size();
  std::vector<PlaneMeetings> meetings;
  for (std::size_t t = 0; t < threads; ++t) meetings.emplace_back(sizes_);
  std::vector<std::uint64_t> found(threads);
  for_each_in_threads(sizes_.threads, tasks.size(), [&](std::uint32_t thread, std::size_t i) {
    found[thread] += count(tasks[i], meetings[thread]);
  });
  for (const std::uint64_t part : found) counts_.found.crossing += part;
  return true;
}

bool CountingProof::holds(const DrawingSummary& summary) {
  if (!possible_) return false;
  Findings findings(0);
  check_graph(graph_, drawing_, findings);
  if (!findings.empty()) return false;
  for (Share& share : shares_) share.possible = leave_all(share) && share.possible;
  take_all_vertices();
  return collect_shares() && take_families(largest_coordinate(summary.box)) && counts_.agree();
}

}  // namespace ar3d::verify
