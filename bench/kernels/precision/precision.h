#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "ar3d/model/drawing.h"
#include "ar3d/model/guarantee.h"
#include "ar3d/verify/predicates/widths.h"

namespace ar3d::precision {

using Angle = std::array<Point, 3>;        ///< at the second point
using SegmentPair = std::array<Point, 4>;  ///< the ends of the first, then those of the second

/// Holds what the predicates of a drawing's certificate are asked.
struct Decisions {
  std::vector<Angle> angles;
  std::vector<SegmentPair> pairs;  ///< whose boxes meet
  verify::PredicateBits bits;      ///< that all decisions of the drawing need
};

/// Returns at most so many of the drawing's angles, spread evenly, and of its pairs of segments:
/// each with those among the 200 before it, upwards, whose boxes meet its own.
Decisions decisions_of(const Drawing& drawing, const Guarantee& guarantee, std::size_t most);

/// Returns a share of trials with its 95 % Wilson interval: "4 % (2.3-6.9)"; of no success "0 (<
/// 1.2 %)", the interval's end.
std::string rate(std::uint64_t successes, std::uint64_t trials);

/// Prints a Markdown table. @pre every row has as many cells as the head.
void print_table(const std::vector<std::string>& head,
                 const std::vector<std::vector<std::string>>& rows);

// What each prints stands in main.cpp.
/// @param most  the largest depth of nests.
void nest_table(int most);
void predicate_tables();
void shift_tables();
/// @param picture  a new SVG file of the worst windows; empty: none. @throws InputError if it
/// exists or cannot be written.
void sign_tables(const std::string& picture);
void width_tables();

}  // namespace ar3d::precision
