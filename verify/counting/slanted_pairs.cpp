// Steps V.11 to V.14 of docs/verify.md. Where long segments are vertical, few of the others are at
// one height, and nearly all of these have boxes apart. Where they are not, space is halved: too
// many are at one height to compare all pairs of them.
#include <algorithm>
#include <tuple>

#include "ar3d/verify/counting/columns.h"
#include "ar3d/verify/crossings/near_pairs.h"
#include "ar3d/verify/crossings/radix_sort.h"
#include "ar3d/verify/predicates/exact.h"
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

/// Step V.11; nothing if it runs out of patience.
std::optional<MeetingCounts> meetings_upwards(const std::vector<SlantedSegment>& segments,
                                              IntegerWidth width, std::size_t patience) {
  MeetingCounts counts;
  std::vector<Active> reached;
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

/// Steps V.12 to V.14. Pairs that meet are found again in every cell that they share.
/// @return nothing if there are more than a right drawing can have: neighbours in at most 3 bends
/// and vertices at either end.
std::optional<MeetingCounts> meetings_by_halving(const std::vector<SlantedSegment>& segments,
                                                 IntegerWidth width) {
  const std::size_t most = 8 * segments.size() + 1000;
  std::vector<std::tuple<std::uint32_t, std::uint32_t, MeetingKind>> pairs;  // the lower one first
  const auto drop_repeated = [&] {
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  };
  const auto at = [&](std::uint32_t i) {
    const SlantedSegment& s = segments[i];
    return SegmentInSpace{from(s), {s.dx, s.dy, s.dz}};
  };
  bool too_many = false;
  const auto visit = [&](std::uint32_t i, std::uint32_t j) {
    const SlantedSegment& s = segments[i];
    const SlantedSegment& t = segments[j];
    const MeetingKind kind = meeting_kind_in(width, from(s), to(s), from(t), to(t));
    if (kind == MeetingKind::nothing) return true;
    pairs.emplace_back(std::min(i, j), std::max(i, j), kind);
    if (pairs.size() < 2 * most) return true;
    drop_repeated();
    too_many = pairs.size() >= most;
    return !too_many;
  };
  for_each_near_pair(static_cast<std::uint32_t>(segments.size()), at, visit);
  if (too_many) return std::nullopt;
  drop_repeated();
  MeetingCounts counts;
  for (const auto& [low, high, kind] : pairs) counts += counts_of(kind);
  return counts;
}

}  // namespace

std::optional<MeetingCounts> meetings_of_slanted(const std::vector<SlantedSegment>& segments,
                                                 std::size_t patience) {
  const IntegerWidth width = width_of(segments);
  const auto counts = meetings_upwards(segments, width, patience);
  return counts ? counts : meetings_by_halving(segments, width);
}

}  // namespace ar3d::verify
