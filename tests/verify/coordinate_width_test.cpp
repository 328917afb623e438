// Widths that a theorem's bound proves for coordinates, and those that a drawing fits.
#include "ar3d/verify/coordinate_width.h"

#include <cmath>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/generators/catalog.h"
#include "support/problem.h"
#include "verify/draft.h"

namespace ar3d::testing {
namespace {

std::string refusal(const CoordinateWidth& width, const SizeBound& bound, const Drawing& drawing) {
  return problem([&] { require_width(width, bound, drawing); });
}

TEST(CoordinateWidths, HaveNames) {
  EXPECT_EQ(parse_coordinate_width("proved=int16"), (CoordinateWidth{16, true}));
  EXPECT_EQ(parse_coordinate_width("checked=int64"), (CoordinateWidth{64, false}));
  for (const char* name : {"", "auto", "int16", "proved", "proved=int8", "checked=int160"}) {
    EXPECT_THROW(parse_coordinate_width(name), InputError) << name;
  }
}

TEST(CoordinateWidths, AreProvedByTheBound) {
  const SizeBound& diamond = find_algorithm("diamond").guarantee.bound;  // 8 n
  EXPECT_EQ(proved_n(diamond, 16), 4095u);
  EXPECT_EQ(proved_n(diamond, 32), 268435455u);
  EXPECT_EQ(proved_n(diamond, 64), 4294967295u);
  EXPECT_EQ(proved_n(find_algorithm("two-bend").guarantee.bound, 64), 96038388u);  // 1000 n^2
  EXPECT_EQ(proved_n({}, 32), 0u) << "no bound";
  for (const Algorithm* algorithm : proved_algorithms()) {
    for (const int bits : {16, 32}) {
      const SizeBound& bound = algorithm->guarantee.bound;
      const std::uint64_t n = proved_n(bound, bits);
      const double limit = std::ldexp(1, bits - 1);
      if (n == 0) continue;  // not even for one vertex
      double at = 0, beyond = 0;
      for (const AxisBound& axis : bound.axes) {
        at = std::max(at, axis.value(n));
        beyond = std::max(beyond, axis.value(std::min<std::uint64_t>(n + 1, 4294967295u)));
      }
      EXPECT_LT(at, limit) << algorithm->name;
      if (n < 4294967295u) {
        EXPECT_GE(beyond, limit) << algorithm->name;
      }
    }
  }
}

TEST(CoordinateWidths, AreCheckedAtTheLargestCoordinateAndOneBeyond) {
  for (const int bits : {16, 32}) {
    const std::int64_t largest = (std::int64_t{1} << (bits - 1)) - 1;
    Draft draft;
    draft.vertices = {{-5, 0, 0}, {-5 + largest, 0, 0}};
    draft.edges = {{{0, 1}, {{7, largest, 3}}}};
    const CoordinateWidth width{bits, false};
    EXPECT_EQ(refusal(width, {}, draft.drawing()), "");
    draft.edges[0].bends[0].y += 1;
    EXPECT_THAT(refusal(width, {}, draft.drawing()),
                HasSubstr("edge 0, bend 1 at (7, " + std::to_string(largest + 1) + ", 3): y is " +
                          std::to_string(largest + 1) + " above the least one"));
    draft.vertices[1].x += 1;
    EXPECT_THAT(refusal(width, {}, draft.drawing()), HasSubstr("vertex 1 at ("));
    EXPECT_EQ(refusal({64, false}, {}, draft.drawing()), "");
    EXPECT_THAT(refusal({bits, true}, {}, draft.drawing()), HasSubstr("for at most 0"));
  }
}

TEST(CoordinateWidths, OfRealDrawingsAreRefused) {
  const Algorithm& paper = find_algorithm("two-bend-paper");
  const Drawing drawing = draw(paper, generate(find_family("cycle"), 5, 0));
  for (const bool proved : {false, true}) {
    for (const int bits : {16, 32, 64}) {
      EXPECT_THAT(refusal({bits, proved}, paper.guarantee.bound, drawing), HasSubstr("real type"));
      EXPECT_EQ(proved_n(paper.guarantee.bound, bits), 0u) << "it promises no box";
    }
  }
}

}  // namespace
}  // namespace ar3d::testing
