// Binary STL for printing. Tubes are carried along their edge, ring by ring, and cut at mitres, so
// that they close.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "ar3d/formats/drawings/drawing_exports.h"

namespace ar3d {
namespace {

constexpr std::size_t kSides = 12;  // of a tube
constexpr double kBallToTube = 2.2;
constexpr std::uint64_t kMaxTriangles = 20'000'000;  // a file of 1 GB
constexpr std::int64_t kMostExtent = 1 << 16;  // 32 bits round it by less than 1/128 of a unit

using Ring = std::array<Real3, kSides>;
using Corner = std::array<float, 3>;

Corner rounded(Real3 p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

Real3 unit(Real3 a) { return (1 / length(a)) * a; }

/// A triangle of binary STL.
void append_triangle(OutputFile& output, Real3 a, Real3 b, Real3 c) {
  const Real3 across = cross(b - a, c - a);
  const double size = length(across);
  const Corner normal = rounded(size > 0 ? (1 / size) * across : Real3{});
  for (const Corner& corner : {normal, rounded(a), rounded(b), rounded(c)}) {
    output.pending().append(reinterpret_cast<const char*>(corner.data()), sizeof corner);
  }
  output.pending().append(2, '\0');
  output.flush_if_full();
}

/// The tube's first ring: about p, square to the direction.
Ring first_ring(Real3 p, Real3 direction, double radius) {
  const Real3 aside = std::abs(direction.z) < 0.9 ? Real3{0, 0, 1} : Real3{1, 0, 0};
  const Real3 x = unit(cross(direction, aside));
  const Real3 y = cross(direction, x);
  Ring ring;
  for (std::size_t k = 0; k < kSides; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / kSides;
    ring[k] = p + radius * std::cos(angle) * x + radius * std::sin(angle) * y;
  }
  return ring;
}

/// The ring carried along `direction` to the plane through p with that normal: mitred joints fit.
Ring carried(const Ring& ring, Real3 direction, Real3 p, Real3 normal) {
  Ring next;
  for (std::size_t k = 0; k < kSides; ++k) {
    const double way = dot(p - ring[k], normal) / dot(direction, normal);
    if (!(way > 0)) {
      throw InputError(
          "a segment is too short for its bends as a tube; stl takes a smaller --tube");
    }
    next[k] = ring[k] + way * direction;
  }
  return next;
}

void add_side(OutputFile& out, const Ring& from, const Ring& to) {
  for (std::size_t k = 0; k < kSides; ++k) {
    const std::size_t next = (k + 1) % kSides;
    append_triangle(out, from[k], from[next], to[next]);
    append_triangle(out, from[k], to[next], to[k]);
  }
}

void add_tube(OutputFile& out, std::vector<Real3> points, double radius) {
  std::vector<Real3> directions;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Real3 d = points[i] - points[i - 1];
    if (length(d) == 0) throw InputError("an edge has a segment of length 0, stl holds none");
    directions.push_back(unit(d));
  }
  // The tube ends inside the balls, where no other tube's corners are.
  const auto inside = [&](std::size_t segment) {
    return std::min(0.9 * radius, length(points[segment + 1] - points[segment]) / 4);
  };
  points.front() = points.front() + inside(0) * directions.front();
  points.back() = points.back() - inside(directions.size() - 1) * directions.back();
  Ring ring = first_ring(points.front(), directions.front(), radius);
  for (std::size_t k = 0; k < kSides; ++k) {
    append_triangle(out, points.front(), ring[(k + 1) % kSides], ring[k]);
  }
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const bool last = i + 1 == directions.size();
    const Real3 normal = last ? directions[i] : directions[i] + directions[i + 1];
    if (length(normal) < 1e-6) throw InputError("an edge turns back, stl holds no such tube");
    const Ring next = carried(ring, directions[i], points[i + 1], unit(normal));
    add_side(out, ring, next);
    ring = next;
  }
  for (std::size_t k = 0; k < kSides; ++k) {
    append_triangle(out, points.back(), ring[k], ring[(k + 1) % kSides]);
  }
}

/// The unit ball as an octahedron divided twice: 128 triangles.
std::vector<std::array<Real3, 3>> unit_ball() {
  std::vector<std::array<Real3, 3>> faces;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      for (const double z : {-1.0, 1.0}) {
        std::array<Real3, 3> face = {Real3{x, 0, 0}, Real3{0, y, 0}, Real3{0, 0, z}};
        if (x * y * z < 0) std::swap(face[1], face[2]);
        faces.push_back(face);
      }
    }
  }
  for (int round = 0; round < 2; ++round) {
    std::vector<std::array<Real3, 3>> finer;
    for (const auto& [a, b, c] : faces) {
      const Real3 ab = unit(a + b), bc = unit(b + c), ca = unit(c + a);
      for (const auto& face : {std::array{a, ab, ca}, std::array{ab, b, bc}, std::array{ca, bc, c},
                               std::array{ab, bc, ca}}) {
        finer.push_back(face);
      }
    }
    faces = std::move(finer);
  }
  return faces;
}

std::uint64_t count_triangles(const Drawing& drawing, std::size_t ball) {
  std::uint64_t triangles = drawing.num_vertices() * ball;
  for_each_polyline(drawing, [&](EdgeId, const std::vector<Point>& points) {
    triangles += 2 * kSides + 2 * kSides * (points.size() - 1);
  });
  if (triangles > kMaxTriangles) {
    throw InputError(fmt::format("{} triangles, stl holds at most {}", triangles, kMaxTriangles));
  }
  return triangles;
}

}  // namespace

void write_stl(OutputFile& output, const Drawing& drawing, double radius) {
  refuse_larger_extents(drawing, kMostExtent, "stl");
  const auto ball = unit_ball();
  const auto count = static_cast<std::uint32_t>(count_triangles(drawing, ball.size()));
  std::string head = "ar3d: edges as closed tubes, vertices as closed balls";
  head.resize(80, ' ');
  output.append(head);
  output.append({reinterpret_cast<const char*>(&count), sizeof count});
  const Embedding embed(drawing.lattice());
  const Point low = bounding_box(drawing).low;
  for (std::size_t v = 0; v < drawing.num_vertices(); ++v) {
    const Real3 p = embed(drawing.vertex(static_cast<Vertex>(v)) - low);
    for (const auto& [a, b, c] : ball) {
      const double r = kBallToTube * radius;
      append_triangle(output, p + r * a, p + r * b, p + r * c);
    }
  }
  std::vector<Real3> line;
  for_each_polyline(drawing, [&](EdgeId, const std::vector<Point>& points) {
    line.clear();
    for (const Point p : points) line.push_back(embed(p - low));
    add_tube(output, line, radius);
  });
}

}  // namespace ar3d
