#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ar3d/model/guarantee.h"
#include "ar3d/verify/predicates/choices.h"

namespace ar3d::precision {

using Angle = std::array<Point, 3>;        ///< at the second point
using SegmentPair = std::array<Point, 4>;  ///< the ends of the first, then those of the second

/// The angles, one coordinate of one end moved by one unit.
std::vector<Angle> one_off(std::vector<Angle> angles);

/// The pairs, the second segment moved so that an end of it falls on an end of the first, or one
/// unit beside.
std::vector<SegmentPair> touching(std::vector<SegmentPair> pairs);

/// Wrong answers to "is this angle as promised": exactly the optimum, or at least that.
std::uint64_t wrong_angles(const verify::PredicateChoice& choice, const Guarantee& guarantee,
                           const std::vector<Angle>& angles);
/// Wrong answers to "do these segments meet".
std::uint64_t wrong_meetings(const verify::PredicateChoice& choice,
                             const std::vector<SegmentPair>& pairs);

}  // namespace ar3d::precision
