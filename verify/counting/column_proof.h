#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"
#include "ar3d/model/guarantee.h"
#include "ar3d/verify/counting/columns.h"
#include "ar3d/verify/counting/plane_records.h"
#include "ar3d/verify/counting/signed_directions.h"
#include "ar3d/verify/metrics/metrics.h"
#include "ar3d/verify/predicates/widths.h"

namespace ar3d::verify {

/// Proves a drawing of any directions right by counting the meetings of its segments, as
/// CountingProof does for few of them: quickest where long segments are vertical. It never says
/// what is wrong: a drawing that it does not prove is wrong or passes one of its limits (x and y
/// below 2^30 in absolute value, degree at most 4).
/// Memory: 24 bytes per vertical segment, 32 per slanted one, 4 per vertex; about 65 and 32 more
/// per segment while they are counted.
class ColumnProof {
 public:
  /// @param patience  comparisons of slanted segments that each of them may cost before space is
  ///   halved instead.
  ColumnProof(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee,
              std::size_t patience = 16);

  /// An edge of the drawing and its polyline: every edge once.
  void add(Edge ends, const std::vector<Point>& points) {
    if (possible_) possible_ = take_edge(ends, points);
  }
  /// After the last edge: true if the graph is drawn, all angles, directions and the plane of the
  /// vertices are as promised, and nothing meets that must not. Bends, lattice and box are judged
  /// elsewhere.
  bool holds();
  /// The counts of holds(), as far as it came.
  const CountedMeetings& counts() const { return counts_; }

 private:
  /// The direction of a segment, and its number if it is a small one.
  struct Heading {
    Vector d;
    std::optional<std::uint8_t> number;
    Heading reversed() const;
  };

  static Heading heading(Vector d);
  bool take_edge(Edge ends, const std::vector<Point>& points);
  bool store(Point from, Point to);
  bool leave(Vertex v, const Heading& heading);
  bool angle_is_kept(const Heading& a, const Heading& b);
  bool take_neighbours(const Heading& a, const Heading& b);
  bool take_vertices();
  bool take_star(Vertex v, std::size_t& next_other);
  bool count_meetings();

  const Graph& graph_;
  const Drawing& drawing_;
  const Guarantee& guarantee_;
  const std::size_t patience_;
  const AngleComparison compare_cosine_;
  bool possible_;
  std::vector<VerticalSegment> verticals_;
  std::vector<SlantedSegment> slanted_;
  /// Holds for small directions 1 if their angle is right, -1 if it is wrong, 0 if it was not seen
  /// yet.
  std::array<std::array<std::int8_t, kSmallDirections>, kSmallDirections> angles_{};
  /// Holds of each vertex the directions in which edges leave it: up to four bytes, number + 1
  /// each, or kOther for one of others_.
  std::vector<std::uint32_t> stars_;
  std::vector<std::pair<Vertex, Vector>> others_;
  CountedMeetings counts_;
};

}  // namespace ar3d::verify
