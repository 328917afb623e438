// Step V.11 of docs/verify.md. Where long segments are vertical, few of the others are at one
// height, and nearly all of these have boxes apart.
#include "ar3d/verify/counting/slanted_pairs.h"

#include <algorithm>

#include "ar3d/verify/exact.h"
#include "ar3d/verify/order.h"
#include "ar3d/verify/predicates/widths.h"

namespace ar3d::verify {
namespace {

Point from(const SlantedSegment& s) { return {s.x, s.y, s.z}; }
Point to(const SlantedSegment& s) { return {s.x + s.dx, s.y + s.dy, s.z + s.dz}; }

struct Active {
  std::int32_t low_x;
  std::int32_t high_x;
  std::int32_t low_y;
  std::int32_t high_y;
  std::int64_t high;
  std::uint32_t segment;
};

Active active(const SlantedSegment& s, std::uint32_t segment) {
  return {std::min(s.x, s.x + s.dx),
          std::max(s.x, s.x + s.dx),
          std::min(s.y, s.y + s.dy),
          std::max(s.y, s.y + s.dy),
          s.z + s.dz,
          segment};
}

bool overlap(const Active& a, const Active& b) {
  return a.low_x <= b.high_x && b.low_x <= a.high_x && a.low_y <= b.high_y && b.low_y <= a.high_y;
}

MeetingCounts counts_of(MeetingKind kind) {
  return {.crossing = kind == MeetingKind::cross,
          .touching = kind == MeetingKind::touch,
          .overlap = kind == MeetingKind::overlap};
}

/// For segments whose boxes meet.
IntegerWidth width_of(const std::vector<SlantedSegment>& segments) {
  Reach reach;
  for (const SlantedSegment& s : segments) reach.add({s.dx, s.dy, s.dz});
  return width_of_bits(predicate_bits(reach, kCubeLattice, {}).meeting);
}

std::vector<Keyed> upwards(const std::vector<SlantedSegment>& segments) {
  std::int64_t least = 0;
  for (const SlantedSegment& s : segments) least = std::min(least, s.z);
  std::vector<Keyed> order(segments.size());
  std::vector<Keyed> buffer;
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    order[i] = {static_cast<std::uint64_t>(segments[i].z - least), i};
  }
  sort_by_key(order, buffer);
  return order;
}

}  // namespace

std::optional<MeetingCounts> meetings_of_slanted(const std::vector<SlantedSegment>& segments,
                                                 std::size_t patience) {
  MeetingCounts counts;
  std::vector<Active> reached;
  const IntegerWidth width = width_of(segments);
  std::size_t compared = 0;
  for (const Keyed& next : upwards(segments)) {
    const SlantedSegment& s = segments[next.item];
    const Active added = active(s, next.item);
    compared += reached.size();
    if (compared > patience * segments.size()) return std::nullopt;
    std::size_t kept = 0;
    for (const Active& old : reached) {
      if (old.high < s.z) continue;
      if (overlap(old, added)) {
        const SlantedSegment& t = segments[old.segment];
        counts += counts_of(meeting_kind_in(width, from(s), to(s), from(t), to(t)));
      }
      reached[kept++] = old;
    }
    reached.resize(kept);
    reached.push_back(added);
  }
  return counts;
}

}  // namespace ar3d::verify
