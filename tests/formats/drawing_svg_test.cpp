#include "ar3d/formats/drawings/drawing_svg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ar3d/model/error.h"

namespace ar3d {
namespace {

using ::testing::HasSubstr;

/// K2 with one bend on the lattice.
Drawing one_edge(std::size_t bends_per_edge, Lattice lattice = kCubeLattice) {
  Coordinates vertices(2, 100);
  vertices.set(1, {2, 0, 0});
  auto bends = std::make_shared<StoredBends>();
  bends->add_edge(std::vector<Point>(bends_per_edge, Point{1, 1, 1}));
  return Drawing("test", lattice, std::move(vertices),
                 std::make_shared<std::vector<Edge>>(1, Edge{0, 1}), std::move(bends));
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
  EXPECT_EQ(count(svg, "stroke-linecap"), 2u * 12u);  // two segments in twelve pieces each
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(DrawingSvg, TallLatticeIsShrunkInZ) {
  // Seen from the side, the apex (1, 1, 1) stands lower in the tall lattice, where z counts
  // 1/sqrt(3).
  const SvgView side{.turn_degrees = 0, .tilt_degrees = 90};
  EXPECT_NE(drawing_to_svg(one_edge(1), side), drawing_to_svg(one_edge(1, kTallLattice), side));
}

TEST(DrawingSvg, RefusesWhatNobodyCanRead) {
  EXPECT_THROW(drawing_to_svg(one_edge(20001)), InputError);
}

}  // namespace
}  // namespace ar3d
