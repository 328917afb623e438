#pragma once

#include <memory>

#include "ar3d/bench/run/making.h"
#include "ar3d/bench/run/row_source.h"

namespace ar3d {

/// The second phase of a study: round after round over all drawings, one repetition of each a
/// round, so that what disturbs the machine for a while disturbs all alike. The first row of a
/// drawing is certified, the others must be the same drawing (its hash) and take over the
/// certificate.
std::unique_ptr<RowSource> timing_source(Making& making);

}  // namespace ar3d
