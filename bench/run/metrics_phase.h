#pragma once

#include <memory>

#include "ar3d/bench/run/making.h"
#include "ar3d/bench/run/row_source.h"

namespace ar3d {

/// The first phase of a study: every instance in one worker, its drawings certified, repetitions in
/// the outer loop.
std::unique_ptr<RowSource> metrics_source(Making& making);

}  // namespace ar3d
