#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"
#include "ar3d/model/guarantee.h"
#include "ar3d/verify/violation.h"

namespace ar3d {

/// All tests decide exactly and find the same violations.
enum class CrossingTest {
  automatic,  ///< the proof by counting, and halving for what it does not prove
  all_pairs,  ///< the oracle: every pair of segments, O(S^2)
  halving,    ///< space is halved; segments of a small cell are compared
};

struct CertifyOptions {
  CrossingTest crossing_test = CrossingTest::automatic;
  std::size_t max_violations = 100;  ///< stop collecting there
  bool check_size = true;
  CertificateMode mode = CertificateMode::exact;
  /// Most bytes of segments that the proof by counting stores at a time; 0: no limit. Less memory
  /// takes more passes over the polylines; the verdict is the same.
  std::uint64_t proof_bytes = 0;
  /// Holds how many pairs of segments and vertices the crossing test may compare before it gives
  /// up; 0: as many as it takes. With a limit there is no proof by counting.
  std::uint64_t most_comparisons = 0;
  /// Gets the number of pairs that a long crossing test may compare; may be empty.
  std::function<void(std::uint64_t pairs)> compares = {};
};

/// Holds after how many comparisons of pairs every crossing test but the oracle gives up.
inline constexpr std::uint64_t kMostComparisons = 20'000'000'000;

/// The verdict on one drawing: proved right iff valid().
struct Certificate {
  /// The drawing was made in a real type and is not held to its angles, crossings and box: what it
  /// misses is measured (RealAssessment). Never valid.
  bool measured = false;
  CertificateMode mode = CertificateMode::exact;  ///< with none there is a box, and no verdict
  std::vector<Violation> violations;
  bool complete = false;  ///< false until judged, when max_violations cut the list, or a coordinate
                          ///< is out of range
  bool given_up = false;  ///< too many comparisons: crossings were not all looked for
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
/// why not. Shares no code with the algorithms. Cost: O(S log S) for a right drawing of S segments
/// with few directions.
Certificate certify(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee,
                    const CertifyOptions& options = {});

}  // namespace ar3d
