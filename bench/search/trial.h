#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "ar3d/bench/search/seeded_fault.h"
#include "ar3d/bench/spec/study_spec.h"
#include "ar3d/model/drawing.h"

namespace ar3d {

/// What is tried on one graph after the other: an algorithm with complete options, and a fault if
/// one is seeded.
struct Subject {
  AlgorithmChoice choice;
  const SeededFault* fault = nullptr;
};

/// Which share of the bound counts.
enum class Measure { side, x, y, z, volume };
enum class Against { theorem, instance };
struct RatioRule {
  Measure measure = Measure::side;  ///< side: the axis of the largest share
  Against against = Against::theorem;
};

/// One graph drawn and judged.
struct Trial {
  Graph graph;
  std::array<std::int64_t, 3> extents{};
  std::array<double, 3> bound{};
  /// extent / bound; for volume the product of (extent + 1) / (bound + 1). 0 without a positive
  /// bound.
  double ratio = 0;
  std::string failure;  ///< kind of the first violation, "internal_error", or empty: proved right
  std::string message;  ///< of the failure
};

/// @throws InputError if the graph lies outside the guarantee.
Drawing draw_subject(const Subject& subject, const Graph& graph);

/// Draws and certifies; a broken invariant of the algorithm is a failure like a violation.
/// @throws InputError as above, and if the rule asks for an instance's bound and there is none.
Trial try_graph(const Subject& subject, const RatioRule& rule, Graph graph);

}  // namespace ar3d
