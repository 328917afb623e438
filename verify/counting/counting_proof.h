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
#include "ar3d/verify/counting/plane_counts.h"
#include "ar3d/verify/counting/plane_records.h"
#include "ar3d/verify/counting/signed_directions.h"
#include "ar3d/verify/metrics/metrics.h"
#include "ar3d/verify/predicates/widths.h"

namespace ar3d::verify {

/// Proves a drawing of few directions right by counting the meetings of its segments, in one pass
/// over the polylines; if that takes more memory than sizes.memory, in one more pass for each
/// window of planes of each pair of directions. It never says what is wrong: a drawing that it does
/// not prove is wrong or passes one of its limits (only directions that the guarantee names, at
/// most 16 of components below 2^20, coordinates below 2^30 and such that all functionals fit 32
/// bits, degree at most 4).
///
/// Several threads may pass over the edges, and count in several windows at a time. The verdict and
/// all counts are the same for any number of them.
///
/// Memory: 4 bytes per vertex; 16 bytes per segment and per point of Lemma V.3 and up to 10 more for
/// the records of windows at a time; with a limit 16 for each record of these windows, which the
/// limit holds unless one plane passes it.
class CountingProof {
 public:
  CountingProof(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee,
                const CountingSizes& sizes = {});

  /// An edge of the drawing and its polyline: every edge once. @param thread  of sizes.threads that
  /// may call this at the same time, each with another number.
  void add(Edge ends, const std::vector<Point>& points, std::uint32_t thread = 0) {
    Share& share = shares_[thread];
    if (share.possible) share.possible = take_edge(share, ends, points);
  }
  /// After the last edge: true if the graph is drawn, all angles, directions and the plane of the
  /// vertices are as promised, and nothing meets that must not. Bends, lattice and box are judged
  /// elsewhere. @param summary  of the drawing.
  bool holds(const DrawingSummary& summary);
  /// The counts of holds(), as far as it came.
  const CountedMeetings& counts() const { return counts_; }

 private:
  static constexpr std::size_t kIds = 2 * SignedDirections::kMaxIndices;

  /// Holds what a thread has of the edges and vertices that it took, in cache lines of its own.
  struct alignas(128) Share {
    bool possible = true;
    std::array<PlacedSegments, SignedDirections::kMaxIndices> segments;
    std::array<std::uint64_t, SignedDirections::kMaxIndices> numbers{};  ///< of segments
    std::array<std::array<std::int8_t, kIds>, kIds> angles{};  ///< 1: right, -1: wrong, 0: not seen
    std::uint64_t crossing_neighbours = 0;
    /// Vertices and ids, of which the first `left` are not in stars_ yet.
    std::array<std::pair<Vertex, std::uint8_t>, 64> leaving;
    std::size_t left = 0;
  };
  /// Two directions, and in which planes to count.
  struct Task {
    PlaneFamily family;
    std::array<std::size_t, 2> directions;
    PlaneWindow window;
  };

  bool take_edge(Share& share, Edge ends, const std::vector<Point>& points);
  bool leave(Share& share, Vertex v, std::uint8_t id);
  bool leave_all(Share& share);
  bool take_leaving(Vertex v, std::uint8_t id);
  bool angle_is_kept(Share& share, std::size_t id, std::size_t other) const;
  bool take_neighbours(Share& share, std::size_t id, std::size_t other) const;
  void take_point(Share& share, std::size_t direction, Point p, std::size_t neighbours) const;
  bool take_vertices(Share& share, Vertex begin, Vertex end);
  void take_all_vertices();
  bool take_star(Share& share, std::uint32_t star) const;
  bool collect_shares();
  std::uint64_t number(std::size_t direction) const;
  std::uint32_t windows(std::uint64_t records) const;
  bool plan_tasks(std::int64_t largest, std::vector<Task>& tasks) const;
  bool take_families(std::int64_t largest);
  std::uint64_t count(const Task& task, PlaneMeetings& meetings) const;
  void add_stored(const Task& task, const PlaneMeetings::Intake& intake) const;
  void add_computed(const Task& task, const PlaneMeetings::Intake& intake) const;

  const Graph& graph_;
  const Drawing& drawing_;
  const Guarantee& guarantee_;
  CountingSizes sizes_;
  bool possible_;
  const bool keeps_segments_;     ///< false: there are too many, they are computed for each window
  SignedDirections directions_;   ///< two at least
  std::size_t promised_ids_ = 0;  ///< of the guarantee's directions
  std::vector<Share> shares_;     ///< of the threads
  /// Holds of each vertex the directions in which edges leave it: up to four bytes, id + 1 each.
  std::vector<std::uint32_t> stars_;
  CountedMeetings counts_;
};

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
