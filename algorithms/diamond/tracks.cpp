// Step 1.7, and the numbers of Lemma 1.6. The paper's labels of the edges' ends, read off item by
// item: U flips the side, Z keeps it. Where a Z is needed, the track at distance 1 of the paper
// can put the apex on a turn; distance 2 then works (Lemma 1.1). The extents are measured on the
// way, so that candidates can be compared without any bend in memory. O(n + m).
#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>

#include "ar3d/algorithms/diamond/routes.h"
#include "ar3d/base/error.h"
#include "ar3d/base/parallel.h"

namespace ar3d::diamond {
namespace {

/// A plane point as a colour sees it: `a` orders the colour's items (green: X), `b` is the other
/// coordinate.
struct SeenPoint {
  std::int32_t a = 0;
  std::int32_t b = 0;
};

/// Coordinates and tracks are below 2^30 in absolute value (placement.h), so a sum or a difference
/// of two of them fits 32 bits, and the length of a plane path, three distances, 32 bits without a
/// sign.
struct CoordinateRange {
  std::int32_t low = std::numeric_limits<std::int32_t>::max();
  std::int32_t high = std::numeric_limits<std::int32_t>::min();
  void include(std::int32_t value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void include(CoordinateRange other) {
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }
};

/// The vertices and the tracks of one colour so far.
struct ColourReach {
  CoordinateRange a_minus_b;
  CoordinateRange a_plus_b;
  std::uint32_t length = 0;  ///< of the longest plane path; the height is half of it
};

/// Returns the length of the plane path from p to q along a track.
std::uint32_t length(SeenPoint p, SeenPoint q, std::int32_t track) {
  const auto distance = [](std::int32_t s, std::int32_t t) {
    return static_cast<std::uint32_t>(std::abs(s - t));
  };
  return distance(p.a, q.a) + distance(track, p.b) + distance(track, q.b);
}

/// Chooses the tracks of one colour, item by item, and measures them.
class Labels {
 public:
  Labels(const Items& items, const PlanePoints& at, Colour colour, Tracks& tracks)
      : items_(items),
        at_(at),
        colour_(colour),
        code_(tracks.code.data()),
        edges_end_(items.edge.data() + items.edge.size()),
        last_edge_(static_cast<EdgeId>(tracks.code.size()) - 1) {}

  /// Widens what the vertices reach.
  ColourReach run(ColourReach of_vertices) {
    reach_ = of_vertices;
    for (std::uint32_t item = 0; item < items_.count(); ++item) {
      if (items_.size(item) == 1) continue;
      read_points(item);
      edge_ = items_.edge.data() + items_.begin[item];
      if (items_.is_cycle(item)) {
        label_cycle();
      } else {
        label_path(+1, kNone);
      }
    }
    points_ = UnwrittenVector<SeenPoint>();  // its memory, which the other colour takes
    return reach_;
  }

 private:
  void read_points(std::uint32_t item) {
    points_.resize(items_.size(item));
    CoordinateRange used;
    SeenPoint* next = points_.data();
    for_each_ahead(items_.vertex, at_, items_.begin[item], items_.begin[item + 1],
                   [&](std::size_t, PlanePoint p) {
                     const SeenPoint s = seen(p);
                     *next++ = s;
                     used.include(s.b);
                   });
    used_ = used;
  }

  SeenPoint seen(PlanePoint p) const {
    return colour_ == kGreen ? SeenPoint{p.X, p.Y} : SeenPoint{p.Y, p.X};
  }

  static int direction(SeenPoint from, SeenPoint to) { return to.b > from.b ? 1 : -1; }

  /// The side on which the closing edge runs shorter. Nothing but the ends is used so far.
  int shorter_side() const {
    const std::int64_t sum = std::int64_t{points_.front().b} + points_.back().b;
    return 2 * std::int64_t{used_.high} - sum <= sum - 2 * std::int64_t{used_.low} ? 1 : -1;
  }

  /// The path edge i to draw as Z so that the closing edge is on side `side`; 0: either side.
  /// The first edge starts on the side opposite to the closing edge, and i U's flip that i times; a
  /// Z starts towards its other end.
  std::uint32_t find_z(int side) const {
    for (std::uint32_t i = 0; i + 1 < points_.size(); ++i) {
      const SeenPoint p = points_[i];
      const SeenPoint q = points_[i + 1];
      if (z_distance(q.a - p.a, q.b - p.b) > 0 && (side == 0 || first_sign(i) == -side)) return i;
    }
    return kNone;
  }
  int first_sign(std::uint32_t z) const {
    const int toward = direction(points_[z], points_[z + 1]);
    return z % 2 == 0 ? toward : -toward;
  }

  void label_cycle() {
    int side = shorter_side();
    std::uint32_t z = kNone;
    if (points_.size() % 2 == 1) {
      z = find_z(side);
      if (z == kNone) z = find_z(0);
      expect(z != kNone, "an odd cycle has an edge that can be drawn as Z");
      side = -first_sign(z);
    }
    label_path(-side, z);
    route(points_.back(), points_.front(), side > 0 ? used_.high + 1 : used_.low - 1,
          edge_[points_.size() - 1]);
  }

  /// Routes the path edges, the first one starting on side `sign`, edge z as Z.
  void label_path(int sign, std::uint32_t z) {
    const auto edges = static_cast<std::uint32_t>(points_.size() - 1);
    if (z == kNone) return label_us(0, edges, sign);
    label_us(0, z, sign);
    if (z % 2 == 1) sign = -sign;
    const SeenPoint p = points_[z];
    const SeenPoint q = points_[z + 1];
    route(p, q, p.b + sign * z_distance(q.a - p.a, q.b - p.b), edge_[z]);
    label_us(z + 1, edges, sign);
  }

  /// Routes the path edges begin, ..., end - 1 as U's, alternately on either side. A path edge runs
  /// upwards in `a`, so of the four points of a U two can be outermost.
  void label_us(std::uint32_t begin, std::uint32_t end, int sign) {
    const SeenPoint* const points = points_.data();
    const EdgeId* const edges = edge_;
    std::int32_t* const code = code_;
    const auto red = static_cast<std::int32_t>(colour_);
    ColourReach reach = reach_;
    CoordinateRange used = used_;
    const auto up = [&](std::uint32_t i) {
      const SeenPoint p = points[i];
      const SeenPoint q = points[i + 1];
      const std::int32_t track = std::max(p.b, q.b) + 1;
      code[edges[i]] = 2 * track + red;
      used.high = std::max(used.high, track);
      reach.a_minus_b.low = std::min(reach.a_minus_b.low, p.a - track);
      reach.a_plus_b.high = std::max(reach.a_plus_b.high, q.a + track);
      reach.length = std::max(reach.length, length(p, q, track));
    };
    const auto down = [&](std::uint32_t i) {
      const SeenPoint p = points[i];
      const SeenPoint q = points[i + 1];
      const std::int32_t track = std::min(p.b, q.b) - 1;
      code[edges[i]] = 2 * track + red;
      used.low = std::min(used.low, track);
      reach.a_minus_b.high = std::max(reach.a_minus_b.high, q.a - track);
      reach.a_plus_b.low = std::min(reach.a_plus_b.low, p.a + track);
      reach.length = std::max(reach.length, length(p, q, track));
    };
    // Edges of the next items are prefetched, too; the last edge stands for none.
    const auto ahead = static_cast<std::size_t>(edges_end_ - edges);
    const auto prefetch = [&](EdgeId e) { __builtin_prefetch(&code[std::min(e, last_edge_)], 1); };
    std::uint32_t i = begin;
    if (sign < 0 && i < end) down(i++);
    for (; i + 1 < end; i += 2) {
      if (i + kAhead + 1 < ahead) {
        prefetch(edges[i + kAhead]);
        prefetch(edges[i + kAhead + 1]);
      }
      up(i);
      down(i + 1);
    }
    if (i < end) up(i);
    reach_ = reach;
    used_ = used;
  }

  /// Any edge of the item.
  void route(SeenPoint p, SeenPoint q, std::int32_t track, EdgeId edge) {
    code_[edge] = 2 * track + static_cast<std::int32_t>(colour_);
    used_.include(track);
    for (const std::int32_t a : {p.a, q.a}) {
      reach_.a_minus_b.include(a - track);
      reach_.a_plus_b.include(a + track);
    }
    reach_.length = std::max(reach_.length, length(p, q, track));
  }

  const Items& items_;
  const PlanePoints& at_;
  const Colour colour_;
  std::int32_t* code_;
  UnwrittenVector<SeenPoint> points_;  // of the item at hand
  CoordinateRange used_;               // its places and tracks in `b` so far
  const EdgeId* edge_ = nullptr;       // its edges
  const EdgeId* edges_end_;            // of all items
  EdgeId last_edge_;                   // the largest number
  ColourReach reach_;
};

}  // namespace

Tracks choose_tracks(const Graph& graph, const Placement& placement) {
  Tracks tracks;
  tracks.code.resize(graph.num_edges());
  if (placement.at.empty()) return tracks;
  CoordinateRange x;
  CoordinateRange y;
  for (const PlanePoint p : placement.at) {
    x.include(p.X - p.Y);
    y.include(p.X + p.Y);
  }
  // x = X - Y: green sees a - b, red sees b - a.
  const auto turned = [](CoordinateRange range) {
    return CoordinateRange{-range.high, -range.low};
  };
  std::array<ColourReach, 2> reach{ColourReach{x, y}, ColourReach{turned(x), y}};
  const auto label = [&](Colour colour) {
    const Items& items = colour == kGreen ? placement.green : placement.red;
    reach[colour] = Labels(items, placement.at, colour, tracks).run(reach[colour]);
  };
  for_each_in_threads(threads_for(graph.num_vertices()), 2,
                      [&](std::uint32_t, std::size_t i) { label(i == 0 ? kGreen : kRed); });
  x = reach[kGreen].a_minus_b;
  x.include(turned(reach[kRed].a_minus_b));
  y = reach[kGreen].a_plus_b;
  y.include(reach[kRed].a_plus_b);
  tracks.extents = {std::int64_t{x.high} - x.low, std::int64_t{y.high} - y.low,
                    std::int64_t{reach[kGreen].length / 2} + reach[kRed].length / 2};
  return tracks;
}

}  // namespace ar3d::diamond
