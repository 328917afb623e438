#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "ar3d/model/graph.h"
#include "ar3d/model/lattice.h"

namespace ar3d {

/// Vertex positions in the narrowest integer that the caller's bound proves wide enough: 12 or 24
/// bytes a point.
class Coordinates {
 public:
  Coordinates() = default;
  /// Room for `count` points whose coordinates are at most `bound` in absolute value; all at the
  /// origin.
  /// @throws InputError if bound > kMaxCoordinate.
  Coordinates(std::size_t count, std::int64_t bound);

  std::size_t size() const;
  Point operator[](std::size_t i) const {
    if (const auto* narrow = std::get_if<Narrow>(&points_)) {
      const auto& p = (*narrow)[i];
      return {p[0], p[1], p[2]};
    }
    return std::get<Wide>(points_)[i];
  }
  /// @throws InternalError if a coordinate passes the bound given at construction.
  void set(std::size_t i, Point p);

 private:
  using Narrow = std::vector<std::array<std::int32_t, 3>>;
  using Wide = std::vector<Point>;
  std::variant<Narrow, Wide> points_;
  std::int64_t bound_ = 0;
};

/// The bends of a drawing's edges, computed when read from a few numbers an edge.
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
  void add_edge(const std::vector<Point>& bends);  ///< the next edge, in order of edge numbers
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

/// What an algorithm tells about its own run, by name (for example diamond's H). Columns of a
/// study.
struct Counter {
  std::string name;
  std::int64_t value = 0;
  friend bool operator==(const Counter&, const Counter&) = default;
};

/// A polyline drawing on integer points with a rational Gram matrix. Immutable but for the two
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

  /// Replaces `out` by the points of edge e from end u to end v, both ends included.
  void polyline(EdgeId e, std::vector<Point>& out) const;

  /// The run's own numbers, and the box that the construction's proof promises for this very
  /// instance.
  std::vector<Counter> counters;
  std::optional<std::array<std::int64_t, 3>> instance_bound;  // extents

 private:
  std::string algorithm_;
  Lattice lattice_;
  Coordinates vertices_;
  std::shared_ptr<const std::vector<Edge>> edges_;
  std::shared_ptr<const BendSource> bends_;
};

/// Bounding box of all vertices and bends; O(n + m) time, O(1) memory.
Box bounding_box(const Drawing& drawing);

/// 128-bit hash of everything that a drawing draws: metric, positions, edges, polylines; not of its
/// annotations. 32 hexadecimal digits, equal on all platforms. O(n + m) time, O(1) memory.
std::string drawing_hash(const Drawing& drawing);

/// The same drawing with every bend stored (tests, conversions); O(m) memory.
Drawing with_stored_bends(const Drawing& drawing);

}  // namespace ar3d
