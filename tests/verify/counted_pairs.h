#pragma once

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "ar3d/verify/certificate.h"
#include "ar3d/verify/counting/plane_records.h"
#include "ar3d/verify/crossings/contacts.h"
#include "ar3d/verify/metrics/metrics.h"
#include "ar3d/verify/predicates/exact.h"
#include "verify/draft.h"

// What the tests of both proofs by counting share.

namespace ar3d::testing {

/// Without edges drawn twice and loops: what is left draws a simple graph.
inline Draft simple(Draft draft) {
  std::set<std::pair<Vertex, Vertex>> seen;
  std::erase_if(draft.edges, [&](const Draft::DraftEdge& edge) {
    const auto [u, v] = edge.ends;
    return u == v || !seen.emplace(std::min(u, v), std::max(u, v)).second;
  });
  return draft;
}

/// Without the vertices that no edge ends at.
inline Draft without_isolated(Draft draft) {
  std::vector<Vertex> number(draft.vertices.size(), ~Vertex{0});
  std::vector<Point> kept;
  for (auto& edge : draft.edges) {
    for (Vertex* end : {&edge.ends.u, &edge.ends.v}) {
      if (number[*end] == ~Vertex{0}) {
        number[*end] = static_cast<Vertex>(kept.size());
        kept.push_back(draft.vertices[*end]);
      }
      *end = number[*end];
    }
  }
  draft.vertices = std::move(kept);
  return draft;
}

/// Degrees up to 4 and no segment of length zero: what both proofs take.
inline bool has_low_degrees(const Draft& draft) {
  std::vector<int> degrees(draft.vertices.size());
  for (const auto& edge : draft.edges) ++degrees[edge.ends.u], ++degrees[edge.ends.v];
  return std::all_of(degrees.begin(), degrees.end(), [](int d) { return d <= 4; }) &&
         measure(draft.drawing()).repeated_points == 0;
}

/// The oracle of the verdicts: every pair of segments.
inline bool is_valid(const Draft& draft, const Guarantee& guarantee = no_promise()) {
  return certify(draft.graph(), draft.drawing(), guarantee,
                 {.crossing_test = CrossingTest::all_pairs, .check_size = false})
      .valid();
}

/// What a proof by counting says of a drawing.
struct CountingOutcome {
  bool proved;
  verify::CountedMeetings counts;
  friend bool operator==(const CountingOutcome&, const CountingOutcome&) = default;
};

/// What the comparisons of outcomes with the oracle covered.
struct Tally {
  int valid = 0;
  int invalid = 0;
  int counted = 0;  ///< outcomes whose counts were compared
  int more_meetings = 0;
};

/// The oracle of the counts: every pair of segments.
inline verify::MeetingCounts count_all_pairs(const verify::Segments& segments) {
  verify::MeetingCounts counts;
  for (verify::SegmentId s = 0; s < segments.size(); ++s) {
    for (verify::SegmentId t = 0; t < s; ++t) {
      const auto meeting =
          verify::meet(segments.from(s), segments.to(s), segments.from(t), segments.to(t));
      const bool is_parallel = verify::parallel(segments.direction(s), segments.direction(t));
      if (meeting.kind == verify::MeetingKind::nothing) continue;
      if (meeting.kind == verify::MeetingKind::overlap) {
        counts.overlap = true;
      } else {
        ++(is_parallel ? counts.touching : counts.crossing);
      }
    }
  }
  return counts;
}

}  // namespace ar3d::testing
