#pragma once

#include <algorithm>
#include <vector>

#include "ar3d/base/random.h"
#include "verify/counted_pairs.h"
#include "verify/draft.h"

namespace ar3d::testing {

/// Sets of directions to draw with: diamond, grid, the axes, and a skew one.
inline const std::vector<std::vector<Vector>>& direction_sets() {
  static const std::vector<std::vector<Vector>> sets = {
      {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
      {{1, 1, 0}, {1, -1, 0}, {1, 0, 1}, {1, 0, -1}, {0, 1, 1}, {0, 1, -1}},
      {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
      {{1, 0, 0}, {1, 2, 0}, {0, 1, 1}, {3, -1, 2}, {0, 0, 1}}};
  return sets;
}

/// Makes small drawings whose segments meet often. Every number is drawn from one stream.
class RandomDrafts {
 public:
  RandomDrafts(std::uint64_t seed, std::uint64_t stream) : random_(seed, stream) {}

  /// Polylines along the directions, from a random place or an old vertex to a new vertex.
  Draft walks(const std::vector<Vector>& directions, std::size_t edges, std::uint32_t side) {
    Draft draft;
    for (std::size_t i = 0; i < 3; ++i) draft.vertices.push_back(place(side));
    for (std::size_t i = 0; i < edges; ++i) draft = with_walk(std::move(draft), directions, side);
    return draft;
  }

  /// One more edge.
  Draft with_walk(Draft draft, const std::vector<Vector>& directions, std::uint32_t side) {
    const auto n = static_cast<Vertex>(draft.vertices.size());
    Vertex start = random_.below(n);
    if (random_.chance(1, 2)) {
      start = n;
      draft.vertices.push_back(place(side));
    }
    std::vector<Point> bends;
    Point at = draft.vertices[start];
    for (std::uint32_t steps = random_.below(4); steps > 0; --steps) {
      bends.push_back(at = step(at, directions));
    }
    draft.vertices.push_back(step(at, directions));
    draft.edges.push_back(
        {{start, static_cast<Vertex>(draft.vertices.size() - 1)}, std::move(bends)});
    if (random_.chance(1, 2)) reverse(draft.edges.back());
    return draft;
  }

  /// Damaged so many times, each time left a simple graph's, as long as it has edges.
  Draft damaged(Draft draft, std::uint32_t times) {
    for (; times > 0 && !draft.edges.empty(); --times) {
      damage(draft);
      draft = simple(std::move(draft));
    }
    return draft;
  }

  /// Damages the drawing in one of several ways; directions may become new ones.
  void damage(Draft& draft) {
    auto& edge = draft.edges[random_.below(static_cast<std::uint32_t>(draft.edges.size()))];
    const auto n = static_cast<std::uint32_t>(draft.vertices.size());
    switch (random_.below(6)) {
      case 0:  // move a bend
        if (!edge.bends.empty()) any(edge.bends) = place(8);
        break;
      case 1:  // swap two vertices
        std::swap(draft.vertices[random_.below(n)], draft.vertices[random_.below(n)]);
        break;
      case 2:  // put a vertex on a bend
        if (!edge.bends.empty()) draft.vertices[random_.below(n)] = any(edge.bends);
        break;
      case 3:  // repeat a bend
        if (!edge.bends.empty()) edge.bends.push_back(edge.bends.back());
        break;
      case 4:  // draw an edge twice
        draft.edges.push_back(Draft::DraftEdge(edge));
        break;
      default:  // move an end of an edge to any vertex, perhaps making a loop
        edge.ends.v = random_.below(n);
    }
  }

  /// The same drawing stretched and moved so far that 64 bits do not hold the sums.
  static Draft far_away(Draft draft) {
    std::int64_t largest = 1;
    const auto each = [&](auto&& change) {
      for (Point& p : draft.vertices) change(p);
      for (auto& edge : draft.edges) std::for_each(edge.bends.begin(), edge.bends.end(), change);
    };
    each([&](Point& p) {
      largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    });
    const std::int64_t stretch = kMaxCoordinate / largest;
    each([&](Point& p) { p = {stretch * p.x, stretch * p.y, stretch * p.z}; });
    return draft;
  }

  RandomStream& random() { return random_; }

 private:
  Point place(std::uint32_t side) {
    return {random_.below(side), random_.below(side), random_.below(side)};
  }
  Point step(Point at, const std::vector<Vector>& directions) {
    const Vector d = directions[random_.below(static_cast<std::uint32_t>(directions.size()))];
    const std::int64_t length = 1 + random_.below(4);
    return at + (random_.chance(1, 2) ? length : -length) * d;
  }
  Point& any(std::vector<Point>& points) {
    return points[random_.below(static_cast<std::uint32_t>(points.size()))];
  }
  static void reverse(Draft::DraftEdge& edge) {
    std::swap(edge.ends.u, edge.ends.v);
    std::reverse(edge.bends.begin(), edge.bends.end());
  }

  RandomStream random_;
};

}  // namespace ar3d::testing
