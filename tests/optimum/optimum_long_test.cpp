// The two encodings on thousands of boxes, and the smallest boxes of all graphs with five vertices
// by the second one alone.

#include "optimum/optimum_support.h"

namespace ar3d::testing {
namespace {

TEST(OptimumLong, AgreesWithASecondEncodingTwoThousandTimes) {
  EXPECT_GT(compare_encodings(2000, 2), 300);
}

TEST(OptimumLong, GrowsWithEdges) {
  int pairs = 0;
  for (const Graph& graph : geng("-c -D3 4")) {
    const std::int64_t volume = smallest_volume(graph, Question{});
    for (const Graph& less : without_an_edge(graph)) {
      EXPECT_LE(smallest_volume(less, Question{}), volume);
      ++pairs;
    }
  }
  EXPECT_EQ(pairs, 18);
}

/// The second encoding finds a drawing in no smaller box. Without one in the box itself, too, there
/// would be none that certify() accepts.
void expect_smallest(const Graph& graph, const Question& question, std::int64_t volume) {
  const auto solver = optimum::cadical_solver();
  const bool has_edges = graph.num_edges() > 0;
  for (const BoxSize& box : optimum::maximal_boxes(volume, question.diagonals, has_edges)) {
    EXPECT_FALSE(holds_drawing(graph, question, box, solver)) << optimum::to_string(box);
  }
}

TEST(OptimumLong, IsSmallestByTheSecondEncodingToo) {
  for (const Diagonals diagonals : {Diagonals::body, Diagonals::face}) {
    const Question question{diagonals, 3, false};
    for (const char* some : {"-c 2", "-c 3", "-c 4", "-c 5"}) {
      for (const Graph& graph : geng(some)) {
        if (graph.max_degree() > guarantee_of(question).max_degree) continue;
        if (graph.num_edges() == 10) continue;  // K5 has by far the largest boxes
        expect_smallest(graph, question, smallest_volume(graph, question));
      }
    }
  }
}

}  // namespace
}  // namespace ar3d::testing
