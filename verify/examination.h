#pragma once

#include <string>

#include "ar3d/model/drawing.h"
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

/// Fills in what a summary says of angles: between consecutive segments of an edge, and between any
/// two segments that leave a vertex. Segments of length zero have none. Optimal edges are those all
/// of whose angles, at their bends and at both ends, are at least the optimum: 120 degrees in
/// drawings of maximum degree up to 3, arccos(-1/3) of maximum degree 4 (the paper's introduction).
/// That is decided exactly. Larger degrees have no known optimum.
/// @pre every coordinate is in range.
/// Cost: O(m + bends) time and, for degree d, O(d^2) up to 64, above about O(d^1.5) where
/// directions are spread (an angle below 10^-5 degrees at such a vertex may stand for a smaller
/// one); 32 bytes per edge.
void set_angles(const Drawing& drawing, DrawingSummary& summary);

/// Fills in what a summary says of angles and crossings. A valid certificate that all angles are
/// exactly the optimum says which there are, in O(1); else they are measured. Crossings are counted
/// if the certificate is exact and its list complete.
/// @param guarantee  that the certificate is of.
void set_angles_and_crossings(const Graph& graph, const Drawing& drawing,
                              const Guarantee& guarantee, const Certificate& certificate,
                              DrawingSummary& summary);

}  // namespace ar3d
