// Gathers what metrics need, polyline by polyline. Doubles are added in the order of edges, so the
// same drawing gives the same bits.
#include "ar3d/verify/metrics/summary_pass.h"

#include <cmath>

namespace ar3d::verify {

SummaryPass::SummaryPass(const Drawing& drawing, bool lengths)
    : drawing_(drawing), lengths_(lengths) {
  add_vertices(0, static_cast<Vertex>(drawing.num_vertices()));
  if (lengths_) summary_.total_edge_length = summary_.longest_edge_length = 0;
}

void SummaryPass::add_vertices(Vertex begin, Vertex end) {
  for (Vertex v = begin; v < end; ++v) box_.add(drawing_.vertex(v));
}

void SummaryPass::add(const std::vector<Point>& points) {
  const std::size_t bends = points.size() - 2;
  if (bends >= summary_.bend_histogram.size()) summary_.bend_histogram.resize(bends + 1);
  ++summary_.bend_histogram[bends];
  summary_.segments += points.size() - 1;
  GrowingBox box = box_;  // has the vertices
  for (std::size_t i = 1; i <= bends; ++i) box.add(points[i]);
  box_ = box;
  for (std::size_t i = 1; i < points.size(); ++i) {
    summary_.repeated_points += points[i] == points[i - 1];
  }
  if (lengths_ && in_range()) add_lengths(points);  // else differences might not fit
}

void SummaryPass::absorb(const SummaryPass& other) {
  const auto& theirs = other.summary_.bend_histogram;
  auto& ours = summary_.bend_histogram;
  if (ours.size() < theirs.size()) ours.resize(theirs.size());
  for (std::size_t bends = 0; bends < theirs.size(); ++bends) ours[bends] += theirs[bends];
  summary_.segments += other.summary_.segments;
  summary_.repeated_points += other.summary_.repeated_points;
  if (other.box_.low().x > other.box_.high().x) return;  // it took nothing
  box_.add(other.box_.low());
  box_.add(other.box_.high());
}

void SummaryPass::add_lengths(const std::vector<Point>& points) {
  const Lattice lattice = drawing_.lattice();  // a copy: looked at once for all segments
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    length += approximate_length(lattice, points[i] - points[i - 1]);
  }
  summary_.total_edge_length += length;
  summary_.longest_edge_length = std::max(summary_.longest_edge_length, length);
}

DrawingSummary SummaryPass::finish() {
  summary_.segments -= summary_.repeated_points;
  summary_.in_range = drawing_.num_vertices() == 0 || in_range();
  if (summary_.in_range) {
    summary_.box = box_.box();
  } else {
    summary_.total_edge_length = summary_.longest_edge_length = DrawingSummary::kNone;
  }
  if (!lengths_) return summary_;
  drawing_.lattice().validate();
  const auto pair = summary_.in_range ? closest_pair(drawing_) : std::nullopt;
  if (pair) {
    const auto [u, v] = *pair;
    summary_.smallest_vertex_distance =
        approximate_length(drawing_.lattice(), drawing_.vertex(u) - drawing_.vertex(v));
    set_relative_volume();
  }
  return summary_;
}

void SummaryPass::set_relative_volume() {
  if (!(summary_.smallest_vertex_distance > 0)) return;
  const std::array<std::int64_t, 3> extents = summary_.box.extents();
  const std::array<Vector, 3> sides{Vector{extents[0], 0, 0}, Vector{0, extents[1], 0},
                                    Vector{0, 0, extents[2]}};
  summary_.log2_relative_volume = 0;
  for (const Vector side : sides) {
    const double length = approximate_length(drawing_.lattice(), side);
    summary_.log2_relative_volume += std::log2(length / summary_.smallest_vertex_distance + 1);
  }
}

}  // namespace ar3d::verify
