#include "ar3d/model/drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "ar3d/model/error.h"
#include "ar3d/model/hash_stream.h"

namespace ar3d {

Coordinates::Coordinates(std::size_t count, std::int64_t bound) : bound_(bound) {
  if (bound < 0 || bound > kMaxCoordinate) {
    throw InputError(
        fmt::format("coordinates up to {} do not fit, the limit is {}", bound, kMaxCoordinate));
  }
  if (bound <= std::numeric_limits<std::int32_t>::max()) {
    points_.emplace<Narrow>(count);
  } else {
    points_.emplace<Wide>(count);
  }
}

std::size_t Coordinates::size() const {
  return std::visit([](const auto& points) { return points.size(); }, points_);
}

void Coordinates::set(std::size_t i, Point p) {
  const auto fits = [&](std::int64_t c) { return c >= -bound_ && c <= bound_; };
  expect(fits(p.x) && fits(p.y) && fits(p.z), "a coordinate passes its proved bound");
  if (auto* narrow = std::get_if<Narrow>(&points_)) {
    (*narrow)[i] = {static_cast<std::int32_t>(p.x), static_cast<std::int32_t>(p.y),
                    static_cast<std::int32_t>(p.z)};
  } else {
    std::get<Wide>(points_)[i] = p;
  }
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
  for (std::size_t e = 0; e < edges_->size(); ++e) {
    const auto [u, v] = (*edges_)[e];
    if (u >= vertices_.size() || v >= vertices_.size()) {
      throw InputError(
          fmt::format("edge {} ({}, {}) of the drawing: vertex out of range, it has {} vertices", e,
                      u, v, vertices_.size()));
    }
  }
}

void Drawing::polyline(EdgeId e, std::vector<Point>& out) const {
  const Edge ends = edge(e);
  const Point at_u = vertex(ends.u);
  const Point at_v = vertex(ends.v);
  out.clear();
  out.push_back(at_u);
  bends_->append_bends(e, ends, at_u, at_v, out);
  out.push_back(at_v);
}

namespace {
void include(Box& box, bool& empty, Point p) {
  if (empty) box = {p, p};
  empty = false;
  box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
  box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
}
}  // namespace

Box bounding_box(const Drawing& drawing) {
  Box box;
  bool empty = true;
  for (std::size_t v = 0; v < drawing.num_vertices(); ++v) {
    include(box, empty, drawing.vertex(static_cast<Vertex>(v)));
  }
  std::vector<Point> points;
  for (EdgeId e = 0; e < drawing.num_edges(); ++e) {
    drawing.polyline(e, points);
    for (const Point p : points) include(box, empty, p);
  }
  return box;
}

std::string drawing_hash(const Drawing& drawing) {
  HashStream hash;
  const auto put = [&hash](Point p) {
    hash.put(p.x);
    hash.put(p.y);
    hash.put(p.z);
  };
  for (const auto& row : drawing.lattice().gram) {
    for (const std::int32_t entry : row) hash.put(std::int64_t{entry});
  }
  hash.put(std::int64_t{drawing.lattice().gram_denominator});
  hash.put(std::uint64_t{drawing.num_vertices()});
  for (std::size_t v = 0; v < drawing.num_vertices(); ++v) {
    put(drawing.vertex(static_cast<Vertex>(v)));
  }
  std::vector<Point> points;
  for (EdgeId e = 0; e < drawing.num_edges(); ++e) {
    hash.put(drawing.edge(e).u);
    hash.put(drawing.edge(e).v);
    drawing.polyline(e, points);
    hash.put(std::uint64_t{points.size()});
    for (const Point p : points) put(p);
  }
  return hash.digest();
}

Drawing with_stored_bends(const Drawing& drawing) {
  Coordinates vertices(drawing.num_vertices(), kMaxCoordinate);
  for (std::size_t v = 0; v < drawing.num_vertices(); ++v) {
    vertices.set(v, drawing.vertex(static_cast<Vertex>(v)));
  }
  auto edges = std::make_shared<std::vector<Edge>>();
  auto bends = std::make_shared<StoredBends>();
  std::vector<Point> points;
  for (EdgeId e = 0; e < drawing.num_edges(); ++e) {
    edges->push_back(drawing.edge(e));
    drawing.polyline(e, points);
    bends->add_edge({points.begin() + 1, points.end() - 1});
  }
  Drawing result(drawing.algorithm(), drawing.lattice(), std::move(vertices), std::move(edges),
                 std::move(bends));
  result.counters = drawing.counters;
  result.instance_bound = drawing.instance_bound;
  return result;
}

}  // namespace ar3d
