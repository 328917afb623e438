#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "ar3d/base/hash_stream.h"
#include "ar3d/model/graph.h"
#include "ar3d/model/lattice.h"
#include "ar3d/model/settings.h"

namespace ar3d {

struct RealPoints;  // model/real_points.h

/// Vertex positions in the narrowest integer that the caller's bound proves wide enough: 16, 32 or
/// 64 bits, so 6, 12 or 24 bytes per point.
class Coordinates {
 public:
  Coordinates() = default;
  /// Room for `count` points whose coordinates are at most `bound` in absolute value; all at the
  /// origin.
  /// @throws InputError if bound > kMaxCoordinate.
  Coordinates(std::size_t count, std::int64_t bound);

  std::size_t size() const;
  std::size_t bytes_per_point() const;
  Point operator[](std::size_t i) const {
    if (const auto* narrow = std::get_if<Narrow>(&points_)) {
      const auto& p = (*narrow)[i];
      return {p[0], p[1], p[2]};
    }
    if (const auto* wide = std::get_if<Wide>(&points_)) return (*wide)[i];
    const auto& p = std::get<Narrowest>(points_)[i];
    return {p[0], p[1], p[2]};
  }
  /// Asks for point i to be read into the cache.
  void prefetch(std::size_t i) const {
    std::visit([i](const auto& points) { __builtin_prefetch(points.data() + i); }, points_);
  }
  /// @throws InternalError if a coordinate passes the bound given at construction.
  void set(std::size_t i, Point p);
  /// set(i, point_of(i)) for i = begin, ..., end - 1, with one check for all; threads may fill
  /// ranges of their own.
  template <class PointOf>
  void fill(std::size_t begin, std::size_t end, PointOf point_of) {
    std::int64_t low = 0;
    std::int64_t high = 0;
    std::visit(
        [&](auto& points) {
          for (std::size_t i = begin; i < end; ++i) {
            const Point p = point_of(i);
            low = std::min({low, p.x, p.y, p.z});
            high = std::max({high, p.x, p.y, p.z});
            put(points[i], p);
          }
        },
        points_);
    check_bound(low, high);
  }

 private:
  using Narrowest = std::vector<std::array<std::int16_t, 3>>;
  using Narrow = std::vector<std::array<std::int32_t, 3>>;
  using Wide = std::vector<Point>;
  template <class T>
  static void put(std::array<T, 3>& place, Point p) {
    place = {static_cast<T>(p.x), static_cast<T>(p.y), static_cast<T>(p.z)};
  }
  static void put(Point& place, Point p) { place = p; }
  /// @throws InternalError if [low, high] is not within the bound.
  void check_bound(std::int64_t low, std::int64_t high) const;

  std::variant<Narrow, Wide, Narrowest> points_;
  std::int64_t bound_ = 0;
};

/// The bends of a drawing's edges, computed when read from a few numbers per edge.
class BendSource {
 public:
  virtual ~BendSource() = default;
  /// Appends the bends of edge e in order from end u (at point at_u) to end v (at point at_v).
  virtual void append_bends(EdgeId e, Edge ends, Point at_u, Point at_v,
                            std::vector<Point>& out) const = 0;
};

/// Bends stored point by point: what a file holds, and what tests break.
class StoredBends final : public BendSource {
 public:
  void reserve(std::size_t edges, std::size_t bends);  ///< room for so many, of all edges
  void add_edge(const std::vector<Point>& bends);      ///< the next edge, in order of edge numbers
  void append_bends(EdgeId e, Edge, Point, Point, std::vector<Point>& out) const override;

 private:
  std::vector<std::size_t> offsets_{0};
  std::vector<Point> points_;
};

/// A closed axis-parallel box. The box of no points is the single origin.
struct Box {
  Point low;
  Point high;
  /// Extents high - low per axis (zero for a single point): what every size bound of the project
  /// speaks of.
  std::array<std::int64_t, 3> extents() const {
    return {high.x - low.x, high.y - low.y, high.z - low.z};
  }
  friend bool operator==(const Box&, const Box&) = default;
};

/// Holds what an algorithm counts in its own run, by name (for example diamond's H): written, and
/// stored in a study, as settings are.
using Counter = Setting;

/// A polyline drawing on integer points with a rational Gram matrix. Immutable except for its
/// annotations.
class Drawing {
 public:
  /// @param edges  the drawn edges, ends in the order in which polylines run; ids below
  /// vertices.size().
  /// @param bends  gives the bends of every edge; may be null if there are no edges.
  /// @throws InputError on ids out of range.
  Drawing(std::string algorithm, Lattice lattice, Coordinates vertices,
          std::shared_ptr<const std::vector<Edge>> edges, std::shared_ptr<const BendSource> bends);

  const std::string& algorithm() const { return algorithm_; }
  const Lattice& lattice() const { return lattice_; }
  std::size_t num_vertices() const { return vertices_.size(); }
  EdgeId num_edges() const { return static_cast<EdgeId>(edges_->size()); }
  Point vertex(Vertex v) const { return vertices_[v]; }
  Edge edge(EdgeId e) const { return (*edges_)[e]; }
  const std::shared_ptr<const std::vector<Edge>>& shared_edges() const { return edges_; }
  const std::shared_ptr<const BendSource>& shared_bends() const { return bends_; }

  /// Replaces `out` by the points of edge e from end u to end v, both ends included.
  void polyline(EdgeId e, std::vector<Point>& out) const;

  template <class Visit>
  friend void for_each_polyline_block(const Drawing& drawing, EdgeId begin, EdgeId end,
                                      Visit&& visit);

  /// The run's own numbers, and the box that the construction's proof promises for this very
  /// instance.
  std::vector<Counter> counters;
  std::optional<std::array<std::int64_t, 3>> instance_bound;  // extents
  /// The exact points of a drawing made in a real type (see real_drawing()); else null.
  std::shared_ptr<const RealPoints> real;
  /// Names of the vertices, from the graph's file; null if it has none.
  std::shared_ptr<const std::vector<std::string>> names;

 private:
  void polyline_between(EdgeId e, Point at_u, Point at_v, std::vector<Point>& out) const;

  std::string algorithm_;
  Lattice lattice_;
  Coordinates vertices_;
  std::shared_ptr<const std::vector<Edge>> edges_;
  std::shared_ptr<const BendSource> bends_;
};

/// A drawing on the cube grid from its points, such as one of one's own that is to be certified:
/// vertex v at vertices[v], edge e from its smaller end to its larger one over the points bends[e],
/// or straight if `bends` is empty. O(n + m + bends) time.
/// @param name  of what drew it.
/// @throws InputError if there are more or fewer points than vertices or lists than edges, or a
/// coordinate is beyond kMaxCoordinate.
Drawing drawing_from_points(std::string name, const Graph& graph, std::span<const Point> vertices,
                            const std::vector<std::vector<Point>>& bends = {});

/// Calls visit(first, polylines) for blocks of the edges begin, ..., end - 1 in this order, their
/// polylines a span of const std::vector<Point>, valid during the call. Vertices have no order in
/// memory, so reading the ends of an edge waits for two cache misses: those of the next block of
/// edges are asked for before the polylines of this one are made. O(edges + bends) time, O(1)
/// memory.
template <class Visit>
void for_each_polyline_block(const Drawing& drawing, EdgeId begin, EdgeId end, Visit&& visit) {
  static constexpr EdgeId kBlock = 64;               // 8, 32 and 128 take the same time
  std::array<std::pair<Point, Point>, kBlock> ends;  // of its edges
  std::array<std::vector<Point>, kBlock> polylines;
  const auto count_from = [end](EdgeId first) { return std::min<EdgeId>(kBlock, end - first); };
  const auto prefetch = [&](EdgeId first) {
    for (EdgeId i = 0; i < count_from(first); ++i) {
      const Edge edge = drawing.edge(first + i);
      drawing.vertices_.prefetch(edge.u);
      drawing.vertices_.prefetch(edge.v);
    }
  };
  if (begin < end) prefetch(begin);
  for (EdgeId first = begin, count = 0; first < end; first += count) {
    count = count_from(first);
    for (EdgeId i = 0; i < count; ++i) {
      const Edge edge = drawing.edge(first + i);
      ends[i] = {drawing.vertex(edge.u), drawing.vertex(edge.v)};
    }
    prefetch(first + count);
    for (EdgeId i = 0; i < count; ++i) {
      drawing.polyline_between(first + i, ends[i].first, ends[i].second, polylines[i]);
    }
    visit(first, std::span<const std::vector<Point>>(polylines).first(count));
  }
}

/// Calls visit(e, points) for the polylines of the edges begin, ..., end - 1 in this order.
template <class Visit>
void for_each_polyline(const Drawing& drawing, EdgeId begin, EdgeId end, Visit&& visit) {
  for_each_polyline_block(drawing, begin, end,
                          [&](EdgeId e, std::span<const std::vector<Point>> polylines) {
                            for (const auto& points : polylines) visit(e++, points);
                          });
}

/// The polylines of all edges in order of edge numbers.
template <class Visit>
void for_each_polyline(const Drawing& drawing, Visit&& visit) {
  for_each_polyline(drawing, 0, drawing.num_edges(), visit);
}

/// The number of all bends; O(n + bends) time.
inline std::uint64_t count_bends(const Drawing& drawing) {
  std::uint64_t bends = 0;
  for_each_polyline(drawing,
                    [&](EdgeId, const std::vector<Point>& points) { bends += points.size() - 2; });
  return bends;
}

/// A box that grows: of the points added so far.
class GrowingBox {
 public:
  void add(Point p) {
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z)};
    high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y), std::max(high_.z, p.z)};
  }
  Point low() const { return low_; }
  Point high() const { return high_; }
  /// The origin if nothing was added.
  Box box() const { return low_.x > high_.x ? Box{} : Box{low_, high_}; }

 private:
  static constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
  Point low_{kMost, kMost, kMost};
  Point high_{-kMost - 1, -kMost - 1, -kMost - 1};
};

/// Bounding box of all vertices and bends; O(n + m) time, O(1) memory.
Box bounding_box(const Drawing& drawing);

/// 128-bit hash of everything that a drawing draws: metric, positions, edges, polylines; not of its
/// annotations. 32 hexadecimal digits, equal on all platforms. O(n + m) time, O(1) memory.
std::string drawing_hash(const Drawing& drawing);

/// drawing_hash() for code that passes over the polylines anyway.
class DrawingHash {
 public:
  /// Takes the metric and the vertices of the drawing.
  explicit DrawingHash(const Drawing& drawing);
  /// Takes the next edge and its polyline: every edge once, in order of edge numbers.
  void add(Edge ends, std::span<const Point> points);
  /// After the last edge.
  std::string digest() { return hash_.digest(); }

 private:
  void put(Point p);
  void put(const RealPoints& points);
  HashStream hash_;
};

/// Says how much of a drawing is stored while it is measured and judged. All that is computed
/// of it is the same at every level, bit for bit; time and memory differ.
enum class Level : std::uint8_t {
  extents,    ///< what the algorithm keeps: a polyline is computed when it is read, and dropped
  positions,  ///< also an array of all positions in 64-bit integers: 24 bytes per vertex
  full        ///< also an array of all bends: 24 bytes per bend and 8 per edge
};
/// "extents", "positions", "full".
const char* to_string(Level level);
/// @throws InputError naming the text and the levels if it is none.
Level parse_level(std::string_view text);

/// The same drawing with as much of it stored as the level says. O(n + bends) time.
Drawing at_level(Drawing drawing, Level level);

}  // namespace ar3d
