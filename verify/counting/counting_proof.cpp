// Lemma V.1: a drawing without overlaps is free of crossings if and only if as
// many pairs of segments meet as must meet, in bends and vertices. So it is enough to count, which
// needs no names of segments and no list of meetings. Naming all pairs
// (near_pairs.h) was dropped here and is the oracle.
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
  for (Share& share : shares_) share.possible = possible_;
  if (possible_) stars_.resize(drawing.num_vertices());
}

bool CountingProof::take_edge(Share& share, Edge ends, const std::vector<Point>& points) {
  if (!is_near(points[0])) return false;
  std::uint8_t before = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (!is_near(points[i])) return false;
    const auto found = directions_.find(points[i] - points[i - 1]);
    if (!found.known) return false;  // nor is a segment of length zero
    const bool reversed = found.id % 2 != 0;
    ++share.numbers[found.id / 2];
    if (keeps_segments_) {
      share.segments[found.id / 2].add(placed(points[reversed ? i : i - 1], found.steps));
    }
    if (i == 1) {
      if (!leave(share, ends.u, found.id)) return false;
    } else if (!take_neighbours(share, before ^ 1u, found.id)) {
      return false;
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

/// Two segments that leave their common end in these directions.
bool CountingProof::take_neighbours(Share& share, std::size_t id, std::size_t other) const {
  const bool is_parallel = id / 2 == other / 2;
  share.touching_neighbours += is_parallel;
  share.crossing_neighbours += !is_parallel;
  return angle_is_kept(share, id, other);
}

bool CountingProof::take_star(Share& share, std::uint32_t star) const {
  for (; star != 0; star >>= 8) {
    for (std::uint32_t rest = star >> 8; rest != 0; rest >>= 8) {
      if (!take_neighbours(share, (star & 255) - 1, (rest & 255) - 1)) return false;
    }
  }
  return true;
}

/// Angles and neighbours at the vertices begin, ..., end - 1. A vertex without edges becomes a
/// segment of length zero: it is counted as a meeting wherever it touches anything, and is no
/// neighbour.
bool CountingProof::take_vertices(Share& share, Vertex begin, Vertex end) {
  for (Vertex v = begin; v < end; ++v) {
    const Point p = drawing_.vertex(v);
    if (guarantee_.vertices_in_plane && p.z != 0) return false;
    if (stars_[v] == 0) {
      if (!is_near(p)) return false;
      ++share.numbers[0];
      if (keeps_segments_) share.segments[0].add(placed(p, 0));
    } else if (!take_star(share, stars_[v])) {
      return false;
    }
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
    counts_.touching_neighbours += share.touching_neighbours;
  }
  return std::all_of(shares_.begin(), shares_.end(), [](const Share& s) { return s.possible; });
}

std::uint64_t CountingProof::number(std::size_t direction) const {
  std::uint64_t sum = 0;
  for (const Share& share : shares_) sum += share.numbers[direction];
  return sum;
}

/// Returns those that segments have, and so many others that they are two.
std::vector<std::size_t> CountingProof::directions_to_count() const {
  std::vector<std::size_t> used;
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < directions_.indices(); ++i) {
    (number(i) > 0 ? used : others).push_back(i);
  }
  for (std::size_t i = 0; used.size() < 2; ++i) used.push_back(others[i]);
  return used;
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

/// The lines of every direction are looked at in one of its families.
bool CountingProof::plan_tasks(std::int64_t largest, std::vector<Task>& tasks) const {
  const std::vector<std::size_t> directions = directions_to_count();
  const std::size_t k = directions.size();
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = i + 1; j < k; ++j) {
      const PlaneFamily family(directions_, directions[i], directions[j]);
      if (!family.fits(largest)) return false;
      const std::uint64_t rows = number(directions[i]);
      const std::uint64_t columns = number(directions[j]);
      const bool is_pair = i % 2 == 0 && j == i + 1;
      const std::array<bool, 2> lines{
          is_pair && rows > 0, (is_pair || (k % 2 != 0 && i == 0 && j == k - 1)) && columns > 0};
      if ((rows == 0 || columns == 0) && !lines[0] && !lines[1]) continue;
      const std::uint32_t count = windows(rows + columns);
      for (std::uint32_t w = 0; w < count; ++w) {
        tasks.push_back({family, {directions[i], directions[j]}, lines, {w, count}});
      }
    }
  }
  return true;
}

void CountingProof::add_stored(const Task& task, const PlaneMeetings::Intake& intake) const {
  const PlaneMeetings::Intake local = intake;
  for (const Share& share : shares_) {
    for (std::size_t side = 0; side < 2; ++side) {
      share.segments[task.directions[side]].for_each_part(
          [&](std::span<const PlacedSegment> part) { local.add(part, side); });
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
  const auto add = [&](std::size_t side, PlacedSegment segment) {
    waiting[side][count[side]++] = segment;
    if (count[side] == waiting[side].size()) pass_on(side);
  };
  for_each_polyline(drawing_, [&](EdgeId, const std::vector<Point>& points) {
    for (std::size_t k = 1; k < points.size(); ++k) {
      const auto found = directions_.find(points[k] - points[k - 1]);
      const std::size_t direction = found.id / 2;
      if (direction != first && direction != second) continue;
      add(direction == second, placed(points[found.id % 2 != 0 ? k : k - 1], found.steps));
    }
  });
  for (std::size_t v = 0; first == 0 && v < stars_.size(); ++v) {
    if (stars_[v] == 0) add(0, placed(drawing_.vertex(static_cast<Vertex>(v)), 0));
  }
  for (const std::size_t side : {0u, 1u}) pass_on(side);
}

MeetingCounts CountingProof::count(const Task& task, PlaneMeetings& meetings) const {
  const std::uint64_t records = number(task.directions[0]) + number(task.directions[1]);
  const auto intake =
      meetings.begin(task.family, task.window, records / task.window.count, task.lines);
  keeps_segments_ ? add_stored(task, intake) : add_computed(task, intake);
  return meetings.finish();
}

bool CountingProof::take_families(std::int64_t largest) {
  std::vector<Task> tasks;
  if (!plan_tasks(largest, tasks)) return false;
  const std::size_t threads = shares_.size();
  std::vector<PlaneMeetings> meetings;
  for (std::size_t t = 0; t < threads; ++t) meetings.emplace_back(sizes_);
  std::vector<MeetingCounts> found(threads);
  for_each_in_threads(sizes_.threads, tasks.size(), [&](std::uint32_t thread, std::size_t i) {
    found[thread] += count(tasks[i], meetings[thread]);
  });
  for (const MeetingCounts& part : found) counts_.found += part;
  return true;
}

bool CountingProof::holds(const DrawingSummary& summary) {
  if (!possible_) return false;
  Findings findings(0);
  check_graph(graph_, drawing_, findings);
  if (!findings.empty()) return false;
  // Two directions at least, so that there is a family that looks at the lines of each.
  for (const Vector d : {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}}) {
    if (directions_.indices() < 2) directions_.add(d);
  }
  for (Share& share : shares_) share.possible = leave_all(share) && share.possible;
  take_all_vertices();
  return collect_shares() && take_families(largest_coordinate(summary.box)) && counts_.agree();
}

}  // namespace ar3d::verify
