#pragma once

#include <cstddef>
#include <vector>

#include "ar3d/analysis/check.h"

namespace ar3d {

/// True if the row's drawing was judged by another certificate than exact and is not violated:
/// nothing proves it.
bool is_unproved(const RunRecord& run);

/// What the row alone tells: certificate, numbers that every ok row has, extents against bounds.
std::vector<Finding> row_findings(const RunRecord& run, std::size_t row);

}  // namespace ar3d
