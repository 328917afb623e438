// Right drawings moved to the ends of every width stay right, and one step beyond the last one is
// refused.
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <vector>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/error.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/verify/certificate.h"
#include "ar3d/verify/metrics/metrics.h"
#include "verify/draft.h"

namespace ar3d::testing {
namespace {

/// The largest coordinates of 16, 31, 32 and 62 bits, those below which the proofs change their
/// integers, and their neighbours.
std::vector<std::int64_t> ends_of_widths() {
  std::vector<std::int64_t> ends;
  for (const int bits : {15, 26, 30, 31, 41, 52, 53, 60}) {
    for (const std::int64_t beside : {-1, 0, 1}) ends.push_back((std::int64_t{1} << bits) + beside);
  }
  ends.push_back(kMaxCoordinate - 1);
  ends.push_back(kMaxCoordinate);
  return ends;
}

TEST(Extremes, RightDrawingsAreRightAtTheEndsOfEveryWidth) {
  const Graph graph = generate(find_family("random-cubic"), 30, 1);
  for (const Algorithm* algorithm : proved_algorithms()) {
    const Drawing drawing = draw(*algorithm, graph);
    const DrawingSummary summary = measure(drawing);
    for (const std::int64_t end : ends_of_widths()) {
      const Box box = summary.box;
      const Drawing high = draft_of(drawing, {end - box.high.x, end - box.high.y, 0}).drawing();
      const Drawing low = draft_of(drawing, {-end - box.low.x, -end - box.low.y, 0}).drawing();
      for (const Drawing* far : {&high, &low}) {
        const Certificate certificate = certify(graph, *far, algorithm->guarantee);
        EXPECT_TRUE(certificate.valid())
            << algorithm->name << ' ' << end << ": "
            << (certificate.violations.empty() ? "" : certificate.violations[0].message);
        const DrawingSummary moved_summary = measure(*far);
        EXPECT_EQ(moved_summary.box.extents(), summary.box.extents());
        EXPECT_EQ(moved_summary.total_edge_length, summary.total_edge_length);
        EXPECT_EQ(moved_summary.smallest_vertex_distance, summary.smallest_vertex_distance);
      }
    }
  }
}

TEST(Extremes, OneStepBeyondTheLastWidthIsNamed) {
  const Graph graph = generate(find_family("cycle"), 8, 1);
  const Algorithm& algorithm = find_algorithm("diamond");
  const Drawing drawing = draw(algorithm, graph);
  const Box box = measure(drawing).box;
  const Draft draft = draft_of(drawing, {kMaxCoordinate + 1 - box.high.x, 0, 0});
  for (const Point p : draft.vertices) {
    ASSERT_LE(p.x, kMaxCoordinate) << "this drawing does not reach the end by a bend alone";
  }
  const Drawing beyond = draft.drawing();
  const Certificate certificate = certify(graph, beyond, algorithm.guarantee);
  EXPECT_FALSE(certificate.valid());
  ASSERT_FALSE(certificate.violations.empty());
  EXPECT_EQ(certificate.violations[0].kind, ViolationKind::coordinate_range);
}

TEST(Extremes, CoordinatesHoldTheirBoundAndNoMore) {
  constexpr std::int64_t kNarrow = std::numeric_limits<std::int32_t>::max();
  constexpr std::int64_t kNarrowest = std::numeric_limits<std::int16_t>::max();
  for (const std::int64_t bound :
       {std::int64_t{0}, kNarrowest - 1, kNarrowest, kNarrowest + 1, kNarrow - 1, kNarrow,
        kNarrow + 1, kMaxCoordinate - 1, kMaxCoordinate}) {
    Coordinates coordinates(2, bound);
    EXPECT_EQ(coordinates.bytes_per_point(), bound <= kNarrowest ? 6u
                                             : bound <= kNarrow  ? 12u
                                                                 : 24u);
    coordinates.set(0, {bound, -bound, 0});
    EXPECT_EQ(coordinates[0], (Point{bound, -bound, 0})) << bound;
    for (const Point beyond :
         {Point{bound + 1, 0, 0}, Point{0, -bound - 1, 0}, Point{0, 0, bound + 1}}) {
      EXPECT_THROW(coordinates.set(1, beyond), InternalError) << bound;
    }
    EXPECT_EQ(coordinates[1], Point{});
  }
  EXPECT_THROW(Coordinates(1, kMaxCoordinate + 1), InputError);
  EXPECT_THROW(Coordinates(1, -1), InputError);
}

}  // namespace
}  // namespace ar3d::testing
