#pragma once

#include <string>

#include "ar3d/verify/certificate.h"
#include "ar3d/verify/metrics/metrics.h"

namespace ar3d {

/// Holds which parts of an examination are wanted; the others are left empty and cost nothing.
struct ExaminationParts {
  bool certificate = true;
  bool metrics = true;
  bool hash = true;
};

/// Holds certificate, metrics and hash of one drawing.
struct Examination {
  Certificate certificate;
  DrawingSummary summary;    ///< metric_values(summary) are the metrics
  std::string drawing_hash;  ///< as of drawing_hash()
  double certify_s = 0;      ///< wall time of the proof, or of the assessment in a real type
  double metrics_s = 0;      ///< wall time of summary and hash, which threads make beside the proof
};

/// certify(), measure() and drawing_hash() together: every polyline is computed once for all of
/// them. The wanted parts are equal to what those functions give.
/// @throws InputError if metrics are wanted and the drawing's Gram matrix is not positive definite.
Examination examine(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee,
                    const ExaminationParts& parts = {}, const CertifyOptions& options = {});

}  // namespace ar3d
