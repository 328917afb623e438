#include <cmath>

#include "ar3d/base/error.h"
#include "ar3d/formats/drawings/drawing_exports.h"
#include "support/test.h"
#include "verify/draft.h"

namespace ar3d::testing {
namespace {

/// K2 with one bend on the lattice.
Drawing one_edge(std::size_t bends_per_edge, Lattice lattice = kCubeLattice) {
  const std::vector<Point> bends(bends_per_edge, Point{1, 1, 1});
  return Draft{{{}, {2, 0, 0}}, {{{0, 1}, bends}}, lattice}.drawing();
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

TEST(DrawingSvg, OneBallAVertexAndOneTubeASegment) {
  const std::string svg = drawing_to_svg(one_edge(1));
  EXPECT_THAT(svg, HasSubstr("<svg xmlns"));
  EXPECT_EQ(count(svg, "<circle"), 2u);
  EXPECT_EQ(count(svg, "<path class=\"role0\""),
            4u);  // of each segment what a ball covers, and the rest
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(DrawingSvg, TallLatticeIsShrunkInZ) {
  // Seen from the side, the apex (1, 1, 1) stands lower in the tall lattice, where z counts
  // 1/sqrt(3).
  const ExportOptions side{.turn_degrees = 0, .tilt_degrees = 90};
  EXPECT_NE(drawing_to_svg(one_edge(1), side), drawing_to_svg(one_edge(1, kScaledZLattice), side));
}

TEST(DrawingSvg, RefusesWhatNobodyCanRead) {
  EXPECT_THROW(drawing_to_svg(one_edge(20001)), InputError);
}

/// Two edges that cross on the picture, at different heights, seen from above.
Drawing two_edges() {
  return Draft{{{0, 0, 0}, {20, 20, 0}, {0, 20, 9}, {20, 0, 9}}, {{{0, 1}, {}}, {{2, 3}, {}}}}
      .drawing();
}

TEST(Projection, TheFartherEdgeHasAGapWhereTwoCross) {
  for (const double perspective : {0.0, 3.0}) {
    const ExportOptions above{.turn_degrees = 0, .tilt_degrees = 0, .perspective = perspective};
    const Projection picture = project(two_edges(), above, "svg");
    const Real3 centre = {picture.width / 2, picture.height / 2, 0};
    double nearest_free = 1e9;  // end of a stroke of the lower edge next to the crossing
    std::size_t through = 0;
    for (const Projection::PaintedItem& item : picture.items) {
      if (item.role < 0) continue;
      const auto away = [&](Real3 p) { return std::hypot(p.x - centre.x, p.y - centre.y); };
      const double length = std::hypot(item.to.x - item.from.x, item.to.y - item.from.y);
      if (std::abs(away(item.from) + away(item.to) - length) < 1e-6) {
        ++through;  // the upper edge's, whole
        EXPECT_GT(length, 1000 * 0.5);
      } else {
        nearest_free = std::min({nearest_free, away(item.from), away(item.to)});
      }
    }
    EXPECT_EQ(through, 1u);
    EXPECT_GT(nearest_free, picture.stroke);
    EXPECT_LT(nearest_free, 3 * picture.stroke);
  }
}

TEST(Projection, WhatIsNearerIsPaintedLater) {
  const ExportOptions above{.turn_degrees = 0, .tilt_degrees = 0, .perspective = 2};
  const Projection picture = project(two_edges(), above, "svg");
  for (std::size_t i = 1; i < picture.items.size(); ++i) {
    EXPECT_LE(picture.items[i - 1].depth, picture.items[i].depth);
  }
  EXPECT_GT(picture.items.back().scale, picture.items.front().scale) << "nearer is larger";
}

TEST(Projection, StretchesTheBoxToACube) {
  const ExportOptions side{.turn_degrees = 0, .tilt_degrees = 90};
  ExportOptions stretched = side;
  stretched.stretch = true;
  EXPECT_LT(project(two_edges(), side, "svg").height, 480) << "9 of 20 high";
  EXPECT_NEAR(project(two_edges(), stretched, "svg").height, 900, 1);
}

TEST(Projection, RefusesAnEyeInTheDrawing) {
  EXPECT_THROW(project(two_edges(), {.tilt_degrees = 0, .perspective = 0.01}, "svg"), InputError);
}

TEST(DrawingTikz, IsOnePicture) {
  const std::string tex = drawing_to_tikz(two_edges());
  EXPECT_THAT(tex, HasSubstr("\\definecolor{ar3drole0}{RGB}{86,180,233}"));
  EXPECT_EQ(count(tex, "\\shade"), 4u);
  EXPECT_GE(count(tex, "\\draw[ar3drole0!"), 3u);
}

}  // namespace
}  // namespace ar3d::testing
