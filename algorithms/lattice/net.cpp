// Step L.1: the two space-fillers of Figure 1 as tables: which edge vectors a vertex has follows
// from its coordinates modulo 4. The diamond lattice as in Theorem 1; the Laves graph (Sunada 2008)
// has eight vertices modulo 4, joined where they are sqrt(2) apart. Each look-up is O(1).
#include <algorithm>
#include <cstdlib>

#include "ar3d/algorithms/lattice/embedding.h"

namespace ar3d::lattice {
namespace {

/// The index of a point's residues modulo 4.
std::size_t index_of(Point p) {
  return static_cast<std::size_t>(16 * (p.x & 3) + 4 * (p.y & 3) + (p.z & 3));
}

std::vector<std::vector<Vector>> diamond_steps() {
  std::vector<std::vector<Vector>> steps(64);
  const std::vector<Vector> up = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    for (const Vector step : up) steps[i].push_back(i / 16 % 2 == 0 ? step : -step);
  }
  return steps;
}

std::vector<std::vector<Vector>> laves_steps() {
  const std::vector<Point> vertices = {{0, 0, 0}, {1, 2, 3}, {2, 3, 1}, {3, 1, 2},
                                       {2, 2, 2}, {3, 0, 1}, {0, 1, 3}, {1, 3, 0}};
  std::vector<std::vector<Vector>> steps(64);
  for (const Point p : vertices) {
    for (std::int64_t i = 0; i < 27; ++i) {
      const Vector step{i / 9 - 1, i / 3 % 3 - 1, i % 3 - 1};
      if (std::abs(step.x) + std::abs(step.y) + std::abs(step.z) != 2) continue;
      const bool is_vertex = std::any_of(vertices.begin(), vertices.end(), [&](Point q) {
        return index_of(q) == index_of(p + step);
      });
      if (is_vertex) steps[index_of(p)].push_back(step);
    }
  }
  return steps;
}

}  // namespace

SpaceNet::SpaceNet(const char* name, bool is_diamond)
    : name_(name), is_diamond_(is_diamond), steps_(is_diamond ? diamond_steps() : laves_steps()) {}

const SpaceNet& SpaceNet::diamond() {
  static const SpaceNet net("diamond lattice", true);
  return net;
}

const SpaceNet& SpaceNet::laves() {
  static const SpaceNet net("Laves graph", false);
  return net;
}

std::span<const Vector> SpaceNet::steps(Point vertex) const { return steps_[index_of(vertex)]; }

bool SpaceNet::are_adjacent(Point p, Point q) const {
  const std::span<const Vector> all = steps(p);
  return std::find(all.begin(), all.end(), q - p) != all.end();
}

bool SpaceNet::may_reach(Point p, Point q, std::int64_t edges) const {
  const Vector d = q - p;
  const std::int64_t x = std::abs(d.x), y = std::abs(d.y), z = std::abs(d.z);
  return std::max({x, y, z}) <= edges && (is_diamond_ || x + y + z <= 2 * edges);
}

bool SpaceNet::is_translation(Vector t) const {
  if (is_diamond_) return ((t.x | t.y | t.z) & 1) == 0 && (t.x + t.y + t.z) % 4 == 0;
  return (t.x & 3) == (t.y & 3) && (t.y & 3) == (t.z & 3) && (t.x & 1) == 0;
}

}  // namespace ar3d::lattice
