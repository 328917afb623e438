// Judges a drawing in a real type: every angle is compared with 120 degrees by exact inner
// products, and only the reported miss is rounded.
#include "ar3d/verify/assessment/real_assessment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ar3d/base/error.h"
#include "ar3d/model/real_points.h"
#include "ar3d/verify/assessment/real_segments.h"

namespace ar3d {
namespace {

using verify::BigVector;
using verify::RealSegment;

void require_fitting(const Graph& graph, const RealPoints& points) {
  if (points.vertices.size() != graph.num_vertices() ||
      points.offsets.size() != std::size_t{graph.num_edges()} + 1) {
    throw InputError(
        fmt::format("a drawing of {} vertices and {} edges, but the graph has {} and {}",
                    points.vertices.size(), points.offsets.size() - 1, graph.num_vertices(),
                    graph.num_edges()));
  }
}

/// A side of an angle: a segment, seen from one of its ends.
struct Leg {
  const RealSegment* segment = nullptr;
  bool from_its_end = false;

  BigVector direction() const {
    const BigVector d = segment->to - segment->from;
    return from_its_end ? -d : d;
  }
};

class Assessor {
 public:
  Assessor(const Graph& graph, const RealPoints& points)
      : graph_(graph), points_(points), segments_(verify::segments_of(graph, points)) {}

  RealAssessment run() {
    count_bends();
    judge_bends();
    result_.collapsed = graph_.num_edges() + points_.bends.size() - result_.segments;
    judge_vertices();
    if (result_.angles > 0) result_.mean_square_miss /= static_cast<double>(result_.angles);
    result_.crossings = verify::count_crossings(graph_, segments_, points_.unit_exponent);
    return result_;
  }

 private:
  void count_bends() {
    for (EdgeId e = 0; e < graph_.num_edges(); ++e) {
      const std::size_t bends = points_.bends_of(e).size();
      if (result_.bend_histogram.size() <= bends) result_.bend_histogram.resize(bends + 1);
      ++result_.bend_histogram[bends];
    }
  }

  void judge_bends() {
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      if (segments_[i].is_vertex) continue;
      ++result_.segments;
      if (segments_[i].is_first) continue;
      judge({&segments_[i - 1], true}, {&segments_[i], false}, false, result_.smallest_bend_angle);
    }
  }

  void judge_vertices() {
    std::vector<std::vector<Leg>> legs(graph_.num_vertices());
    for (const RealSegment& segment : segments_) {
      if (segment.is_vertex) continue;
      const Edge ends = graph_.edge(segment.edge);
      if (segment.is_first) legs[ends.u].push_back({&segment, false});
      if (segment.is_last) legs[ends.v].push_back({&segment, true});
    }
    for (Vertex v = 0; v < graph_.num_vertices(); ++v) {
      for (std::size_t i = 0; i < legs[v].size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          judge(legs[v][i], legs[v][j], graph_.degree(v) == 3, result_.smallest_vertex_angle);
        }
      }
    }
  }

  void judge(Leg a, Leg b, bool exactly, double& smallest) {
    const double missing = verify::short_of_120(a.direction(), b.direction());
    const double miss = exactly || missing > 0 ? std::abs(missing) : 0;
    smallest = std::fmin(smallest, 120 - missing);
    ++result_.angles;
    result_.largest_miss = std::max(result_.largest_miss, miss);
    result_.mean_square_miss += miss * miss;
    for (std::size_t i = 0; i < RealAssessment::kLimits.size(); ++i) {
      result_.within[i] += miss <= RealAssessment::kLimits[i] ? 1 : 0;
    }
    result_.condition = std::max(result_.condition, sensitivity(a) + sensitivity(b));
  }

  double sensitivity(Leg leg) const {
    const int unit = points_.unit_exponent;
    double largest = 0;
    for (const BigPoint* end : {&leg.segment->from, &leg.segment->to}) {
      for (const double c : verify::rounded(*end, unit)) largest = std::max(largest, std::abs(c));
    }
    const verify::RoundedPoint d = verify::rounded(leg.direction(), unit);
    return largest / std::hypot(d[0], d[1], d[2]);
  }

  const Graph& graph_;
  const RealPoints& points_;
  const std::vector<RealSegment> segments_;
  RealAssessment result_;
};

}  // namespace

RealAssessment assess(const Graph& graph, const RealPoints& points) {
  require_fitting(graph, points);
  return Assessor(graph, points).run();
}

}  // namespace ar3d
