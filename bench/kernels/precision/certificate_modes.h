#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"
#include "ar3d/model/guarantee.h"

namespace ar3d::precision {

/// Holds how a drawing may be judged. Only `exact` proves; the others are how most programs judge,
/// and are here to be measured beside it.
struct JudgingMode {
  enum class Kind : std::uint8_t {
    exact,     ///< certify()
    filtered,  ///< angles and meetings in double where the error's bound decides, else exact
    double_precision,  ///< angles and meetings in double, rounded
    sample,            ///< angles exact, meetings of `sample` near pairs of segments exact
    none,              ///< nothing is judged
  };
  Kind kind = Kind::exact;
  std::uint64_t sample = 0;  ///< near pairs that are looked at, drawn without replacement
};

/// "exact", "filtered", "double", "sample=1000", "none".
std::string to_string(const JudgingMode& mode);

/// Returns the modes that are measured.
const std::vector<JudgingMode>& judging_modes();

/// Holds what a mode says of a drawing.
struct ModeVerdict {
  bool accepts = false;
  /// Of a sample: at most the probability that one forbidden meeting, if it is the only thing that
  /// is wrong, is not among the pairs looked at, over the choice of these. 0: all were.
  double miss_probability = 0;
};

/// Judges graph, directions, plane, distinct vertices, angles and meetings as the mode says: angles
/// and meetings in its arithmetic, the others, which only compare integers, exactly. Box and number
/// of bends are not judged, but by `exact`. @param seed  of the sample.
/// @pre every coordinate is in range.
ModeVerdict judge_by_mode(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee,
                          const JudgingMode& mode, std::uint64_t seed);

}  // namespace ar3d::precision
