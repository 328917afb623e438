#pragma once

// The phases of a study, one after the other; make_rows goes through them.

#include <memory>

#include "ar3d/bench/run/making.h"
#include "ar3d/bench/run/row_source.h"

namespace ar3d {

/// Metrics: every instance in one worker, its drawings certified, repetitions in the outer loop.
std::unique_ptr<RowSource> metrics_source(Making& making);

/// Timing: round after round over all drawings, one repetition of each a round, so that what
/// disturbs the machine for a while disturbs all alike. The first row of a drawing is certified,
/// the others must be the same drawing (its hash) and take over the certificate.
std::unique_ptr<RowSource> timing_source(Making& making);

/// Strong and weak scaling: batches of the same drawing shared by 1, ... threads or ranks. The
/// ideal of a batch is the one on a single thread or rank of the same round: its time divided by
/// how many share (strong) or its time (weak). Threads are pinned, each to a core of its own, if
/// there are so many; ranks stay where mpirun has put them.
void run_batches(Making& making);

}  // namespace ar3d
