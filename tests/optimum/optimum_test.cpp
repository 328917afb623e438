// The smallest boxes of small graphs: known values, and what the proof of docs/optimum.md rests on.
#include <numeric>

#include "ar3d/base/error.h"
#include "ar3d/optimum/encoding.h"
#include "optimum/optimum_support.h"
#include "support/test.h"

namespace ar3d::testing {
namespace {

constexpr Question kBody{Diagonals::body, 3, false};
constexpr Question kFace{Diagonals::face, 3, false};

TEST(Optimum, OfSmallGraphsIsKnown) {
  EXPECT_EQ(smallest_volume(Graph(1, {}), kBody), 1);
  EXPECT_EQ(smallest_volume(path(2), kBody), 8);
  EXPECT_EQ(smallest_volume(path(3), kBody), 18);
  EXPECT_EQ(smallest_volume(cycle(3), kBody), 64);
  EXPECT_EQ(smallest_volume(complete(4), kBody), 125);
  EXPECT_EQ(smallest_volume(cycle(6), kBody), 64);
  EXPECT_EQ(smallest_volume(path(2), kFace), 4);
  EXPECT_EQ(smallest_volume(path(3), kFace), 12);
  EXPECT_EQ(smallest_volume(cycle(3), kFace), 27);
}

TEST(Optimum, InAPlaneIsLarger) {
  EXPECT_EQ(smallest_volume(path(2), {Diagonals::body, 3, true}), 18);
  EXPECT_EQ(smallest_volume(cycle(3), {Diagonals::body, 3, true}), 75);
}

TEST(Optimum, HasNoDrawingWhereThereIsNone) {
  const auto solver = optimum::cadical_solver();
  // A triangle needs a bend along body diagonals; no cubic graph has one bend along face diagonals.
  for (const auto& [graph, question] : {std::pair{cycle(3), Question{Diagonals::body, 0, false}},
                                        {complete(4), Question{Diagonals::face, 1, false}}}) {
    const auto found = find_smallest_box(graph, question, solver, {.volume_below = 90});
    EXPECT_FALSE(found.drawing);
    EXPECT_EQ(found.at_least, 90);
    EXPECT_FALSE(found.is_closed());
  }
}

TEST(Optimum, AgreesWithASecondEncoding) { EXPECT_GT(compare_encodings(40, 1), 8); }

TEST(Optimum, DoesNotDependOnTheNumbersOfVertices) {
  const std::int64_t known = smallest_volume(path(5), kBody);
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    EXPECT_EQ(smallest_volume(shuffled(path(5), seed), kBody), known);
  }
}

TEST(Optimum, StopsWhenAskedTo) {
  const auto solver = optimum::cadical_solver();
  int asked = 0;
  const auto found =
      find_smallest_box(complete(5), kBody, solver, {.should_stop = [&] { return ++asked > 40; }});
  EXPECT_FALSE(found.is_closed());
  EXPECT_GE(found.at_least, 8);
  EXPECT_LE(found.at_least, 512);
}

TEST(Optimum, RefusesWhatItCannotAnswer) {
  const auto refused = [](const Graph& graph, const Question& question) {
    try {
      refuse_unanswerable(graph, question);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refused(complete(5), kBody), "");
  EXPECT_THAT(refused(complete(5), kFace), HasSubstr("degree 4"));
  EXPECT_THAT(refused(complete(6), kBody), HasSubstr("degree 5"));
  EXPECT_THAT(refused(Graph(), kBody), HasSubstr("without vertices"));
  EXPECT_THAT(refused(Graph(2, {}), kBody), HasSubstr("2 components"));
  EXPECT_THAT(refused(path(33), kBody), HasSubstr("33 vertices"));
  EXPECT_THAT(refused(path(2), {Diagonals::body, 17, false}), HasSubstr("17 bends"));
}

TEST(Optimum, RefusesAFormulaBeyondMemory) {
  optimum::Formula formula;
  const std::vector<int> clause(1'000'000, 1);
  EXPECT_THROW(for (int i = 0; i < 51; ++i) formula.add(clause), std::length_error);
  EXPECT_EQ(formula.num_clauses(), 49u);
}

TEST(OptimumBoxes, AreMaximalAndCoverAllSmallerOnes) {
  for (const auto diagonals : {Diagonals::body, Diagonals::face}) {
    for (const std::int64_t below : {4, 9, 60, 216, 343}) {
      const auto boxes = optimum::maximal_boxes(below, diagonals, true);
      const auto covers = [](const BoxSize& outer, const BoxSize& inner) {
        return inner[0] <= outer[0] && inner[1] <= outer[1] && inner[2] <= outer[2];
      };
      for (int a = diagonals == Diagonals::body ? 2 : 1; a * a * a < below; ++a) {
        for (int b = std::max(a, 2); a * b * b < below; ++b) {
          for (int c = b; a * b * c < below; ++c) {
            const BoxSize box = {a, b, c};
            EXPECT_TRUE(std::ranges::any_of(boxes, [&](auto& some) { return covers(some, box); }));
          }
        }
      }
      for (const BoxSize& box : boxes) {
        EXPECT_LT(optimum::volume_of(box), below);
        EXPECT_EQ(std::ranges::count_if(boxes, [&](auto& other) { return covers(other, box); }), 1);
      }
    }
  }
}

TEST(OptimumPoints, AreTheClassesOfParity) {
  // Of the four classes of a cube three are images of each other, where one side differs two pairs.
  EXPECT_THAT(point_classes(kBody, {4, 4, 4}), SizeIs(1));
  EXPECT_THAT(point_classes(kBody, {5, 5, 5}), SizeIs(2));
  EXPECT_THAT(point_classes(kFace, {3, 3, 3}), SizeIs(2));
  EXPECT_THAT(point_classes(kFace, {4, 3, 3}), SizeIs(1));
  for (const auto& [question, box] : {std::pair{kBody, BoxSize{3, 4, 5}}, {kFace, {3, 3, 5}}}) {
    for (const auto& points : point_classes(question, box)) {
      const auto steps = optimum::steps_of(question.diagonals);
      for (std::size_t p = 0; p < points.points.size(); ++p) {
        for (std::size_t d = 0; d < steps.size(); ++d) {
          std::array<int, 3> to = points.points[p];
          const std::array<std::int64_t, 3> by = {steps[d].x, steps[d].y, steps[d].z};
          for (std::size_t i = 0; i < 3; ++i) to[i] += static_cast<int>(by[i]);
          const auto at = std::ranges::find(points.points, to);
          const int q = at == points.points.end() ? -1 : int(at - points.points.begin());
          EXPECT_EQ(points.neighbours[p][d], q);
        }
      }
      for (std::vector<int> images : points.symmetries) {
        std::ranges::sort(images);
        for (std::size_t p = 0; p < images.size(); ++p) EXPECT_EQ(images[p], int(p));
      }
    }
  }
}

TEST(OptimumAutomorphisms, AreThoseOfAllPermutations) {
  for (const Graph& graph : geng("-c 5")) {
    std::set<std::pair<Vertex, Vertex>> expected;
    std::vector<Vertex> names(graph.num_vertices());
    std::iota(names.begin(), names.end(), 0u);
    do {
      if (graph_hash(relabelled(graph, names)) != graph_hash(graph)) continue;
      Vertex i = 0;
      while (i < names.size() && names[i] == i) ++i;
      if (i < names.size()) expected.emplace(i, names[i]);
    } while (std::ranges::next_permutation(names).found);
    const auto pairs = optimum::orbit_pairs(graph);
    EXPECT_EQ((std::set<std::pair<Vertex, Vertex>>(pairs.begin(), pairs.end())), expected);
  }
}

}  // namespace
}  // namespace ar3d::testing
