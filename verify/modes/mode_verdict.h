#pragma once

#include <cstdint>

#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"
#include "ar3d/model/guarantee.h"
#include "ar3d/verify/certificate_mode.h"

namespace ar3d::verify {

/// What a mode other than exact says of a drawing.
struct ModeVerdict {
  bool accepts = false;
  std::uint64_t candidate_pairs = 0;  ///< that might meet; counted in every cell that they share
  /// Of a sample: at most the probability that one forbidden meeting, if it is the only thing that
  /// is wrong, is not among the pairs looked at, over the choice of these. 0: all were.
  double miss_probability = 0;
};

/// Judges graph, directions, plane, distinct vertices, angles and meetings as the mode says: angles
/// and meetings in its arithmetic, the others, which only compare integers, exactly. Lattice, range
/// of the coordinates, bends and box are judged elsewhere.
/// @pre every coordinate is in range and no segment has length zero. @param seed  of the sample.
/// @throws InputError as CandidatePairs. Cost: CandidatePairs, and a decision for each angle and
/// each candidate pair, or each of the sample, whose boxes meet.
ModeVerdict judge_by_mode(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee,
                          const CertificateMode& mode, std::uint64_t seed);

}  // namespace ar3d::verify
