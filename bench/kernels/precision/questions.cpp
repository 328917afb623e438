#include "questions.h"

#include <compare>

#include "ar3d/base/random.h"
#include "ar3d/model/cosine_comparison.h"
#include "ar3d/verify/checks/exact.h"

namespace ar3d::precision {
namespace {

std::int64_t& any_coordinate(Point& p, RandomStream& random) {
  const std::uint32_t axis = random.below(3);
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

/// Is the angle as promised: by P1 if all must be equal, else by P2?
bool keeps(const Guarantee& guarantee, std::strong_ordering order) {
  return guarantee.angle_rule == AngleRule::exactly ? order == 0 : order <= 0;
}

}  // namespace

std::vector<Angle> one_off(std::vector<Angle> angles) {
  RandomStream random(1);
  for (auto& angle : angles) {
    any_coordinate(angle[0], random) += random.chance(1, 2) ? 1 : -1;
  }
  std::erase_if(angles, [](const auto& angle) { return angle[0] == angle[1]; });
  return angles;
}

std::vector<SegmentPair> touching(std::vector<SegmentPair> pairs) {
  RandomStream random(2);
  for (auto& [a, b, c, d] : pairs) {
    const Vector move = (random.chance(1, 2) ? a : b) - (random.chance(1, 2) ? c : d);
    c = c + move;
    d = d + move;
    if (random.chance(1, 2)) {
      std::int64_t& coordinate = any_coordinate(c, random);
      coordinate += random.chance(1, 2) ? 1 : -1;
    }
  }
  std::erase_if(pairs, [](const auto& pair) { return pair[2] == pair[3]; });
  return pairs;
}

std::uint64_t wrong_angles(const verify::PredicateChoice& choice, const Guarantee& guarantee,
                           const std::vector<Angle>& angles) {
  std::uint64_t wrong = 0;
  for (const auto& [from, at, to] : angles) {
    const auto order = choice.angle(guarantee.lattice, from, at, to, guarantee.cosine);
    const auto exact = compare_cosine(guarantee.lattice, from - at, to - at, guarantee.cosine);
    wrong += keeps(guarantee, order) != keeps(guarantee, exact);
  }
  return wrong;
}

std::uint64_t wrong_meetings(const verify::PredicateChoice& choice,
                             const std::vector<SegmentPair>& pairs) {
  std::uint64_t wrong = 0;
  for (const auto& [a, b, c, d] : pairs) {
    const auto exact = verify::meeting_kind_in(verify::IntegerWidth::int256, a, b, c, d);
    wrong += (choice.meeting(a, b, c, d) == verify::MeetingKind::nothing) !=
             (exact == verify::MeetingKind::nothing);
  }
  return wrong;
}

}  // namespace ar3d::precision
