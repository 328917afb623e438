#include "ar3d/verify/modes/mode_verdict.h"

#include <algorithm>
#include <unordered_set>
#include <vector>

#include "ar3d/base/random.h"
#include "ar3d/verify/checks/checks.h"
#include "ar3d/verify/checks/exact.h"
#include "ar3d/verify/crossings/segments.h"
#include "ar3d/verify/modes/candidate_pairs.h"
#include "ar3d/verify/predicates/choices.h"

namespace ar3d::verify {
namespace {

/// A filter decides exactly, and quickly: a sample uses it, too.
const PredicateChoice& predicates_of(const CertificateMode& mode) {
  return predicate_choice(mode.kind == CertificateMode::Kind::double_precision ? "double"
                                                                               : "filtered");
}

class ModeJudge {
 public:
  ModeJudge(const Drawing& drawing, const Guarantee& guarantee, const CertificateMode& mode)
      : drawing_(drawing),
        guarantee_(guarantee),
        mode_(mode),
        predicates_(predicates_of(mode)),
        segments_(drawing),
        items_(items()) {}

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

  /// Looks at all candidate pairs, or at a sample.
  void judge_meetings(std::uint64_t seed, ModeVerdict& verdict) const {
    const CandidatePairs pairs(items_);
    verdict.candidate_pairs = pairs.size();
    verdict.accepts = true;
    const auto keeps = [&](std::uint32_t i, std::uint32_t j) {
      return verdict.accepts = keeps_apart(i, j);
    };
    if (mode_.kind != CertificateMode::Kind::sample || mode_.sample >= pairs.size()) {
      return pairs.for_each(keeps);
    }
    verdict.miss_probability =
        1 - static_cast<double>(mode_.sample) / static_cast<double>(pairs.size());
    for (const std::uint64_t number : sample(pairs.size(), seed)) {
      const auto [i, j] = pairs[number];
      if (!keeps(i, j)) return;
    }
  }

 private:
  bool keeps_angle(Point from, Point at, Point to) const {
    const auto order = predicates_.angle(guarantee_.lattice, from, at, to, guarantee_.cosine);
    return guarantee_.angle_rule == AngleRule::exactly ? order == 0 : order <= 0;
  }

  /// The segments, then the vertices without edges.
  std::vector<Item> items() const {
    std::vector<Item> items;
    std::vector<bool> has_edge(drawing_.num_vertices());
    for (SegmentId s = 0; s < segments_.size(); ++s) {
      items.push_back({segments_.from(s), segments_.to(s)});
    }
    for (EdgeId e = 0; e < drawing_.num_edges(); ++e) {
      has_edge[drawing_.edge(e).u] = has_edge[drawing_.edge(e).v] = true;
    }
    for (std::size_t v = 0; v < has_edge.size(); ++v) {
      const Point p = drawing_.vertex(static_cast<Vertex>(v));
      if (!has_edge[v]) items.push_back({p, p});
    }
    return items;
  }

  /// Floyd's algorithm: `mode_.sample` different numbers below `size`.
  std::vector<std::uint64_t> sample(std::uint64_t size, std::uint64_t seed) const {
    RandomStream random(seed, size);
    std::unordered_set<std::uint64_t> taken;
    std::vector<std::uint64_t> numbers;
    for (std::uint64_t last = size - mode_.sample; last < size; ++last) {
      const std::uint64_t number = random.below64(last + 1);
      numbers.push_back(taken.insert(number).second ? number : last);
      taken.insert(numbers.back());
    }
    return numbers;
  }

  bool boxes_meet(std::uint32_t s, std::uint32_t t) const {
    const auto [a, b] = items_[s];
    const auto [c, d] = items_[t];
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
    if (t >= segments_.size()) return !on_segment(items_[t].from, items_[s].from, items_[s].to);
    const MeetingKind kind =
        predicates_.meeting(segments_.from(s), segments_.to(s), segments_.from(t), segments_.to(t));
    return are_neighbours(s, t) ? kind != MeetingKind::overlap : kind == MeetingKind::nothing;
  }

  const Drawing& drawing_;
  const Guarantee& guarantee_;
  const CertificateMode& mode_;
  const PredicateChoice& predicates_;
  const Segments segments_;
  const std::vector<Item> items_;
};

}  // namespace

ModeVerdict judge_by_mode(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee,
                          const CertificateMode& mode, std::uint64_t seed) {
  ModeVerdict verdict;
  const ModeJudge judge(drawing, guarantee, mode);
  if (judge.keeps_integers(graph) && judge.keeps_angles()) judge.judge_meetings(seed, verdict);
  return verdict;
}

}  // namespace ar3d::verify
