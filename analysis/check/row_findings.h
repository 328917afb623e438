#pragma once

#include <cstddef>
#include <vector>

#include "ar3d/analysis/check.h"

namespace ar3d {

/// What the row alone tells: certificate, numbers that every ok row has, extents against bounds.
std::vector<Finding> row_findings(const RunRecord& run, std::size_t row);

}  // namespace ar3d
