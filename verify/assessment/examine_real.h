#pragma once

#include "ar3d/verify/checks/examination.h"

namespace ar3d::verify {

/// examine() of a drawing in a real type: its metrics are those of the exact points, the box
/// rounded outwards to integers. Violations are what rounding cannot excuse: another graph, too
/// many bends, and, if the guarantee is no Claim::measured, that the drawing is in a real type at
/// all.
Examination examine_real(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee,
                         const ExaminationParts& parts, const CertifyOptions& options);

/// measure() of a drawing in a real type.
DrawingSummary measure_real(const Drawing& drawing);

}  // namespace ar3d::verify
