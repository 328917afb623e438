#pragma once

#include "ar3d/verify/metrics/metrics.h"

namespace ar3d {

/// Adds a row to the table, for programs that bring metrics of their own: before anything else uses
/// it, by one thread. @throws InputError if the name is taken or empty, or there is no function.
void register_metric(Metric row);

}  // namespace ar3d
