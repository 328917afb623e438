#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "ar3d/model/drawing.h"
#include "ar3d/model/guarantee.h"
#include "ar3d/verify/predicates/choices.h"
#include "ar3d/verify/predicates/widths.h"

namespace ar3d::precision {

/// Holds what the predicates of a drawing's certificate are asked.
struct Decisions {
  Lattice lattice;
  Cosine cosine;
  std::vector<std::array<Point, 3>> angles;  ///< at the second point
  std::vector<std::array<Point, 4>> pairs;   ///< ends of two segments whose boxes meet
  verify::PredicateBits bits;                ///< that all decisions of the drawing need
};

/// Returns at most so many of the drawing's angles, spread evenly, and of its pairs of segments:
/// each with those among the 200 before it, upwards, whose boxes meet its own.
Decisions decisions_of(const Drawing& drawing, const Guarantee& guarantee, std::size_t most);

using Angle = std::array<Point, 3>;        ///< at the second point
using SegmentPair = std::array<Point, 4>;  ///< the ends of the first, then those of the second

/// Returns the angles, one coordinate of one end moved by one unit.
std::vector<Angle> one_off(std::vector<Angle> angles);

/// Returns the pairs, the second segment moved so that an end of it falls on an end of the first,
/// or one unit beside.
std::vector<SegmentPair> touching(std::vector<SegmentPair> pairs);

/// Returns wrong answers to "is this angle as promised": exactly the optimum, or at least that.
std::uint64_t wrong_angles(const verify::PredicateChoice& choice, const Guarantee& guarantee,
                           const std::vector<Angle>& angles);
/// Returns wrong answers to "do these segments meet".
std::uint64_t wrong_meetings(const verify::PredicateChoice& choice,
                             const std::vector<SegmentPair>& pairs);

/// Returns a share of trials with its 95 % Wilson interval: "4 % (2.3-6.9)"; of no success "0 (<
/// 1.2 %)", the interval's end.
std::string rate(std::uint64_t successes, std::uint64_t trials);

/// Prints a Markdown table. @pre every row has as many cells as the head.
void print_table(const std::vector<std::string>& head,
                 const std::vector<std::vector<std::string>>& rows);

/// Describes everything that the tables can be asked for.
struct TableOptions {
  int depth = 120;           ///< largest depth of nests
  std::string picture = {};  ///< a new SVG file of the worst windows; empty: none
};

// What each prints stands in main.cpp. @throws InputError if the picture exists or cannot be
// written.
void nest_table(const TableOptions& options);
void predicate_tables(const TableOptions& options);
void shift_tables(const TableOptions& options);
void sign_tables(const TableOptions& options);
void width_tables(const TableOptions& options);

}  // namespace ar3d::precision
