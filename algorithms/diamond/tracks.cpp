// Step 1.7, and the numbers of Lemma 1.6. The paper's labels of the edges' ends, read off item by
// item: U flips the side, Z keeps it. Where a Z is needed, the track at distance 1 of the paper
// can put the apex on a turn; distance 2 then works (Lemma 1.1). The extents are measured on the
// way, so that candidates can be compared without any bend in memory. O(n + m).
#include <algorithm>

#include "ar3d/algorithms/diamond/in_threads.h"
#include "ar3d/algorithms/diamond/routes.h"
#include "ar3d/model/error.h"
#include "ar3d/model/long_vector.h"

namespace ar3d::diamond {
namespace {

/// A plane point as a colour sees it: `a` orders the colour's items (green: X), `b` is the other
/// coordinate.
struct Seen {
  std::int32_t a = 0;
  std::int32_t b = 0;
};

struct Range {
  std::int64_t low = 0;
  std::int64_t high = 0;
  void include(std::int64_t value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

/// Chooses the tracks of one colour, item by item, and measures them.
class Labels {
 public:
  Labels(const Items& items, const std::vector<PlanePoint>& at, Colour colour, Tracks& tracks)
      : items_(items), at_(at), colour_(colour), code_(tracks.code) {
    if (!at.empty()) {
      const Seen s = seen(items.vertex[0]);
      a_minus_b_ = {s.a - s.b, s.a - s.b};
      a_plus_b_ = {s.a + s.b, s.a + s.b};
    }
  }

  void run() {
    for (std::uint32_t item = 0; item < items_.count(); ++item) {
      if (items_.size(item) == 1) {
        measure(seen(items_.first(item)));
        continue;
      }
      read_points(item);
      edge_ = items_.edge.data() + items_.begin[item];
      if (items_.is_cycle(item)) {
        label_cycle();
      } else {
        label_path(+1, kNone);
      }
    }
    points_ = std::vector<Seen>();  // its memory, which the other colour takes
  }

  Range a_minus_b() const { return a_minus_b_; }
  Range a_plus_b() const { return a_plus_b_; }
  std::int64_t height() const { return height_; }

 private:
  /// What stands so many places ahead in an order is asked for, since the order is known and the
  /// places in memory are not in order.
  static constexpr std::uint32_t kAhead = 16;

  void read_points(std::uint32_t item) {
    points_.clear();
    const auto vertices = items_.of(item);
    reserve_long(points_, vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      if (i + kAhead < vertices.size()) __builtin_prefetch(&at_[vertices[i + kAhead]]);
      points_.push_back(seen(vertices[i]));
    }
  }

  Seen seen(Vertex v) const {
    const PlanePoint p = at_[v];
    return colour_ == kGreen ? Seen{p.X, p.Y} : Seen{p.Y, p.X};
  }

  static int direction(Seen from, Seen to) { return to.b > from.b ? 1 : -1; }

  /// The side on which the closing edge runs shorter.
  int shorter_side() const {
    const auto [low, high] = std::minmax_element(points_.begin(), points_.end(),
                                                 [](Seen p, Seen q) { return p.b < q.b; });
    const std::int32_t sum = points_.front().b + points_.back().b;
    return 2 * high->b - sum <= sum - 2 * low->b ? 1 : -1;
  }

  /// The path edge i to draw as Z so that the closing edge is on side `side`; 0: either side.
  /// The first edge starts on the side opposite to the closing edge, and i U's flip that i times; a
  /// Z starts towards its other end.
  std::uint32_t find_z(int side) const {
    for (std::uint32_t i = 0; i + 1 < points_.size(); ++i) {
      const Seen p = points_[i];
      const Seen q = points_[i + 1];
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
    const Range used = label_path(-side, z);
    const auto beyond = static_cast<std::int32_t>(side > 0 ? used.high + 1 : used.low - 1);
    route(points_.back(), points_.front(), beyond, edge_[points_.size() - 1]);
  }

  /// Routes the path edges, the first one starting on side `sign`, edge z as Z; the lines they use,
  /// ends included.
  Range label_path(int sign, std::uint32_t z) {
    Range used{points_[0].b, points_[0].b};
    for (std::uint32_t i = 0; i + 1 < points_.size(); ++i) {
      if (i + kAhead + 1 < points_.size()) __builtin_prefetch(&code_[edge_[i + kAhead]], 1);
      const Seen p = points_[i];
      const Seen q = points_[i + 1];
      const std::int32_t track = i == z     ? p.b + sign * z_distance(q.a - p.a, q.b - p.b)
                                 : sign > 0 ? std::max(p.b, q.b) + 1
                                            : std::min(p.b, q.b) - 1;
      if (i != z) sign = -sign;
      route(p, q, track, edge_[i]);
      used.include(q.b);
      used.include(track);
    }
    return used;
  }

  void route(Seen p, Seen q, std::int32_t track, EdgeId edge) {
    code_[edge] = 2 * track + static_cast<std::int32_t>(colour_);
    measure(p);
    measure({p.a, track});
    measure({q.a, track});
    measure(q);
    const std::int64_t length =
        std::int64_t{std::abs(p.a - q.a)} + std::abs(track - p.b) + std::abs(track - q.b);
    height_ = std::max(height_, length / 2);
  }

  void measure(Seen p) {
    a_minus_b_.include(p.a - p.b);
    a_plus_b_.include(p.a + p.b);
  }

  const Items& items_;
  const std::vector<PlanePoint>& at_;
  const Colour colour_;
  std::vector<std::int32_t>& code_;
  std::vector<Seen> points_;      // of the item at hand
  const EdgeId* edge_ = nullptr;  // its edges
  Range a_minus_b_;
  Range a_plus_b_;
  std::int64_t height_ = 0;
};

}  // namespace

Tracks choose_tracks(const Graph& graph, const Placement& placement) {
  Tracks tracks;
  reserve_long(tracks.code, graph.num_edges());
  tracks.code.resize(graph.num_edges());
  Labels green(placement.green, placement.at, kGreen, tracks);
  Labels red(placement.red, placement.at, kRed, tracks);
  in_two_threads(
      graph.num_vertices(), [&] { green.run(); }, [&] { red.run(); });
  Range x = green.a_minus_b();  // x = X - Y: green sees a - b, red sees b - a
  x.include(-red.a_minus_b().low);
  x.include(-red.a_minus_b().high);
  Range y = green.a_plus_b();
  y.include(red.a_plus_b().low);
  y.include(red.a_plus_b().high);
  tracks.extents = {x.high - x.low, y.high - y.low, green.height() + red.height()};
  return tracks;
}

}  // namespace ar3d::diamond
