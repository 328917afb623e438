#pragma once

#include "ar3d/bench/run/making.h"

namespace ar3d {

/// @throws InputError if the plan has timed rows and this build's times are worth little, if a
/// memory limit is asked of a sanitised build, or if there are fewer cores than timed drawings at
/// the same time, or fewer ranks than are to share a batch.
void require_makeable(const StudyPlan& plan, const MakingPolicy& policy);

/// Makes the rows of a plan that the sink does not have, phase after phase: metrics, timing, strong
/// and weak scaling; keeps none of them. What goes wrong with a row is its status. In strong and
/// weak batches rows are not isolated; they are only made of drawings that came out before.
/// @throws InputError as require_makeable; whatever the sink throws.
MakingEnd make_rows(const StudyPlan& plan, const MakingPolicy& policy, RowSink& sink);

}  // namespace ar3d
