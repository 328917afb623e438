#pragma once

#include <memory>
#include <span>

#include "ar3d/bench/run/session.h"

namespace ar3d {

/// Returns whether there are rounds enough: how far the median of the first half of the values is
/// from that of the second (of an even number the upper one). Infinite for fewer than two.
double halves_difference(std::span<const double> values);

/// The first phase of a study: every instance in one worker, its drawings certified, repetitions in
/// the outer loop.
std::unique_ptr<RowSource> metrics_source(StudySession& session);

/// The second phase of a study: round after round over all drawings, one repetition of each a
/// round, so that what disturbs the machine for a while disturbs all alike: of a row of this phase
/// `repetition` is the round. Optional rounds are made until in 95 % of the drawings that have some
/// left halves_difference() of their times (log_corrected_time) is at most the precision. The first
/// row of a drawing is certified, the others must be the same drawing (its hash) and take over the
/// certificate.
std::unique_ptr<RowSource> timing_source(StudySession& session);

}  // namespace ar3d
