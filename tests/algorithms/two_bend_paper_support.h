#pragma once

// What every drawing of two-bend-paper has to keep in the reference type, and graphs that nest the
// figures of its contractions.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "ar3d/algorithms/two_bend_paper/two_bend_paper.h"
#include "ar3d/base/random.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/verify/assessment/real_assessment.h"
#include "support/graphs.h"

namespace ar3d::testing {

/// 237 bits leave this much of a miss even in the deepest of the tested nests.
inline constexpr double kReferenceMiss = 1e-40;

inline void expect_right_in_reference(const Graph& graph, const std::string& what = {}) {
  const RealPoints points = two_bend_paper::draw_real(graph, two_bend_paper::RealType::reference);
  const RealAssessment found = assess(graph, points);
  EXPECT_LT(found.largest_miss, kReferenceMiss) << what;
  EXPECT_EQ(found.collapsed, 0u) << what;
  EXPECT_EQ(found.crossings, 0u) << what;
  EXPECT_LE(found.bend_histogram.size(), 3u) << what << ": at most two bends per edge";
}

/// The edges of a graph whose vertices are replaced by figures of more vertices.
class Blown {
 public:
  explicit Blown(const Graph& graph)
      : size_(graph.num_vertices()), edges_(graph.edges().begin(), graph.edges().end()) {}

  Vertex size() const { return size_; }
  Graph graph() const { return Graph(size_, edges_); }

  /// A triangle in place of v, which is its first corner; its edges go to different corners.
  /// @return the corner that gets an edge to the outside last, or none.
  Vertex triangle(Vertex v) {
    const Vertex a = add(), b = add();
    spread(v, {v, a, b});
    join({{v, a}, {v, b}, {a, b}});
    return b;
  }
  /// Two triangles with a common side in place of v, a vertex of degree at most 2.
  void diamond(Vertex v) {
    const Vertex tip = add(), a = add(), b = add();
    spread(v, {v, tip});
    join({{v, a}, {v, b}, {tip, a}, {tip, b}, {a, b}});
  }
  /// v, of degree at most 1, gets a diamond whose both tips it is adjacent to.
  void fat_leaf(Vertex v) {
    const Vertex tip = add(), other = add(), a = add(), b = add();
    join({{v, tip}, {v, other}, {tip, a}, {tip, b}, {other, a}, {other, b}, {a, b}});
  }
  /// Any of these at a random vertex.
  void any(RandomStream& random) {
    const Vertex v = random.below(size_);
    const std::uint32_t choice = random.below(3);
    if (choice == 2 && degree(v) <= 1) return fat_leaf(v);
    if (choice == 1 && degree(v) <= 2) return diamond(v);
    triangle(v);
  }

 private:
  Vertex add() { return size_++; }
  std::uint32_t degree(Vertex v) const {
    std::uint32_t degree = 0;
    for (const Edge e : edges_) degree += e.u == v || e.v == v ? 1 : 0;
    return degree;
  }
  void join(std::vector<Edge> edges) { edges_.insert(edges_.end(), edges.begin(), edges.end()); }
  /// Hands the edges at v on to the new ends, one to each.
  void spread(Vertex v, const std::vector<Vertex>& ends) {
    std::size_t next = 0;
    for (Edge& e : edges_) {
      if (e.u == v) {
        e.u = ends[next++];
      } else if (e.v == v) {
        e.v = ends[next++];
      }
    }
  }

  Vertex size_;
  std::vector<Edge> edges_;
};

/// A triangle in place of a vertex, again and again: `levels` regular hexagons inside one another
/// if that vertex has degree 3, heptagons if it has degree 2, as the third corner has then.
inline Graph nest(const Graph& graph, int levels) {
  Blown blown(graph);
  Vertex v = 0;
  for (int i = 0; i < levels; ++i) v = blown.triangle(v);
  return blown.graph();
}

/// Some graphs of maximum degree 3 with random figures in place of vertices.
inline void expect_mixtures_right(std::uint64_t count, RandomStream random,
                                  std::uint32_t most_vertices, std::uint32_t most_figures) {
  for (std::uint64_t i = 0; i < count; ++i) {
    Blown blown(generate(find_family("random-subcubic"), 2 + random.below(most_vertices), i));
    const std::uint32_t figures = 1 + random.below(most_figures);
    for (std::uint32_t j = 0; j < figures; ++j) blown.any(random);
    expect_right_in_reference(blown.graph(), fmt::format("mixture {}", i));
    if (::testing::Test::HasFailure()) return;
  }
}

}  // namespace ar3d::testing
