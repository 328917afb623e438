// The residue tables of docs/compact.md, the shape of the words and the heights, read off finished
// drawings.
#include <gtest/gtest.h>

#include <cstdlib>

#include "algorithms/strips_support.h"
#include "ar3d/generators/catalog.h"

namespace ar3d {
namespace {

using compact::kA;
using compact::kB;
using compact::kC;
using compact::kD;
using compact::Letter;

/// The six forms of a lattice point: differences of its letter coordinates.
struct Forms {
  std::int64_t AB, AC, AD, BC, BD, CD;
  explicit Forms(Point p) {
    const std::int64_t A = (p.x + p.y) / 2;  // D = 0
    const std::int64_t V = (p.x - p.y) / 2;  // B - C
    const std::int64_t B = (A - p.z + V) / 2;
    const std::int64_t C = B - V;
    AB = A - B, AC = A - C, AD = A, BC = V, BD = B, CD = C;
  }
};

std::int64_t mod4(std::int64_t value) { return ((value % 4) + 4) % 4; }
bool odd(std::int64_t value) { return value % 2 != 0; }

/// The letter of a segment and whether it runs along it (+) or against it (-).
struct Step {
  Letter letter;
  bool forward;
  std::int64_t length;
};

Step step_between(Point p, Point q) {
  const Vector d = q - p;
  constexpr std::array<Vector, 4> letters = {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}};
  const std::int64_t length = std::abs(d.x);
  for (const Letter letter : {kA, kB, kC, kD}) {
    if (d == length * letters[letter]) return {letter, true, length};
    if (d == -length * letters[letter]) return {letter, false, length};
  }
  ADD_FAILURE() << "no letter";
  return {};
}

bool upper_line_is_in_table(Letter letter, const Forms& f) {
  switch (letter) {
    case kA:
      return mod4(f.BC) == 0 && mod4(f.CD) == 0 && mod4(f.BD) == 0;
    case kD:
      return mod4(f.AB) == 2 && mod4(f.AC) == 0 && mod4(f.BC) == 2;
    case kB:
      return mod4(f.AC) == 2 && mod4(f.AD) == 0 && mod4(f.CD) == 2;
    default:
      return mod4(f.AD) == 2 && mod4(f.AB) == 0 && mod4(f.BD) == 2;
  }
}

bool lower_line_is_in_table(Letter letter, const Forms& f) {
  switch (letter) {
    case kB:
      return mod4(f.AC) == 0 && !odd(f.AD) && !odd(f.CD);
    case kA:
      return odd(f.BC) && mod4(f.BD) == 0 && odd(f.CD);
    case kD:
      return !odd(f.AB) && mod4(f.AC) == 2 && !odd(f.BC);
    default:
      return odd(f.AD) && mod4(f.BD) == 2 && odd(f.AB);
  }
}

/// Checks one edge; `points` run from tail to head.
void check_edge(const std::vector<Point>& points, bool red) {
  ASSERT_EQ(points.size(), 7u);
  std::vector<Step> steps;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    steps.push_back(step_between(points[i], points[i + 1]));
    ASSERT_EQ(steps[i].forward, i % 2 == 0);
    ASSERT_GE(steps[i].length, 1);
    if (i == 0) continue;
    ASSERT_NE(steps[i].letter, steps[i - 1].letter);
    ASSERT_TRUE(red ? points[i].z < 0 : points[i].z > 0);
  }
  const bool right = Forms(points[6]).AD > Forms(points[0]).AD;
  EXPECT_EQ(steps[1].length, red ? 1 : 2);
  EXPECT_EQ(steps[3].length, red && !right ? 1 : 2);
  EXPECT_EQ(steps[5].length, red && right ? 1 : 2);
  for (const std::size_t i : {0u, 2u, 4u}) {
    for (const std::size_t end : {i, i + 1}) {
      const Forms forms(points[end]);
      EXPECT_TRUE(red ? lower_line_is_in_table(steps[i].letter, forms)
                      : upper_line_is_in_table(steps[i].letter, forms))
          << "segment " << i << " letter " << int{steps[i].letter};
    }
  }
}

void check_drawing(const Graph& graph, const Drawing& drawing) {
  const compact::Decomposition links = compact::decompose(graph);
  std::vector<Point> points;
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    for (const compact::ColourRole role : {compact::kGreenOut, compact::kRedOut}) {
      const HalfEdge edge = links.at[v][role];
      if (edge.to == compact::kNobody) continue;
      drawing.polyline(edge.edge, points);
      if (graph.edge(edge.edge).u != v) std::reverse(points.begin(), points.end());
      check_edge(points, compact::is_red(role));
      if (::testing::Test::HasFailure()) return;
    }
  }
}

TEST(CompactResidues, HoldOnEveryLongSegmentOfEveryFamily) {
  for (const Family& family : families()) {
    if (family.max_degree > 4) continue;
    for (const std::uint64_t n : {10u, 100u, 500u}) {
      const Graph graph = generate(family, n, 4);
      for (const int effort : testing::kStripEfforts) {
        check_drawing(graph, compact::draw(graph, {.effort = effort}));
      }
    }
  }
}

}  // namespace
}  // namespace ar3d
