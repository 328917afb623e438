#pragma once

#include <nlohmann/json_fwd.hpp>

#include "ar3d/store/columns/curves.h"

namespace ar3d {

/// The number, or null if it is not finite.
nlohmann::ordered_json json_number(double value);

/// algorithm, options (with the level), family, parameters: the first columns of every table.
nlohmann::ordered_json key_json(const CurveKey& key);

}  // namespace ar3d
