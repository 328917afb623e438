#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"
#include "ar3d/model/guarantee.h"
#include "ar3d/verify/counting/counted_meetings.h"
#include "ar3d/verify/counting/plane_counts.h"
#include "ar3d/verify/counting/signed_directions.h"
#include "ar3d/verify/metrics.h"

namespace ar3d::verify {

/// Proves a drawing of few directions right by counting the meetings of its segments, in one pass
/// over the polylines; if that takes more memory than sizes.memory, in one more pass for each
/// window of planes of each pair of directions. It never says what is wrong: a drawing that it does
/// not prove is wrong or passes one of its limits (at most 16 directions of components below 2^20,
/// coordinates below 2^30 and such that all functionals fit 32 bits, degree at most 4). Memory: 4
/// bytes per vertex, and 16 bytes per segment and 16 for each segment of two directions; with a
/// limit 32 for each segment of a window, which the limit holds unless one plane passes it.
class CountingProof {
 public:
  CountingProof(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee,
                const CountingSizes& sizes = {});

  /// An edge of the drawing and its polyline: every edge once.
  void add(Edge ends, const std::vector<Point>& points) {
    if (possible_) possible_ = take_edge(ends, points);
  }
  /// After the last edge: true if the graph is drawn, all angles, directions and the plane of the
  /// vertices are as promised, and nothing meets that must not. Bends, lattice and box are judged
  /// elsewhere. @param summary  of the drawing.
  bool holds(const DrawingSummary& summary);
  /// The counts of holds(), as far as it came.
  const CountedMeetings& counts() const { return counts_; }

 private:
  enum class Angle : std::uint8_t { unknown, right, wrong };
  static constexpr std::size_t kIds = 2 * SignedDirections::kMaxIndices;

  bool take_edge(Edge ends, const std::vector<Point>& points);
  bool store(Point from, Point to, SignedDirections::Found found);
  bool leave(Vertex v, std::uint8_t id);
  bool right_angle(std::size_t id, std::size_t other);
  bool take_neighbours(std::size_t id, std::size_t other);
  bool take_vertices();
  bool take_star(std::uint32_t star);
  bool allowed_directions() const;
  bool take_families(std::int64_t largest);
  void count_family(const PlaneFamily& family, std::size_t i, std::size_t j, LinesToCount lines,
                    PlaneMeetings& meetings);
  /// The segments of the directions i and j whose planes are in a window.
  std::array<PlacedSegments, 2> window(const PlaneFamily& family, std::size_t i, std::size_t j,
                                       std::uint64_t number, std::uint64_t count);

  const Graph& graph_;
  const Drawing& drawing_;
  const Guarantee& guarantee_;
  CountingSizes sizes_;
  bool possible_;
  SignedDirections directions_;
  const bool keeps_segments_;  ///< false: there are too many, they are computed for each window
  std::array<PlacedSegments, SignedDirections::kMaxIndices> segments_;
  std::array<std::uint64_t, SignedDirections::kMaxIndices> numbers_{};  ///< of segments
  std::array<std::array<Angle, kIds>, kIds> angles_{};
  /// Of each vertex the directions in which edges leave it: up to four bytes, id + 1 each.
  std::vector<std::uint32_t> stars_;
  CountedMeetings counts_;
};

}  // namespace ar3d::verify
