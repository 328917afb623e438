// Drawings and their coordinates in the narrowest integer that a bound allows. The hash runs over
// points in the order of edges, so it does not depend on how a drawing is stored.
#include "ar3d/model/drawing.h"

#include <fmt/format.h>

#include <cstdlib>
#include <iterator>

#include "ar3d/base/error.h"
#include "ar3d/base/nearest_name.h"
#include "ar3d/base/printable.h"
#include "ar3d/model/real_points.h"

namespace ar3d {

namespace {

/// `count` points at the origin, in pages of 2 MiB if they are many.
template <class Points>
Points origins(std::size_t count) {
  Points points;
  reserve_long(points, count);
  points.resize(count);
  return points;
}

/// Every bend, stored.
std::shared_ptr<const BendSource> stored_bends(const Drawing& drawing) {
  auto bends = std::make_shared<StoredBends>();
  bends->reserve(drawing.num_edges(), count_bends(drawing));
  std::vector<Point> between;
  for_each_polyline(drawing, [&](EdgeId, const std::vector<Point>& points) {
    between.assign(points.begin() + 1, points.end() - 1);
    bends->add_edge(between);
  });
  return bends;
}

/// In absolute value; 0 of no points. @throws InputError if it is beyond kMaxCoordinate.
std::int64_t largest_coordinate(std::span<const Point> points) {
  std::int64_t largest = 0;
  for (const auto [x, y, z] : points) {
    for (const std::int64_t c : {x, y, z}) {
      if (c < -kMaxCoordinate || c > kMaxCoordinate) {
        throw InputError(
            fmt::format("the coordinate {} does not fit, the limit is {}", c, kMaxCoordinate));
      }
      largest = std::max(largest, std::abs(c));
    }
  }
  return largest;
}

}  // namespace

Coordinates::Coordinates(std::size_t count, std::int64_t bound) : bound_(bound) {
  if (bound < 0 || bound > kMaxCoordinate) {
    throw InputError(
        fmt::format("coordinates up to {} do not fit, the limit is {}", bound, kMaxCoordinate));
  }
  if (bound <= std::numeric_limits<std::int16_t>::max()) {
    points_ = origins<Narrowest>(count);
  } else if (bound <= std::numeric_limits<std::int32_t>::max()) {
    points_ = origins<Narrow>(count);
  } else {
    points_ = origins<Wide>(count);
  }
}

std::size_t Coordinates::size() const {
  return std::visit([](const auto& points) { return points.size(); }, points_);
}

std::size_t Coordinates::bytes_per_point() const {
  return std::visit([](const auto& points) { return sizeof(points[0]); }, points_);
}

void Coordinates::check_bound(std::int64_t low, std::int64_t high) const {
  expect(low >= -bound_ && high <= bound_, "a coordinate passes its proved bound");
}

void Coordinates::set(std::size_t i, Point p) {
  check_bound(std::min({p.x, p.y, p.z}), std::max({p.x, p.y, p.z}));
  std::visit([&](auto& points) { put(points[i], p); }, points_);
}

void StoredBends::reserve(std::size_t edges, std::size_t bends) {
  offsets_.reserve(edges + 1);
  points_.reserve(bends);
}

void StoredBends::add_edge(const std::vector<Point>& bends) {
  points_.insert(points_.end(), bends.begin(), bends.end());
  offsets_.push_back(points_.size());
}

void StoredBends::append_bends(EdgeId e, Edge, Point, Point, std::vector<Point>& out) const {
  out.insert(out.end(), points_.begin() + static_cast<std::ptrdiff_t>(offsets_[e]),
             points_.begin() + static_cast<std::ptrdiff_t>(offsets_[e + 1]));
}

Drawing::Drawing(std::string algorithm, Lattice lattice, Coordinates vertices,
                 std::shared_ptr<const std::vector<Edge>> edges,
                 std::shared_ptr<const BendSource> bends)
    : algorithm_(std::move(algorithm)),
      lattice_(lattice),
      vertices_(std::move(vertices)),
      edges_(std::move(edges)),
      bends_(std::move(bends)) {
  expect(edges_ != nullptr, "a drawing has an edge list");
  expect(bends_ != nullptr || edges_->empty(), "a drawing with edges has a bend source");
  Vertex largest = 0;
  for (const auto [u, v] : *edges_) largest = std::max({largest, u, v});
  const std::size_t n = vertices_.size();
  if (edges_->empty() || largest < n) return;
  const auto bad = std::find_if(edges_->begin(), edges_->end(),
                                [n](Edge edge) { return edge.u >= n || edge.v >= n; });
  throw InputError(
      fmt::format("edge {} ({}, {}) of the drawing: vertex out of range, it has {} vertices",
                  bad - edges_->begin(), bad->u, bad->v, n));
}

void Drawing::polyline(EdgeId e, std::vector<Point>& out) const {
  const Edge ends = edge(e);
  polyline_between(e, vertex(ends.u), vertex(ends.v), out);
}

void Drawing::polyline_between(EdgeId e, Point at_u, Point at_v, std::vector<Point>& out) const {
  out.clear();
  out.push_back(at_u);
  bends_->append_bends(e, edge(e), at_u, at_v, out);
  out.push_back(at_v);
}

Drawing drawing_from_points(std::string name, const Graph& graph, std::span<const Point> vertices,
                            const std::vector<std::vector<Point>>& bends) {
  const auto require = [](std::size_t given, std::uint64_t wanted, const char* what) {
    if (given == wanted) return;
    throw InputError(fmt::format("{} {} are given, the graph has {}", given, what, wanted));
  };
  require(vertices.size(), graph.num_vertices(), "points for vertices");
  if (!bends.empty()) require(bends.size(), graph.num_edges(), "lists of bends for edges");
  Coordinates points(vertices.size(), largest_coordinate(vertices));
  points.fill(0, vertices.size(), [&](std::size_t v) { return vertices[v]; });
  auto stored = std::make_shared<StoredBends>();
  for (EdgeId e = 0; e < graph.num_edges(); ++e) {
    stored->add_edge(bends.empty() ? std::vector<Point>() : bends[e]);
    if (!bends.empty()) largest_coordinate(bends[e]);
  }
  return {std::move(name), kCubeLattice, std::move(points), graph.shared_edges(),
          std::move(stored)};
}

Box bounding_box(const Drawing& drawing) {
  GrowingBox box;
  for (std::size_t v = 0; v < drawing.num_vertices(); ++v) {
    box.add(drawing.vertex(static_cast<Vertex>(v)));
  }
  for_each_polyline(drawing, [&](EdgeId, const std::vector<Point>& points) {
    for (std::size_t i = 1; i + 1 < points.size(); ++i) box.add(points[i]);
  });
  return box.box();
}

DrawingHash::DrawingHash(const Drawing& drawing) {
  for (const auto& row : drawing.lattice().gram) {
    for (const std::int32_t entry : row) hash_.put(std::int64_t{entry});
  }
  hash_.put(std::int64_t{drawing.lattice().gram_denominator});
  hash_.put(std::uint64_t{drawing.num_vertices()});
  for (std::size_t v = 0; v < drawing.num_vertices(); ++v) {
    put(drawing.vertex(static_cast<Vertex>(v)));
  }
  if (drawing.real) put(*drawing.real);
}

void DrawingHash::put(const RealPoints& points) {
  hash_.put(std::int64_t{points.unit_exponent});
  const auto put_number = [&](const BigInteger& number) {
    std::vector<std::uint64_t> limbs;
    export_bits(abs(number), std::back_inserter(limbs), 64);
    hash_.put(std::int64_t{number < 0});
    hash_.put(std::uint64_t{limbs.size()});
    for (const std::uint64_t limb : limbs) hash_.put(limb);
  };
  for (const auto* list : {&points.vertices, &points.bends}) {
    for (const BigPoint& p : *list) {
      put_number(p.x);
      put_number(p.y);
      put_number(p.z);
    }
  }
}

void DrawingHash::put(Point p) { hash_.put(std::array{p.x, p.y, p.z}); }

void DrawingHash::add(Edge ends, std::span<const Point> points) {
  hash_.put(ends.u);
  hash_.put(ends.v);
  hash_.put(std::uint64_t{points.size()});
  static_assert(sizeof(Point) == 3 * sizeof(std::int64_t));
  hash_.put(std::as_bytes(points));
}

std::string drawing_hash(const Drawing& drawing) {
  DrawingHash hash(drawing);
  for_each_polyline(drawing, [&](EdgeId e, const std::vector<Point>& points) {
    hash.add(drawing.edge(e), points);
  });
  return hash.digest();
}

const char* to_string(Level level) {
  static constexpr std::array<const char*, 3> kNames = {"extents", "positions", "full"};
  return kNames.at(static_cast<std::size_t>(level));
}

Level parse_level(std::string_view text) {
  for (const Level level : {Level::extents, Level::positions, Level::full}) {
    if (text == to_string(level)) return level;
  }
  throw InputError(fmt::format("'{}' is no level (known: extents, positions, full){}",
                               printable(text),
                               did_you_mean(text, {"extents", "positions", "full"})));
}

Drawing at_level(Drawing drawing, Level level) {
  if (level == Level::extents) return drawing;
  Coordinates vertices(drawing.num_vertices(), kMaxCoordinate);
  for (std::size_t v = 0; v < drawing.num_vertices(); ++v) {
    vertices.set(v, drawing.vertex(static_cast<Vertex>(v)));
  }
  Drawing result(drawing.algorithm(), drawing.lattice(), std::move(vertices),
                 drawing.shared_edges(),
                 level == Level::full ? stored_bends(drawing) : drawing.shared_bends());
  result.counters = drawing.counters;
  result.instance_bound = drawing.instance_bound;
  result.real = drawing.real;
  result.names = drawing.names;
  return result;
}

}  // namespace ar3d
