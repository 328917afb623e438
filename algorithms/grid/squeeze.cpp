// Step 3.14, squeezing: compaction in one dimension, as layouts of circuits are compacted, along one
// diagonal at a time. Points that segments of other directions join form a block, which keeps its
// shape. Blocks next to each other on a line of the diagonal stay a step apart, so they keep their
// order. An outermost face goes in as far as that allows; blocks in its way are pushed along, as
// little as possible: a longest path of differences. Points of even sum stay so, and on them edges
// meet in such points only (Lemma R.1 of docs/routed.md). Cost: sorting the points.
#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <queue>
#include <tuple>

#include "ar3d/algorithms/efforts.h"
#include "ar3d/algorithms/grid/grid.h"

namespace ar3d::grid {
namespace {

using Block = std::uint32_t;

using Axis = std::int64_t Point::*;
constexpr std::array<Axis, 3> kAxes = {&Point::x, &Point::y, &Point::z};

constexpr std::int64_t kLongest = std::int64_t{1} << 19;  // side of a box, so 21 bits a coordinate

/// The component on each of them that comes first is 1.
constexpr std::array<Vector, 6> kDiagonals = {
    {{1, 1, 0}, {1, -1, 0}, {1, 0, 1}, {1, 0, -1}, {0, 1, 1}, {0, 1, -1}}};

/// The ends and bends of all edges, and which pairs of them are joined by segments.
struct Polylines {
  std::vector<Point> points;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> segments;
  Vector difference(std::size_t s) const {
    return points[segments[s].second] - points[segments[s].first];
  }
};

std::int64_t steps_of(Vector d) { return std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}); }

/// Parts of a polyline that are moved along a diagonal.
class Blocks {
 public:
  Blocks(const Polylines& lines, Vector diagonal) : d_(diagonal), of_(lines.points.size()) {
    find_blocks(lines);
    find_gaps(lines);
    moved_.resize(boxes_.size());
  }

  /// Pushes the faces in, one after the other, until none moves.
  /// @return the extents of the box then.
  std::array<std::int64_t, 3> push_faces() {
    for (int failed = 0, face = 0; failed < 6; face = (face + 1) % 6) {
      const bool moves = push_face(kAxes[static_cast<std::size_t>(face / 2)], face % 2 == 0);
      failed = moves ? 0 : failed + 1;
    }
    return all_.extents();
  }

  void move(Polylines& lines) const {
    for (std::size_t i = 0; i < of_.size(); ++i) {
      lines.points[i] = lines.points[i] + moved_[of_[i]] * d_;
    }
  }

 private:
  /// Two blocks next to each other on a line of the diagonal, and the steps between them.
  using Gap = std::tuple<Block, Block, std::int64_t>;

  bool is_along(Vector difference) const {
    return difference == steps_of(difference) * d_ || difference == steps_of(difference) * -d_;
  }

  void find_blocks(const Polylines& lines) {
    std::iota(of_.begin(), of_.end(), 0u);
    const auto root = [this](Block i) {
      while (of_[i] != i) i = of_[i] = of_[of_[i]];
      return i;
    };
    for (std::size_t s = 0; s < lines.segments.size(); ++s) {
      if (is_along(lines.difference(s))) continue;
      of_[root(lines.segments[s].first)] = root(lines.segments[s].second);
    }
    std::vector<Block> number(of_.size());
    Block count = 0;
    for (Block i = 0; i < of_.size(); ++i) {
      of_[i] = root(i);
      if (of_[i] == i) number[i] = count++;
    }
    std::vector<GrowingBox> boxes(count);
    GrowingBox all;
    for (std::size_t i = 0; i < of_.size(); ++i) {
      of_[i] = number[of_[i]];
      boxes[of_[i]].add(lines.points[i]);
      all.add(lines.points[i]);
    }
    for (const GrowingBox& box : boxes) boxes_.push_back(box.box());
    all_ = all.box();
  }

  /// The points of blocks, line after line: where the block changes is a gap.
  void find_gaps(const Polylines& lines) {
    std::vector<std::pair<std::uint64_t, Block>> entries;  // the line, then the position on it
    const auto bits = [](std::int64_t c) { return static_cast<std::uint64_t>(c + kLongest); };
    const auto add = [&](Point p, Block block) {
      const Vector q = p - all_.low;
      const std::int64_t t = d_.x != 0 ? q.x : q.y;
      const std::int64_t other = d_.x != 0 ? q.y - t * d_.y : q.x;
      entries.emplace_back(bits(other) << 42 | bits(q.z - t * d_.z) << 21 | bits(t), block);
    };
    for (std::size_t i = 0; i < of_.size(); ++i) add(lines.points[i], of_[i]);
    for (std::size_t s = 0; s < lines.segments.size(); ++s) {
      const Vector d = lines.difference(s);
      if (is_along(d)) continue;
      const std::int64_t count = steps_of(d);
      const Vector step = {d.x / count, d.y / count, d.z / count};
      const auto first = lines.segments[s].first;
      for (std::int64_t t = 1; t < count; ++t) add(lines.points[first] + t * step, of_[first]);
    }
    std::sort(entries.begin(), entries.end());
    std::vector<Gap> gaps;
    for (std::size_t i = 1; i < entries.size(); ++i) {
      const auto& [at, block] = entries[i];
      const auto& [before, block_before] = entries[i - 1];
      if (at >> 21 == before >> 21 && block != block_before) {
        gaps.emplace_back(block_before, block, static_cast<std::int64_t>(at - before));
      }
    }
    std::sort(gaps.begin(), gaps.end());
    gaps_of_.resize(boxes_.size());
    for (std::size_t i = 0; i < gaps.size(); ++i) {
      const auto [before, after, apart] = gaps[i];
      if (i > 0 && before == std::get<0>(gaps[i - 1]) && after == std::get<1>(gaps[i - 1]))
        continue;
      gaps_of_[before].push_back(gaps[i]);
      gaps_of_[after].push_back(gaps[i]);
    }
  }

  bool is_inside(Block block, std::int64_t moved) const {
    const Point low = boxes_[block].low + moved * d_;
    const Point high = boxes_[block].high + moved * d_;
    return low.x >= all_.low.x && low.y >= all_.low.y && low.z >= all_.low.z &&
           high.x <= all_.high.x && high.y <= all_.high.y && high.z <= all_.high.z;
  }

  /// How far the blocks go at least, in the direction `sign`, if a face goes in by so many steps.
  /// @return whether all of them stay in the box.
  bool find_ways(Axis axis, bool is_high, int sign, std::int64_t by,
                 std::vector<std::int64_t>& way) const {
    std::priority_queue<std::pair<std::int64_t, Block>> queue;
    way.assign(boxes_.size(), 0);
    const auto need = [&](Block block, std::int64_t steps) {
      if (steps <= way[block]) return;
      way[block] = steps;
      queue.emplace(steps, block);
    };
    for (Block block = 0; block < boxes_.size(); ++block) {
      const Vector moved = moved_[block] * d_;
      const std::int64_t free = is_high ? all_.high.*axis - (boxes_[block].high + moved).*axis
                                        : (boxes_[block].low + moved).*axis - all_.low.*axis;
      need(block, by - free);
    }
    while (!queue.empty()) {
      const auto [steps, block] = queue.top();
      queue.pop();
      if (steps != way[block]) continue;
      if (!is_inside(block, moved_[block] + sign * steps)) return false;
      for (const auto& [before, after, apart] : gaps_of_[block]) {
        if (block != (sign < 0 ? after : before)) continue;
        const std::int64_t room = apart + moved_[after] - moved_[before] - 1;
        need(sign < 0 ? before : after, steps - room);
      }
    }
    return true;
  }

  /// Pushes one face in as far as possible: by doubled and halved steps.
  bool push_face(Axis axis, bool is_high) {
    const std::int64_t component = (Point{} + d_).*axis;
    if (component == 0) return false;
    const int sign = is_high == (component > 0) ? -1 : 1;
    std::int64_t done = 0;
    std::int64_t too_far = all_.high.*axis - all_.low.*axis + 1;
    std::vector<std::int64_t> way;
    while (done + 1 < too_far) {
      const std::int64_t by = std::max(done + 1, std::min(2 * done, (done + too_far) / 2));
      (find_ways(axis, is_high, sign, by, way) ? done : too_far) = by;
    }
    if (done == 0) return false;
    find_ways(axis, is_high, sign, done, way);
    for (Block block = 0; block < way.size(); ++block) moved_[block] += sign * way[block];
    Point& corner = is_high ? all_.high : all_.low;
    corner.*axis += is_high ? -done : done;
    return true;
  }

  Vector d_;
  std::vector<Block> of_;  // by point
  std::vector<Box> boxes_;
  Box all_;
  std::vector<std::vector<Gap>> gaps_of_;  // by block
  std::vector<std::int64_t> moved_;        // by block, in steps of the diagonal
};

/// The points of a drawing, vertices first, then the bends of one edge after the other.
Polylines polylines(const Drawing& drawing) {
  Polylines lines;
  for (Vertex v = 0; v < drawing.num_vertices(); ++v) lines.points.push_back(drawing.vertex(v));
  for_each_polyline(drawing, [&](EdgeId e, const std::vector<Point>& points) {
    std::uint32_t last = drawing.edge(e).u;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      const auto next = static_cast<std::uint32_t>(lines.points.size());
      lines.points.push_back(points[i]);
      lines.segments.emplace_back(last, next);
      last = next;
    }
    lines.segments.emplace_back(last, drawing.edge(e).v);
  });
  return lines;
}

}  // namespace

Drawing squeezed(const Graph& graph, Drawing drawing) {
  Polylines lines = polylines(drawing);
  std::int64_t length = 0;
  for (std::size_t s = 0; s < lines.segments.size(); ++s) length += steps_of(lines.difference(s));
  const auto extents = bounding_box(drawing).extents();
  if (length > kMostSqueezed || std::ranges::max(extents) >= kLongest) return drawing;
  for (Volume before = 0, now = volume_of(extents); 100 * now < 99 * before || before == 0;) {
    before = now;
    for (const Vector& diagonal : kDiagonals) {
      Blocks blocks(lines, diagonal);
      now = volume_of(blocks.push_faces());
      blocks.move(lines);
    }
  }
  auto next = lines.points.begin() + static_cast<std::ptrdiff_t>(drawing.num_vertices());
  const std::vector<Point> vertices(lines.points.begin(), next);
  std::vector<std::vector<Point>> bends;
  for_each_polyline(drawing, [&](EdgeId, const std::vector<Point>& points) {
    const auto end = next + static_cast<std::ptrdiff_t>(points.size() - 2);
    bends.emplace_back(next, end);
    next = end;
  });
  Drawing result = drawing_from_points(drawing.algorithm(), graph, vertices, bends);
  result.counters = std::move(drawing.counters);
  result.instance_bound = drawing.instance_bound;
  return result;
}

}  // namespace ar3d::grid
