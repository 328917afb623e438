#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"
#include "ar3d/model/guarantee.h"

namespace ar3d {

enum class ViolationKind {
  vertex_count,        ///< the drawing has another number of vertices than the graph
  edge_set,            ///< an edge is missing, extra, or drawn twice
  lattice,             ///< the drawing's Gram matrix is not the guarantee's
  coordinate_range,    ///< a coordinate passes kMaxCoordinate; such a drawing is judged no further
  plane,               ///< a vertex is not in the plane z = 0 although promised
  degenerate_segment,  ///< two consecutive points of an edge coincide
  direction,           ///< a segment is not parallel to an allowed direction
  bends,               ///< an edge has too many bends
  bend_angle,          ///< consecutive segments of an edge meet at a wrong angle
  vertex_angle,        ///< two segments leave a vertex at a wrong angle
  same_point,          ///< two vertices coincide
  vertex_on_edge,      ///< a vertex lies on an edge that does not end there
  crossing,            ///< two segments share a point that is not a common end of theirs
  size,                ///< an extent passes the bound
};
/// "crossing", "vertex_on_edge", …
const char* to_string(ViolationKind kind);

/// One violation, with everything needed to look at it.
struct Violation {
  ViolationKind kind{};
  std::vector<Vertex> vertices;
  std::vector<EdgeId> edges;  ///< numbers of the drawing's edges
  std::vector<Point> points;  ///< exact places
  std::string message;        ///< one line
};

/// All tests decide exactly and find the same violations.
enum class CrossingTest {
  automatic,    ///< the plane sweep if the drawing has few directions, else slabs
  all_pairs,    ///< the oracle: every pair of segments, O(S^2)
  plane_sweep,  ///< lines and plane families, O(S log S); refuses drawings with many directions
  slabs,        ///< space halved in slabs that nothing crosses: for any directions
};

/// How a drawing is judged: by a proof in integers, or not at all.
enum class CertificateMode : std::uint8_t { exact, none };
/// "exact", "none".
std::string to_string(CertificateMode mode);
/// @throws InputError naming the text if it is neither.
CertificateMode parse_certificate_mode(std::string_view text);

struct CertifyOptions {
  CrossingTest crossing_test = CrossingTest::automatic;
  std::size_t max_violations = 100;  ///< stop collecting there
  bool check_size = true;
  CertificateMode mode = CertificateMode::exact;
  /// Most bytes of segments that the proof by counting stores at a time; 0: no limit. Less memory
  /// takes more passes over the polylines; the verdict is the same.
  std::uint64_t proof_bytes = 0;
  /// How many pairs of segments and vertices the crossing test may compare before it gives up; 0:
  /// as many as it takes. With a limit there is no proof by counting.
  std::uint64_t most_comparisons = 0;
};

/// The verdict on one drawing: proved right iff valid().
struct Certificate {
  /// The drawing was made in a real type and is not held to its angles, crossings and box: what it
  /// misses is measured (RealAssessment). Never valid.
  bool measured = false;
  CertificateMode mode = CertificateMode::exact;  ///< with none there is a box, and no verdict
  std::vector<Violation> violations;
  bool complete = false;  ///< false until judged, when max_violations cut the list, or a coordinate
                          ///< is out of range
  bool given_up = false;  ///< most_comparisons were too few: crossings were not all looked for
  Box box;                ///< of all vertices and bends; the origin if a coordinate is out of range
  std::vector<std::uint64_t> bend_histogram;  ///< entry b: number of edges with b bends
  std::uint64_t segments = 0;
  bool valid() const {
    return complete && violations.empty() && !measured && mode == CertificateMode::exact;
  }
  /// Proved wrong, or not judged to the end.
  bool violated() const { return !complete || !violations.empty(); }
};

/// Proves in exact integers that `drawing` is a drawing of `graph` that keeps `guarantee`, or says
/// why not. Shares no code with the algorithms. Cost: O(S
/// log S) for S segments with few directions.
Certificate certify(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee,
                    const CertifyOptions& options = {});

}  // namespace ar3d
