#pragma once

#include <functional>

#include "ar3d/bench/run/session.h"

namespace ar3d {

/// Returns what makes a rank's part of a batch ready, for Ranks::help on all ranks but the first.
/// @param plan  the same on every rank; outlives what is returned.
/// @param stop  asked before every drawing of this process, by several threads at once; once it is
/// true, a batch has rows that were not drawn.
MakeReady batch_parts(const StudyPlan& plan, int rank, const std::function<bool()>& stop);

/// Makes the last phase of a study, strong and weak scaling. Whoever shares a batch draws its
/// warm-ups first, then all begin at the same time; rows are hashed once the clock has stopped. The
/// ideal of a batch is the one on a single thread or rank of the same round: its time divided by
/// how many share (strong) or its time (weak).
void run_batches(StudySession& session);

}  // namespace ar3d
