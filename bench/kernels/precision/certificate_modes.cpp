// Certificates that prove nothing, as they were once offered beside the exact one: slower than it
// on all but the smallest drawings, so they are only measured (docs/precision.md). The pairs of
// segments that they look at are those of a search for near pairs (Steps V.12 to V.14).
#include "certificate_modes.h"

#include <fmt/format.h>

#include <unordered_set>

#include "ar3d/base/error.h"
#include "ar3d/base/random.h"
#include "ar3d/verify/certificate.h"
#include "ar3d/verify/checks/checks.h"
#include "ar3d/verify/crossings/near_pairs.h"
#include "ar3d/verify/crossings/segments.h"
#include "ar3d/verify/metrics/metrics.h"
#include "ar3d/verify/predicates/choices.h"
#include "ar3d/verify/predicates/exact.h"

namespace ar3d::precision {
namespace {

using verify::Findings;
using verify::MeetingKind;
using verify::PredicateChoice;
using verify::SegmentId;
using verify::Segments;
using Kind = JudgingMode::Kind;
using NearPairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// A segment; a vertex without edges is one of length zero.
struct Piece {
  Point from;
  Point to;
};

/// A filter decides exactly, and quickly: a sample uses it, too.
const PredicateChoice& predicates_of(const JudgingMode& mode) {
  return verify::predicate_choice(mode.kind == Kind::double_precision ? "double" : "filtered");
}

class ModeJudge {
 public:
  ModeJudge(const Drawing& drawing, const Guarantee& guarantee, const JudgingMode& mode)
      : drawing_(drawing),
        guarantee_(guarantee),
        mode_(mode),
        predicates_(predicates_of(mode)),
        segments_(drawing),
        pieces_(pieces()) {}

  bool keeps_integers(const Graph& graph) const {
    Findings findings(0);
    check_graph(graph, drawing_, findings);
    if (!findings.empty()) return false;
    check_plane(drawing_, guarantee_, findings);
    check_directions(segments_, guarantee_, findings);
    check_distinct_vertices(drawing_, findings);
    return findings.empty();
  }

  bool keeps_angles() const {
    std::vector<std::vector<Point>> stars(drawing_.num_vertices());
    for (SegmentId s = 0; s < segments_.size(); ++s) {
      const Edge ends = drawing_.edge(segments_.edge(s));
      if (!segments_.is_first(s) &&
          !keeps_angle(segments_.from(s - 1), segments_.from(s), segments_.to(s))) {
        return false;
      }
      if (segments_.is_first(s)) stars[ends.u].push_back(segments_.to(s));
      if (segments_.is_last(s)) stars[ends.v].push_back(segments_.from(s));
    }
    for (std::size_t v = 0; v < stars.size(); ++v) {
      const Point at = drawing_.vertex(static_cast<Vertex>(v));
      for (std::size_t i = 0; i < stars[v].size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          if (!keeps_angle(stars[v][i], at, stars[v][j])) return false;
        }
      }
    }
    return true;
  }

  /// Looks at all near pairs, or at a sample.
  void judge_meetings(std::uint64_t seed, ModeVerdict& verdict) const {
    NearPairs pairs = near_pairs();
    if (mode_.kind == Kind::sample && mode_.sample < pairs.size()) {
      verdict.miss_probability =
          1 - static_cast<double>(mode_.sample) / static_cast<double>(pairs.size());
      pairs = sample_of(pairs, seed);
    }
    verdict.accepts = std::all_of(pairs.begin(), pairs.end(), [&](const auto& pair) {
      return keeps_apart(pair.first, pair.second);
    });
  }

 private:
  bool keeps_angle(Point from, Point at, Point to) const {
    const auto order = predicates_.angle(guarantee_.lattice, from, at, to, guarantee_.cosine);
    return guarantee_.angle_rule == AngleRule::exactly ? order == 0 : order <= 0;
  }

  /// The segments, then the vertices without edges.
  std::vector<Piece> pieces() const {
    std::vector<Piece> pieces;
    std::vector<bool> has_edge(drawing_.num_vertices());
    for (SegmentId s = 0; s < segments_.size(); ++s) {
      pieces.push_back({segments_.from(s), segments_.to(s)});
    }
    for (EdgeId e = 0; e < drawing_.num_edges(); ++e) {
      has_edge[drawing_.edge(e).u] = has_edge[drawing_.edge(e).v] = true;
    }
    for (std::size_t v = 0; v < has_edge.size(); ++v) {
      const Point p = drawing_.vertex(static_cast<Vertex>(v));
      if (!has_edge[v]) pieces.push_back({p, p});
    }
    return pieces;
  }

  /// Every pair that meets, and others; smaller numbers first.
  NearPairs near_pairs() const {
    NearPairs pairs;
    verify::for_each_near_pair(
        static_cast<std::uint32_t>(pieces_.size()),
        [&](std::uint32_t i) {
          return verify::SegmentInSpace{pieces_[i].from, pieces_[i].to - pieces_[i].from};
        },
        [&](std::uint32_t i, std::uint32_t j) {
          pairs.emplace_back(std::min(i, j), std::max(i, j));
          return true;
        });
    return pairs;
  }

  /// `mode_.sample` different ones of them, by Floyd's algorithm.
  NearPairs sample_of(const NearPairs& pairs, std::uint64_t seed) const {
    RandomStream random(seed, pairs.size());
    std::unordered_set<std::uint64_t> taken;
    NearPairs sample;
    for (std::uint64_t last = pairs.size() - mode_.sample; last < pairs.size(); ++last) {
      const std::uint64_t number = random.below64(last + 1);
      const std::uint64_t next = taken.contains(number) ? last : number;
      taken.insert(next);
      sample.push_back(pairs[next]);
    }
    return sample;
  }

  bool boxes_meet(std::uint32_t s, std::uint32_t t) const {
    const auto [a, b] = pieces_[s];
    const auto [c, d] = pieces_[t];
    const auto meets = [](std::int64_t p, std::int64_t q, std::int64_t u, std::int64_t v) {
      return std::min(p, q) <= std::max(u, v) && std::min(u, v) <= std::max(p, q);
    };
    return meets(a.x, b.x, c.x, d.x) && meets(a.y, b.y, c.y, d.y) && meets(a.z, b.z, c.z, d.z);
  }

  /// Consecutive on an edge, or end segments at a common vertex: these meet there, and must not
  /// overlap (Lemma V.1).
  bool are_neighbours(SegmentId s, SegmentId t) const {
    if (segments_.edge(s) == segments_.edge(t)) return t == s + 1;
    const Edge a = drawing_.edge(segments_.edge(s)), b = drawing_.edge(segments_.edge(t));
    const auto at = [&](SegmentId segment, const Edge& ends, Vertex v) {
      return (segments_.is_first(segment) && ends.u == v) ||
             (segments_.is_last(segment) && ends.v == v);
    };
    return (segments_.is_first(s) && at(t, b, a.u)) || (segments_.is_last(s) && at(t, b, a.v));
  }

  /// Of two items, s < t.
  bool keeps_apart(std::uint32_t s, std::uint32_t t) const {
    if (s >= segments_.size() || !boxes_meet(s, t)) return true;
    if (t >= segments_.size())
      return !verify::on_segment(pieces_[t].from, pieces_[s].from, pieces_[s].to);
    const MeetingKind kind =
        predicates_.meeting(segments_.from(s), segments_.to(s), segments_.from(t), segments_.to(t));
    return are_neighbours(s, t) ? kind != MeetingKind::overlap : kind == MeetingKind::nothing;
  }

  const Drawing& drawing_;
  const Guarantee& guarantee_;
  const JudgingMode& mode_;
  const PredicateChoice& predicates_;
  const Segments segments_;
  const std::vector<Piece> pieces_;
};

}  // namespace

std::string to_string(const JudgingMode& mode) {
  switch (mode.kind) {
    case Kind::exact:
      return "exact";
    case Kind::filtered:
      return "filtered";
    case Kind::double_precision:
      return "double";
    case Kind::sample:
      return fmt::format("sample={}", mode.sample);
    case Kind::none:
      return "none";
  }
  throw InternalError("no name for a mode");
}

const std::vector<JudgingMode>& judging_modes() {
  static const std::vector<JudgingMode> all = {
      {Kind::exact, 0},   {Kind::filtered, 0},  {Kind::double_precision, 0},
      {Kind::sample, 10}, {Kind::sample, 1000}, {Kind::none, 0}};
  return all;
}

ModeVerdict judge_by_mode(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee,
                          const JudgingMode& mode, std::uint64_t seed) {
  const DrawingSummary summary = measure(drawing);
  if (mode.kind == Kind::none) return {.accepts = true};
  if (mode.kind == Kind::exact) {
    return {.accepts = !certify(graph, drawing, guarantee, {.check_size = false}).violated()};
  }
  ModeVerdict verdict;
  if (summary.repeated_points > 0) return verdict;
  const ModeJudge judge(drawing, guarantee, mode);
  if (judge.keeps_integers(graph) && judge.keeps_angles()) judge.judge_meetings(seed, verdict);
  return verdict;
}

}  // namespace ar3d::precision
