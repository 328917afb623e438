#pragma once

#include <memory>
#include <vector>

#include "ar3d/bench/run/session.h"

namespace ar3d {

/// Half the width of the 95 % confidence interval of the median, divided by the median. The
/// interval lies between two order statistics, from the binomial distribution: it holds for any
/// continuous distribution. Infinite for fewer than six values (no such interval) or a median that
/// is not positive.
double median_precision(std::vector<double> values);

/// The first phase of a study: every instance in one worker, its drawings certified, repetitions in
/// the outer loop.
std::unique_ptr<RowSource> metrics_source(StudySession& session);

/// The second phase of a study: round after round over all drawings, one repetition of each a
/// round, so that what disturbs the machine for a while disturbs all alike. The first row of a
/// drawing is certified, the others must be the same drawing (its hash) and take over the
/// certificate.
std::unique_ptr<RowSource> timing_source(StudySession& session);

}  // namespace ar3d
