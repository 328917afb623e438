#include "ar3d/algorithms/catalog.h"
#include "ar3d/algorithms/diamond/diamond.h"
#include "ar3d/algorithms/grid/grid.h"
#include "ar3d/algorithms/two_bend/two_bend.h"
#include "ar3d/base/error.h"
#include "support/problem.h"
#include "support/test.h"

// A graph of too large a degree is refused by the first such vertex and its degree, by every way
// in.

namespace ar3d::testing {
namespace {

/// Vertex 2 has degree 5, vertex 3 has degree 6.
Graph two_stars() {
  return Graph(13,
               {{2, 4}, {2, 5}, {2, 6}, {2, 7}, {2, 3}, {3, 8}, {3, 9}, {3, 10}, {3, 11}, {3, 12}});
}

template <class Draw>
std::string refusal(Draw draw) {
  return problem([&] { draw(two_stars()); }, "drawn");
}

TEST(DegreeLimit, NamesTheFirstVertexAndItsDegree) {
  for (const Algorithm& row : algorithms()) {
    EXPECT_EQ(refusal([&](const Graph& graph) { draw(row, graph); }),
              row.name + " draws graphs of maximum degree " +
                  std::to_string(row.guarantee.max_degree) +
                  ", but vertex 2 has degree 5 (vertices count from 0)");
  }
  const std::string vertex = "but vertex 2 has degree 5 (vertices count from 0)";
  EXPECT_THAT(refusal([](const Graph& graph) { diamond::draw(graph); }), HasSubstr(vertex));
  EXPECT_THAT(refusal([](const Graph& graph) { grid::draw(graph); }), HasSubstr(vertex));
  EXPECT_THAT(refusal([](const Graph& graph) { two_bend::draw(graph); }), HasSubstr(vertex));
}

}  // namespace
}  // namespace ar3d::testing
