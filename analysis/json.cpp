// JSON has neither NaN nor infinity, so a number that is not finite becomes null. Texts come from
// files and are made valid UTF-8 first.
#include "ar3d/analysis/json.h"

#include <nlohmann/json.hpp>

#include "ar3d/base/printable.h"

namespace ar3d {

nlohmann::ordered_json json_number(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json key_json(const CurveKey& key) {
  return {{"algorithm", valid_utf8(key.algorithm)},
          {"options", valid_utf8(options_and_level(key))},
          {"family", valid_utf8(key.family)},
          {"parameters", valid_utf8(key.parameters)}};
}

}  // namespace ar3d
