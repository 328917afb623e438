#pragma once

#include <cstddef>

#include "ar3d/store/columns/table.h"

namespace ar3d {

// What a results file says of itself in its root attributes.
inline constexpr const char* kResultsFormat = "ar3d-results";
inline constexpr long long kResultsFormatVersion = 3;

/// /environments: session, name and value, as wide as they are.
TableSpec environments_table(std::size_t name_size, std::size_t value_size);

}  // namespace ar3d
